// SPDX-License-Identifier: MIT
// A scene, a start and the board's tilts: all inputs of a run, as a readable text that a test replays.
#pragma once

#include "integrator/vector.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace witness {

/// This many steps of dt under one gravity.
struct Leg {
    phys_vec3 gravity;
    double dt;
    uint32_t steps;
};

/// The ball's expected state at a time, to more digits than a double has.
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
    std::string stepper; ///< for which it failed; empty: all
    std::string check;   ///< that failed; empty: all
    std::vector<phys_box> boxes;
    double radius = 0.006;
    phys_params params{}; ///< without gravity
    phys_state start{};
    std::vector<Leg> legs;
    std::vector<Sample> samples;

    double duration() const;
    uint64_t stepCount() const;
};

Case emptyCase();

/// boxes: must outlive the description.
phys_scene_desc descOf(const std::vector<phys_box> &boxes, double radius, const phys_vec3 &start);

std::string textOf(const Case &scene);

/// All cases of a file. Throws std::runtime_error with file and line.
std::vector<Case> readCases(const std::string &path);

} // namespace witness
