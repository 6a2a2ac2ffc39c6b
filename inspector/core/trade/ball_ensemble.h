// SPDX-License-Identifier: GPL-3.0-or-later
// An ensemble of balls on sampled boards, stepped by "exact" under the same tilts.
#pragma once

#include "core/setup/handles.h"
#include "core/trade/unknowns.h"

namespace inspector {

class BallEnsemble {
public:
    /// Each ball starts at `start` plus its board's offset, unless that is inside a wall, where no real ball could
    /// start. stepper: "exact", made for the scene. boards: at least one.
    BallEnsemble(Stepper stepper, const Scene &scene, const std::vector<SampledBoard> &boards, const phys_state &start);

    /// Replaces the boards, as many as before; the balls keep their states.
    void setBoards(const std::vector<SampledBoard> &boards);
    /// Makes `steps` steps of dt under a tilt. A ball that left the maze stays where it left it.
    void step(const Tilt &tilt, double dt, uint64_t steps);

    const phys_vec3 &centre(size_t ball) const { return m_balls[ball].state.position; }
    /// The distance of each ball from this point, m; NaN once "exact" has refused it.
    std::vector<double> distancesFrom(const phys_vec3 &centre) const;
    int refused() const;

private:
    struct Ball {
        SampledBoard board;
        phys_state state;
        bool isRefused = false;
    };

    Stepper m_stepper;
    std::vector<Ball> m_balls;
    std::vector<phys_status> m_statuses;
};

} // namespace inspector
