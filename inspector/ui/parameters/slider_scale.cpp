// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameters/slider_scale.h"

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kDecades = 3.0; ///< from this range on logarithmic
constexpr double kNotchesPerDecade = 20.0;
constexpr double kMostNotches = 10000.0;

/// Rounds to `digits` significant digits: 0.3, not 0.30000000000000004.
double withDigits(double value, int digits) {
    if (value == 0.0) return 0.0;
    const int before = int(std::floor(std::log10(std::abs(value)))) + 1;
    const double scale = std::pow(10.0, std::abs(digits - before));
    return digits >= before ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

} // namespace

SliderScale::SliderScale(const phys_param_row &row)
    : m_low(row.low)
    , m_high(row.high)
    , m_isLogarithmic(row.low > 0.0 && std::log10(row.high / row.low) >= kDecades) {
    const double notches =
        m_isLogarithmic ? kNotchesPerDecade * std::log10(m_high / m_low) : (m_high - m_low) / row.step;
    m_last = kFine * int(std::clamp(std::round(notches), 1.0, kMostNotches));
}

int SliderScale::placeOf(double value) const {
    const double inside = std::clamp(value, m_low, m_high);
    const double share =
        m_isLogarithmic ? std::log(inside / m_low) / std::log(m_high / m_low) : (inside - m_low) / (m_high - m_low);
    return int(std::lround(share * m_last));
}

double SliderScale::valueAt(int place) const {
    if (place <= 0) return m_low;
    if (place >= m_last) return m_high;
    const double share = double(place) / m_last;
    if (m_isLogarithmic) return withDigits(m_low * std::pow(m_high / m_low, share), 4);
    // The digits of the finest step, relative to the largest value, so that 1e-12 is treated like 1.
    const double value = m_low + (m_high - m_low) * share;
    const double unit = std::pow(10.0, std::floor(std::log10((m_high - m_low) / m_last)) - 2.0);
    return withDigits(std::round(value / unit) * unit, 12);
}

} // namespace inspector::ui
