// SPDX-License-Identifier: MIT
#include "card.h"

#include <array>
#include <cstdio>

namespace plugin_check {

namespace {

constexpr Part kParts[] = {
    {"misuse", misuse, 3, 10},
    {"small stack", smallStack, 3, 10},
    {"extremes", extremes, 3, 20},
    {"energy a bounce", energyPerBounce, 3, 30},
    {"threads", threads, 3, 1000},
    {"energy at rest", energyAtRest, 3, 2000},
    {"tunnelling", tunnelling, 3, 2000},
    {"memory", memory, 3, 3000},
    {"reports", reports, 3, 3000},
    {"smooth motion", smoothMotion, 10, 6000},
    {"across impacts", impacts, 10, 12000},
    {"invariants", invariants, 25, 30000},
    {"the law", law, 60, 300000},
};

} // namespace

std::span<const Part> parts() { return kParts; }

std::string lineOf(const char *name, const Measure &measure) {
    std::array<char, 32> begin{};
    std::snprintf(begin.data(), begin.size(), "%-5s %-16s ",
                  measure.isWrong  ? "FAIL"
                  : measure.isOpen ? "open"
                                   : "ok",
                  name);
    return begin.data() + measure.text;
}

} // namespace plugin_check
