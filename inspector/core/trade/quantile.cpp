// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/quantile.h"

#include <algorithm>
#include <cstddef>

namespace inspector {

double quantile(const std::vector<double> &sorted, double share) {
    const double place = share * double(sorted.size() - 1);
    const auto below = size_t(place);
    const size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - double(below)) * (sorted[above] - sorted[below]);
}

} // namespace inspector
