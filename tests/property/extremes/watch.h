// SPDX-License-Identifier: MIT
// Steps a ball and checks after each step for outcomes that are never allowed.
#pragma once

#include "catalogue.h"

#include "support/experiment.h"

#include <QByteArray>

namespace extremes {

class Watch {
public:
    explicit Watch(support::Experiment &ball)
        : m_ball(ball) {}

    /// Steps `count` times, or until a step fails or something forbidden happens; then returns false.
    bool step(uint64_t count, double dt);

    /// The name of the status with which a step failed; empty if none did.
    QByteArray refusal() const { return m_refusal; }

    /// A forbidden outcome that occurred: a NaN, a ball inside a wall, a state changed by a failed step; empty if there
    /// was none.
    QByteArray problem() const { return m_problem; }

private:
    void inspect();

    support::Experiment &m_ball;
    QByteArray m_refusal;
    QByteArray m_problem;
};

/// The case's phrase, unless a step failed.
inline Outcome outcome(const Watch &watch, const QByteArray &phrase) {
    return {watch.refusal().isEmpty() ? phrase : watch.refusal(), watch.problem()};
}

/// Largest penetration that rounding explains: the library's tolerance is 4 roundings of the largest coordinate, and
/// pushing out adds a few more.
double roundingDepth(const phys_scene *scene, const phys_state &state);

/// The ball's depth in the deepest box that rises above z = 0, m; 0 outside of all. Boxes that end below are floor,
/// whose edge a ball overlaps while it leaves the floor: model.md 7.
double depthOf(const phys_scene *scene, const phys_state &state);

} // namespace extremes
