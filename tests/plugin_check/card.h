// SPDX-License-Identifier: MIT
// The lines of the report card.
#pragma once

#include "measures.h"

#include <span>

namespace plugin_check {

struct Part {
    const char *name;
    Measure (*measure)(const Subject &);
};

/// In the order of the card, after its first line, the contract.
std::span<const Part> parts();

std::string lineOf(const char *name, const Measure &measure);

} // namespace plugin_check
