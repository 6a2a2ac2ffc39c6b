// SPDX-License-Identifier: MIT
// Steps a ball and looks, after each step, for what must never happen.
#pragma once

#include "catalogue.h"

#include "support/experiment.h"

#include <QByteArray>

namespace extremes {

class Watch {
public:
    explicit Watch(support::Experiment &ball)
        : m_ball(ball) {}

    /// Steps `count` times, or until a step is refused or something forbidden is seen; then returns false.
    bool step(uint64_t count, double dt);

    /// The name of the status that refused a step; empty if none did.
    QByteArray refusal() const { return m_refusal; }

    /// What must never happen and did: a NaN, a ball inside a wall, a state changed by a refused step; empty if
    /// nothing.
    QByteArray problem() const { return m_problem; }

private:
    void inspect();

    support::Experiment &m_ball;
    QByteArray m_refusal;
    QByteArray m_problem;
};

/// The case's phrase, unless a step was refused.
inline Outcome outcome(const Watch &watch, const QByteArray &phrase) {
    return {watch.refusal().isEmpty() ? phrase : watch.refusal(), watch.problem()};
}

/// Largest penetration that rounding explains: the library's tolerance is 4 roundings of the largest coordinate, and
/// pushing out rounds a few times more.
double roundingDepth(const phys_scene *scene, const phys_state &state);

/// How deep the ball is inside the deepest box that stands above z = 0, m; 0 outside of all. What ends below is floor,
/// whose edge a ball that leaves it passes: model.md 7.
double depthOf(const phys_scene *scene, const phys_state &state);

} // namespace extremes
