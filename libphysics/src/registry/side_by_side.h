// SPDX-License-Identifier: MIT
// The balls of a batch, as many at a time as there are lanes: each makes its steps in its lane where possible,
// otherwise alone. When one is done, the next one takes its lane.
#pragma once

#include "registry/ball_run.h"
#include "registry/lanes.h"

#include <array>

namespace phys {

/// The progress of the balls.
class Outcome {
public:
    Outcome(const phys_batch &batch, phys_error *err)
        : m_batch(batch)
        , m_err(err) {}

    void add(const BallRun &run);
    /// The error of the failed ball with the lowest number, if there are no statuses to report it.
    phys_status status() const { return m_status; }

private:
    const phys_batch &m_batch;
    phys_error *m_err;
    phys_status m_status = PHYS_OK;
    uint64_t m_failed = UINT64_MAX; ///< the number of that ball
};

class SideBySide {
public:
    /// steps: nullptr if there are no lanes.
    SideBySide(phys_stepper &stepper, const phys_batch &batch, const LaneSteps *steps, bool paramsAreChecked,
               Outcome &outcome);

    /// Runs the balls of the numbers first .. end - 1.
    void run(uint64_t first, uint64_t end);

private:
    /// A ball and its clock. Lanes count their common steps in ticks.
    struct Slot {
        BallRun ball;
        uint64_t entered = 0; ///< the number of the ball's steps when it entered the lane
        uint64_t ticks = 0;   ///< those that had passed then
    };

    bool isInLane(uint32_t lane) const { return m_inLanes >> lane & 1U; }
    uint64_t stepsOf(const Slot &slot) const { return slot.entered + (m_ticks - slot.ticks); }
    void fill(uint32_t lane);
    bool mayShareLanes(const BallRun &ball);
    void runAlone(uint32_t lane, uint64_t step, decltype(&makeStep) make);
    void finish(BallRun &ball);
    bool enter(uint32_t lane, uint64_t step);
    phys_state stateInLane(uint32_t lane) const;
    void leave(uint32_t lane);
    void moveInLanes();
    void loadGravity();
    void tilt(uint32_t lane);
    uint32_t stopInLanes();

    phys_stepper &m_stepper;
    const phys_batch &m_batch;
    const LaneSteps *m_steps;
    bool m_paramsAreChecked;
    Outcome &m_outcome;
    uint64_t m_next = 0, m_end = 0; ///< the balls that haven't begun
    Lanes m_lanes{};
    std::array<Slot, kLaneCount> m_slots{};
    std::array<const phys_vec3 *, kLaneCount> m_gravity{}; ///< of the next step in each lane
    bool m_hasBegun = false;
    uint32_t m_inLanes = 0; ///< a bit for each lane that has a ball
    uint64_t m_ticks = 0;
    uint64_t m_nextStop = UINT64_MAX; ///< the ticks until a ball in a lane comes to a stop
};

} // namespace phys
