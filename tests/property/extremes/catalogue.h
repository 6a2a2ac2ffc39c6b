// SPDX-License-Identifier: MIT
// The extreme cases of model.md 11, and the outcome of each under each stepper.
#pragma once

#include "support/random.h"

#include <QByteArray>

#include <cstdint>
#include <functional>
#include <vector>

namespace extremes {

/// The outcome: a phrase of the case, or the name of the status with which the step failed.
struct Outcome {
    QByteArray text;
    QByteArray problem; ///< a forbidden outcome that occurred; empty if there was none
};

/// One trial of a case.
struct Trial {
    QByteArray stepper;
    uint32_t model;
    support::Random &draw; ///< draws all that the case leaves open: positions, directions, speeds, tilts, step sizes
};

struct Extreme {
    QByteArray name;
    std::function<Outcome(const Trial &trial)> run;
    std::function<QByteArray(const QByteArray &stepper, uint32_t model)> expected; ///< outcomes that are allowed
    uint32_t cost = 1; ///< factor by which fewer draws are made
};

std::vector<Extreme> contactExtremes(); ///< restitution, corners, gaps, many boxes
std::vector<Extreme> scaleExtremes();   ///< speeds, sizes, times, frictions, gravity

inline constexpr char kOr[] = " or "; ///< between outcomes

/// All outcomes of many draws: a single one if the case is deterministic.
Outcome overDraws(const Extreme &extreme, const QByteArray &stepper, uint32_t model);

/// Whether each outcome in `text` is one of those that are expected.
bool isExpected(const QByteArray &text, const QByteArray &expected);

/// All of them, in the order of the table.
std::vector<Extreme> allExtremes();

} // namespace extremes
