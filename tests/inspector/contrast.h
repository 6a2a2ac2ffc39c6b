// SPDX-License-Identifier: MIT
// The contrast of two colours, WCAG 2.1.
#pragma once

#include <QColor>

#include <algorithm>
#include <cmath>

namespace support {

// Relative luminance of an sRGB colour.
inline double luminanceOf(const QColor &colour) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

inline double contrastOf(const QColor &one, const QColor &other) {
    const auto [darker, lighter] = std::minmax({luminanceOf(one), luminanceOf(other)});
    return (lighter + 0.05) / (darker + 0.05);
}

} // namespace support
