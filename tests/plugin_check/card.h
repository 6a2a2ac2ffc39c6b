// SPDX-License-Identifier: MIT
// The lines of the report card.
#pragma once

#include "measures.h"

#include <span>

namespace plugin_check {

struct Part {
    const char *name;
    Measure (*measure)(const Subject &);
    int seconds; ///< that it may take, most of which its own calculations take if there are many
    int steps;   ///< that it lets the stepper make, about
};

/// In the order of the card, after its first two lines, contract and cost: the shortest part first.
std::span<const Part> parts();

std::string lineOf(const char *name, const Measure &measure);

} // namespace plugin_check
