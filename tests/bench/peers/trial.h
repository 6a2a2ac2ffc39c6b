// SPDX-License-Identifier: MIT
// The measurements: each engine at each step size in each scene, cost and error.
#pragma once

#include "peers/engine.h"

#include <functional>
#include <string>
#include <vector>

namespace bench {

// Scenes that ask the same question; their errors are summarised together.
struct SceneGroup {
    std::string name;
    std::string question;
    std::vector<Scene> scenes;
};

std::vector<SceneGroup> allGroups();

// Errors are distances to the reference, in radii.
struct SceneError {
    double final = 0;    // at the end
    double largest = 0;  // at the ends of all tilt periods
    Ball last;           // where the ball was at the end
    std::string failure; // why there is no answer; empty if there is one
};

struct Trial {
    std::string group;
    std::string engine;
    bool ours = false;
    double dt = 0;                  // s, as asked for
    double secondsPerStep = 0;      // CPU
    double secondsPerSimulated = 0; // CPU, for each second of simulated time
    double spread = 0;              // of the repeats: the middle half, relative to the median
    std::vector<SceneError> errors; // one for each scene of the group
    std::string skipped;            // why it wasn't run; empty if it was

    bool answered() const;
    double medianLargest() const; // of errors' `largest`
    double worstLargest() const;
};

using Progress = std::function<void(const std::string &)>;

std::vector<Trial> measure(const std::vector<SceneGroup> &groups, const std::vector<EngineKind> &engines,
                           const Progress &progress);

} // namespace bench
