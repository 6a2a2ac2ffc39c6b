// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/view/quality_chooser.h"

#include <algorithm>

namespace inspector::gl {

namespace {

constexpr int kPictures = 8;      ///< pictures per decision
constexpr double kSlow = 16.0;    ///< ms; less than 60 pictures a second
constexpr double kVeryFast = 3.0; ///< ms; a better quality takes up to four times as long

} // namespace

void QualityChooser::use(Quality quality) {
    m_quality = quality;
    m_count = 0;
}

void QualityChooser::note(double milliseconds) {
    m_fastest = m_count == 0 ? milliseconds : std::min(m_fastest, milliseconds);
    m_slowest = m_count == 0 ? milliseconds : std::max(m_slowest, milliseconds);
    if (++m_count < kPictures) return;
    m_count = 0;
    if (m_fastest > kSlow && m_quality != Quality::Low) {
        m_isLimit = true;
        use(Quality(int(m_quality) - 1));
    } else if (m_slowest < kVeryFast && m_quality != Quality::High && !m_isLimit) {
        use(Quality(int(m_quality) + 1));
    }
}

} // namespace inspector::gl
