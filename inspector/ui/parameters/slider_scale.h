// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <physics/physics.h>

namespace inspector::ui {

/// Maps slider positions to values: linear, or logarithmic where a row spans decades. A notch is kFine positions, so
/// that values between two notches can be set.
class SliderScale {
public:
    static constexpr int kFine = 10;

    explicit SliderScale(const phys_param_row &row);

    int last() const { return m_last; } ///< position of row.high; that of row.low is 0
    int placeOf(double value) const;    ///< the nearest position; clamped to the ends
    double valueAt(int place) const;    ///< rounded to few digits

private:
    double m_low, m_high;
    bool m_isLogarithmic;
    int m_last;
};

} // namespace inspector::ui
