// SPDX-License-Identifier: MIT
// What a sweep is to compute: the product of five lists, each combination a job with a number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sweep {

struct Job {
    std::string level, stepper;
    double friction;    ///< rolling friction
    double restitution; ///< of walls
    double dt;          ///< s
};

struct Plan {
    std::vector<std::string> levels, steppers;
    std::vector<double> frictions{0.002}, restitutions{0.5}, dts{0.01};
    std::vector<std::string> plugins;
    double seconds = 5.0;
    std::string file; ///< of the CSV

    uint64_t jobCount() const;
    /// number below jobCount(); the level changes slowest, dt fastest.
    Job job(uint64_t number) const;
};

/// Throws std::invalid_argument with one line if the arguments are not those of `usage`.
Plan readPlan(int argc, char **argv);

extern const char *const usage;

} // namespace sweep
