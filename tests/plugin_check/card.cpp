// SPDX-License-Identifier: MIT
#include "card.h"

#include <array>
#include <cstdio>

namespace plugin_check {

namespace {

constexpr Part kParts[] = {
    {"smooth motion", smoothMotion},
    {"across impacts", impacts},
    {"invariants", invariants},
    {"the law", law},
    {"energy at rest", energyAtRest},
    {"energy a bounce", energyPerBounce},
    {"tunnelling", tunnelling},
    {"threads", threads},
    {"reports", reports},
    {"memory", memory},
    {"small stack", smallStack},
    {"extremes", extremes},
    {"misuse", misuse},
    {"cost", cost},
};

} // namespace

std::span<const Part> parts() { return kParts; }

std::string lineOf(const char *name, const Measure &measure) {
    std::array<char, 32> begin{};
    std::snprintf(begin.data(), begin.size(), "%-5s %-16s ", measure.isWrong ? "FAIL" : "ok", name);
    return begin.data() + measure.text;
}

} // namespace plugin_check
