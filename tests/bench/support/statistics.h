// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace bench {

// Of at least one value.
double median(std::vector<double> values);

// Between the first and the third quartile, relative to the median.
double relativeSpread(std::vector<double> values);

} // namespace bench
