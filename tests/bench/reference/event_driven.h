// SPDX-License-Identifier: MIT
// The answer that everything is compared with, found another way than stepper `exact` finds it: the frictionless ball
// moves on parabolas, and each impact is a root of a quadratic (faces) or a quartic (corners), in any precision.
#pragma once

#include "support/scene.h"

#include <vector>

namespace bench {

struct Passage {
    std::vector<Ball> balls; // at the end of each of the scene's tilt periods
    int impacts = 0;
};

// Throws std::runtime_error rather than give an answer that penetrates a wall. Real: double or long double.
template<class Real>
Passage eventDriven(const Scene &scene);

extern template Passage eventDriven<double>(const Scene &scene);
extern template Passage eventDriven<long double>(const Scene &scene);

// How much a small change of the start has grown by the end of each period: |change then| / |change at the start|.
std::vector<double> sensitivity(const Scene &scene);

} // namespace bench
