// SPDX-License-Identifier: MIT
// Numerical stability as pictures, from the library as it is: each function draws one into a folder.
#pragma once

#include <filesystem>

namespace bench {

// Energy over time of a ball that bounces on a wall and of one that rests against it. Returns false without gnuplot.
bool drawEnergy(const std::filesystem::path &folder);

// What becomes of a ball that hits a thin wall head-on, by speed, step size and thickness, beside the prediction.
bool drawTunnelling(const std::filesystem::path &folder);

// Error against step size, with slopes, in smooth motion and across impacts.
bool drawConvergence(const std::filesystem::path &folder);

} // namespace bench
