// SPDX-License-Identifier: MIT
// Pictures of numerical stability; each function draws one into a folder.
#pragma once

#include <filesystem>

namespace bench {

// Energy over time of a ball that bounces on a wall and of one that rests against it. Returns false without gnuplot.
bool drawEnergy(const std::filesystem::path &folder);

// The outcome of a head-on impact on a thin wall, by speed, step size and thickness, beside the prediction.
bool drawTunnelling(const std::filesystem::path &folder);

// Error against step size, with slopes, in smooth motion and across impacts.
bool drawConvergence(const std::filesystem::path &folder);

} // namespace bench
