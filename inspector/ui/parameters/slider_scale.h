// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <physics/physics.h>

namespace inspector::ui {

// Which values the places of a slider stand for: equally far apart, or by equal ratios where a row spans decades. A
// notch is kFine places, so that a value between two notches can be had.
class SliderScale {
public:
    static constexpr int kFine = 10;

    explicit SliderScale(const phys_param_row &row);

    int last() const { return m_last; } // of row.high; that of row.low is 0
    int placeOf(double value) const;    // the nearest; the ends for what lies beyond them
    double valueAt(int place) const;    // with few digits

private:
    double m_low, m_high;
    bool m_isLogarithmic;
    int m_last;
};

} // namespace inspector::ui
