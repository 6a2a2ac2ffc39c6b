// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/frame.h"

namespace inspector::gl {

/// Finds the best quality that is drawn in time, based on drawing times.
class QualityChooser {
public:
    explicit QualityChooser(Quality first)
        : m_quality(first) {}

    Quality quality() const { return m_quality; }
    /// Reports a picture fully drawn in this quality. A single slow picture changes nothing.
    void note(double milliseconds);

private:
    void use(Quality quality);

    Quality m_quality;
    bool m_isLimit = false; ///< better qualities are too slow
    int m_count = 0;        ///< pictures in this quality
    double m_fastest = 0.0; ///< ms, of these pictures
    double m_slowest = 0.0;
};

} // namespace inspector::gl
