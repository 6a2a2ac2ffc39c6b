// SPDX-License-Identifier: MIT
// A scene, a start and what the board does: all that a run needs, as a text that people read and a test replays.
#pragma once

#include "integrator/vector.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace witness {

/// So many steps of dt under one gravity.
struct Leg {
    phys_vec3 gravity;
    double dt;
    uint32_t steps;
};

/// Where the ball must be at a time, to more digits than a double has.
struct Sample {
    Real time;
    Vector place;
    Vector velocity;
    Vector spin;
    bool isAtRest;
};

struct Case {
    std::string name;
    std::string note;    ///< what is expected, and why
    std::string stepper; ///< that failed; empty: all
    std::string check;   ///< that failed; empty: all
    std::vector<phys_box> boxes;
    double radius = 0.006;
    phys_params params{}; ///< but gravity
    phys_state start{};
    std::vector<Leg> legs;
    std::vector<Sample> samples;

    double duration() const;
    uint64_t stepCount() const;
};

Case emptyCase();

std::string textOf(const Case &scene);

/// All cases of a file. Throws std::runtime_error with file and line.
std::vector<Case> readCases(const std::string &path);

} // namespace witness
