// SPDX-License-Identifier: MIT
#include "registry/side_by_side.h"

#include "base/error.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace phys {

namespace {

/// visit(lane) for each bit.
template<class Visit>
void each(uint32_t lanes, Visit visit) {
    for (; lanes; lanes &= lanes - 1) visit(static_cast<uint32_t>(std::countr_zero(lanes)));
}

} // namespace

void Outcome::add(const BallRun &run) {
    const uint64_t ball = run.number();
    if (m_batch.steps_done) m_batch.steps_done[ball] = run.stepsDone();
    if (m_batch.statuses) m_batch.statuses[ball] = run.status();
    if (run.status() == PHYS_OK || ball > m_failed || m_batch.statuses) return;
    m_failed = ball;
    phys_error reason;
    run.explain(reason);
    m_status = fail(m_err, run.status(), "ball %llu fails in step %llu: %s", static_cast<unsigned long long>(ball),
                    static_cast<unsigned long long>(run.stepsDone()), reason.text);
}

SideBySide::SideBySide(phys_stepper &stepper, const phys_batch &batch, const LaneSteps *steps, bool paramsAreChecked,
                       Outcome &outcome)
    : m_stepper(stepper)
    , m_batch(batch)
    , m_steps(steps)
    , m_paramsAreChecked(paramsAreChecked)
    , m_outcome(outcome) {}

void SideBySide::run(uint64_t first, uint64_t end) {
    m_next = first;
    m_end = end;
    while (m_next < m_end) {
        for (uint32_t lane = 0; lane < kLaneCount; ++lane) fill(lane);
        while (m_inLanes) moveInLanes();
    }
}

/// Runs balls until one of them is in the lane.
void SideBySide::fill(uint32_t lane) {
    for (; m_next < m_end && !isInLane(lane); ++m_next) {
        BallRun &ball = m_slots[lane].ball;
        ball = BallRun(m_stepper, m_batch, m_next, m_paramsAreChecked);
        if (m_steps && !mayShareLanes(ball)) return; // once the others are done
        if (!ball.isRunning())
            finish(ball);
        else if (!enter(lane, 0))
            runAlone(lane, 0, makeStep);
    }
}

/// Lanes are for balls with, or for balls without rolling friction.
bool SideBySide::mayShareLanes(const BallRun &ball) {
    const bool resists = ball.params().rolling_friction > 0.0;
    if (m_hasBegun && resists == m_lanes.resists) return true;
    if (m_inLanes) return false;
    m_steps->begin(m_stepper.self, ball.params(), m_batch.dt, m_lanes);
    m_hasBegun = true;
    return true;
}

/// Makes the step of this number, and further ones until the ball can enter the lane or is done. make: for the first.
void SideBySide::runAlone(uint32_t lane, uint64_t step, decltype(&makeStep) make) {
    BallRun &ball = m_slots[lane].ball;
    do {
        step = ball.advance(step, std::exchange(make, makeStep));
        if (!ball.isRunning()) return finish(ball);
        if (step == ball.nextStop()) ball.stop(ball.state());
        if (step == m_batch.step_count) return finish(ball);
    } while (!enter(lane, step));
}

void SideBySide::finish(BallRun &ball) {
    ball.finish();
    m_outcome.add(ball);
}

/// Puts the ball of a slot into its lane, before the step of this number. False if that isn't possible.
bool SideBySide::enter(uint32_t lane, uint64_t step) {
    Slot &slot = m_slots[lane];
    const BallRun &ball = slot.ball;
    if (!m_steps || !m_steps->enter(m_stepper.self, ball.params(), ball.state(), m_lanes, lane)) return false;
    m_inLanes |= 1U << lane;
    slot.entered = step;
    slot.ticks = m_ticks;
    m_nextStop = std::min(m_nextStop, m_ticks + (ball.nextStop() - step));
    m_gravity[lane] = &ball.gravity(step);
    tilt(lane);
    return true;
}

void SideBySide::tilt(uint32_t lane) {
    const phys_vec3 &gravity = *m_gravity[lane];
    m_lanes.x.gravity[lane] = gravity.x;
    m_lanes.y.gravity[lane] = gravity.y;
    m_lanes.gravityZ[lane] = gravity.z;
    m_lanes.tilted |= 1U << lane;
}

phys_state SideBySide::stateInLane(uint32_t lane) const {
    const Slot &slot = m_slots[lane];
    phys_state state = slot.ball.state();
    if (m_ticks == slot.ticks) return state;
    m_steps->leave(slot.ball.params(), m_lanes, lane, state);
    advanceClock(m_batch.dt, m_ticks - slot.ticks, state);
    return state;
}

void SideBySide::leave(uint32_t lane) {
    m_slots[lane].ball.state() = stateInLane(lane);
    m_inLanes &= ~(1U << lane);
}

/// One step of the balls in lanes. Those that can't make it there leave and go on alone.
void SideBySide::moveInLanes() {
    const uint32_t refused = m_inLanes & ~m_steps->step(m_lanes);
    each(refused, [this](uint32_t lane) { leave(lane); });
    ++m_ticks;
    const uint32_t done = m_ticks == m_nextStop ? stopInLanes() : 0;
    if (m_batch.gravity && m_batch.gravity_step_stride > 0) loadGravity();
    each(refused, [this](uint32_t lane) { runAlone(lane, stepsOf(m_slots[lane]) - 1, advance); });
    each(refused | done, [this](uint32_t lane) { fill(lane); });
}

/// The gravity of the next step.
void SideBySide::loadGravity() {
    each(m_inLanes, [this](uint32_t lane) {
        const phys_vec3 *last = m_gravity[lane];
        m_gravity[lane] = at(last, m_batch.gravity_step_stride, 1);
        if (!areSame(*last, *m_gravity[lane])) tilt(lane);
    });
}

/// Returns a bit for each lane whose ball is done.
uint32_t SideBySide::stopInLanes() {
    const uint32_t before = m_inLanes;
    each(m_inLanes, [this](uint32_t lane) {
        BallRun &ball = m_slots[lane].ball;
        const uint64_t steps = stepsOf(m_slots[lane]);
        if (steps < ball.nextStop()) return;
        ball.stop(stateInLane(lane));
        if (steps < m_batch.step_count) return;
        leave(lane);
        finish(ball);
    });
    m_nextStop = UINT64_MAX;
    each(m_inLanes, [this](uint32_t lane) {
        const Slot &slot = m_slots[lane];
        m_nextStop = std::min(m_nextStop, m_ticks + (slot.ball.nextStop() - stepsOf(slot)));
    });
    return before & ~m_inLanes;
}

} // namespace phys
