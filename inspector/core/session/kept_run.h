// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/inputs.h"
#include "core/setup/levels.h"
#include "core/simulation/departure.h"

#include <utility>
#include <vector>

namespace inspector {

/// A run in the history, from a start, a restart or the moment at which it was taken over.
struct KeptRun {
    uint64_t begin = 0; ///< place, as in Past
    uint64_t end = 0;
    Level level;
    uint64_t maze = 0;                               ///< hash of its file's bytes
    std::vector<std::pair<QByteArray, double>> pace; ///< id of the stepper and dt, s, in their order
    Inputs first = initialInputs();                  ///< of its first step
    Inputs last = initialInputs();                   ///< of its last step so far
    double time = 0.0;                               ///< s, until the ball left the maze; else at its end
    BoardSide side = BoardSide::Within;              ///< where it left
};

} // namespace inspector
