// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace bench {

// `values` has at least one.
double median(std::vector<double> values);

// Between the first and the third quartile, relative to the median.
double relativeSpread(std::vector<double> values);

} // namespace bench
