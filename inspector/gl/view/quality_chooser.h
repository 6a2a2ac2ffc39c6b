// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/frame.h"

namespace inspector::gl {

// The best quality that is drawn in time here, found by what pictures take.
class QualityChooser {
public:
    explicit QualityChooser(Quality first)
        : m_quality(first) {}

    Quality quality() const { return m_quality; }
    // A picture of this quality that was drawn as a whole. One that is slow for another reason decides nothing.
    void note(double milliseconds);

private:
    void use(Quality quality);

    Quality m_quality;
    bool m_isLimit = false; // better ones are too slow
    int m_count = 0;        // of pictures in this quality
    double m_fastest = 0.0; // ms; of those
    double m_slowest = 0.0;
};

} // namespace inspector::gl
