// SPDX-License-Identifier: MIT
// The extreme cases of model.md 11, and what comes out of each under each stepper.
#pragma once

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

struct Extreme {
    QByteArray name;
    std::function<Outcome(const QByteArray &stepper, uint32_t model)> run;
    std::function<QByteArray(const QByteArray &stepper, uint32_t model)> expected;
};

std::vector<Extreme> contactExtremes(); ///< restitution, corners, gaps, many boxes
std::vector<Extreme> scaleExtremes();   ///< speeds, sizes, times, frictions, gravity

/// All of them, in the order of the table.
std::vector<Extreme> allExtremes();

} // namespace extremes
