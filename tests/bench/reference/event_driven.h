// SPDX-License-Identifier: MIT
// The reference of the comparison, computed by another method than that of stepper `exact`: the frictionless ball moves
// on parabolas, and each impact is a root of a quadratic (faces) or a quartic (corners), in any precision.
#pragma once

#include "support/scene.h"

#include <vector>

namespace bench {

struct Passage {
    std::vector<Ball> balls; // at the end of each of the scene's tilt periods
    int impacts = 0;
};

// Throws std::runtime_error rather than returning a result that penetrates a wall. Real: double or long double.
template<class Real>
Passage eventDriven(const Scene &scene);

extern template Passage eventDriven<double>(const Scene &scene);
extern template Passage eventDriven<long double>(const Scene &scene);

// Growth of a small change of the start up to the end of each period: |change then| / |change at the start|.
std::vector<double> sensitivity(const Scene &scene);

} // namespace bench
