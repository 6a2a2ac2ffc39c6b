// SPDX-License-Identifier: MIT
// Balls of a batch that make their steps together: in lanes where possible, otherwise one at a time.
#pragma once

#include "registry/ball_run.h"
#include "registry/lanes.h"

#include <array>
#include <span>

namespace phys {

class SideBySide {
public:
    static constexpr uint32_t kMost = kLaneCount;

    /// steps: nullptr if there are no lanes.
    SideBySide(const phys_stepper &stepper, const phys_batch &batch, const LaneSteps *steps, bool paramsAreChecked);

    /// At most kMost balls.
    void add(uint64_t number);
    void run();
    std::span<const BallRun> balls() const { return {m_balls.data(), m_count}; }

private:
    bool isInLane(uint32_t ball) const { return m_inLanes >> ball & 1U; }
    void enter(uint32_t ball, uint64_t step);
    phys_state stateInLane(uint32_t ball, uint64_t step) const;
    void leave(uint32_t ball, uint64_t step);
    void loadGravity(uint64_t step);
    uint32_t moveInLanes(uint64_t step);
    void moveAlone(uint32_t ball, uint64_t step, decltype(&makeStep) make);

    const phys_stepper &m_stepper;
    const phys_batch &m_batch;
    const LaneSteps *m_steps;
    bool m_paramsAreChecked;
    Lanes m_lanes;
    std::array<BallRun, kMost> m_balls;
    uint32_t m_count = 0;
    std::array<const phys_vec3 *, kMost> m_gravity{}; ///< of each ball's first step
    std::array<uint64_t, kMost> m_entered{};          ///< the step before which each ball entered its lane
    uint32_t m_inLanes = 0, m_running = 0;            ///< a bit for each ball
};

} // namespace phys
