// SPDX-License-Identifier: MIT
// The extreme cases of model.md 11, and what comes out of each under each stepper.
#pragma once

#include "support/random.h"

#include <QByteArray>

#include <cstdint>
#include <functional>
#include <vector>

namespace extremes {

/// What was seen: a phrase of the case, or the name of the status that refused it.
struct Outcome {
    QByteArray text;
    QByteArray problem; ///< what must never happen and did; empty if nothing
};

/// What a case is tried with, once.
struct Trial {
    QByteArray stepper;
    uint32_t model;
    support::Random &draw; ///< of all that the case leaves open: places, directions, speeds, tilts, step sizes
};

struct Extreme {
    QByteArray name;
    std::function<Outcome(const Trial &trial)> run;
    std::function<QByteArray(const QByteArray &stepper, uint32_t model)> expected; ///< outcomes that there may be
    uint32_t cost = 1;                                                             ///< so many times fewer draws
};

std::vector<Extreme> contactExtremes(); ///< restitution, corners, gaps, many boxes
std::vector<Extreme> scaleExtremes();   ///< speeds, sizes, times, frictions, gravity

inline constexpr char kOr[] = " or "; ///< between outcomes

/// All outcomes that many draws have: one, where the case is decided.
Outcome overDraws(const Extreme &extreme, const QByteArray &stepper, uint32_t model);

/// Whether each outcome of `text` is one of those that are expected.
bool isExpected(const QByteArray &text, const QByteArray &expected);

/// All of them, in the order of the table.
std::vector<Extreme> allExtremes();

} // namespace extremes
