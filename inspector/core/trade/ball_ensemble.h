// SPDX-License-Identifier: GPL-3.0-or-later
// Balls on boards as they may really be, stepped by "exact" under the same tilts.
#pragma once

#include "core/setup/handles.h"
#include "core/trade/unknowns.h"

namespace inspector {

class BallEnsemble {
public:
    // At `start`, each moved by its board; but not into a wall: no board that was looked at starts there. stepper:
    // "exact", made for the scene. boards: at least one.
    BallEnsemble(Stepper stepper, const Scene &scene, const std::vector<SampledBoard> &boards, const phys_state &start);

    // The balls roll on, on these boards; as many as before.
    void setBoards(const std::vector<SampledBoard> &boards);
    // So many steps of dt under a tilt. A ball that is out stays where it left the maze.
    void step(const Tilt &tilt, double dt, uint64_t steps);

    const phys_vec3 &centre(size_t ball) const { return m_balls[ball].state.position; }
    // Of each ball from this place, m; NaN once "exact" couldn't step it.
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
