// SPDX-License-Identifier: MIT
#include "registry/side_by_side.h"

#include <bit>

namespace phys {

namespace {

/// visit(ball) for each bit.
template<class Visit>
void each(uint32_t balls, Visit visit) {
    for (; balls; balls &= balls - 1) visit(static_cast<uint32_t>(std::countr_zero(balls)));
}

} // namespace

SideBySide::SideBySide(const phys_stepper &stepper, const phys_batch &batch, const LaneSteps *steps,
                       bool paramsAreChecked)
    : m_stepper(stepper)
    , m_batch(batch)
    , m_steps(steps)
    , m_paramsAreChecked(paramsAreChecked) {}

void SideBySide::add(uint64_t number) {
    const uint32_t ball = m_count++;
    m_balls[ball] = BallRun(m_stepper, m_batch, number, m_paramsAreChecked);
    if (ball == 0 && m_steps) m_steps->begin(m_stepper.self, m_balls[0].params(), m_batch.dt, m_lanes);
    m_gravity[ball] = &m_balls[ball].gravity(0);
    if (!m_balls[ball].isRunning()) return;
    m_running |= 1U << ball;
    enter(ball, 0);
}

void SideBySide::run() {
    uint64_t untilPath = m_batch.path_every;
    for (uint64_t step = 0; step < m_batch.step_count && m_running; ++step) {
        const uint32_t inLanes = m_inLanes;
        const uint32_t moved = inLanes ? moveInLanes(step) : 0;
        each(m_running & ~inLanes, [&](uint32_t ball) { moveAlone(ball, step, makeStep); });
        each(inLanes & ~moved, [&](uint32_t ball) { moveAlone(ball, step, advance); });
        if (!m_batch.path || --untilPath > 0) continue;
        untilPath = m_batch.path_every;
        each(m_running, [&](uint32_t ball) {
            m_balls[ball].appendToPath(isInLane(ball) ? stateInLane(ball, step + 1) : m_balls[ball].state());
        });
    }
    each(m_inLanes, [&](uint32_t ball) { leave(ball, m_batch.step_count); });
    for (uint32_t ball = 0; ball < m_count; ++ball) m_balls[ball].finish();
}

void SideBySide::enter(uint32_t ball, uint64_t step) {
    const BallRun &run = m_balls[ball];
    const bool isEasy = m_steps && m_steps->enter(m_stepper.self, run.params(), run.state(), m_lanes, ball);
    if (!isEasy) return;
    m_inLanes |= 1U << ball;
    m_entered[ball] = step;
    const phys_vec3 &gravity = run.params().gravity; // for batches without gravity of their own
    m_lanes.x.gravity[ball] = gravity.x;
    m_lanes.y.gravity[ball] = gravity.y;
    m_lanes.gravityZ[ball] = gravity.z;
}

/// Called before the step of this number.
phys_state SideBySide::stateInLane(uint32_t ball, uint64_t step) const {
    phys_state state = m_balls[ball].state();
    const uint64_t steps = step - m_entered[ball];
    if (steps == 0) return state;
    m_steps->leave(m_balls[ball].params(), m_lanes, ball, state);
    advanceClock(m_batch.dt, steps, state);
    return state;
}

void SideBySide::leave(uint32_t ball, uint64_t step) {
    m_balls[ball].state() = stateInLane(ball, step);
    m_inLanes &= ~(1U << ball);
}

void SideBySide::loadGravity(uint64_t step) {
    const size_t offset = m_batch.gravity_step_stride * step;
    for (uint32_t ball = 0; ball < m_count; ++ball) {
        const phys_vec3 &gravity = *at(m_gravity[ball], offset, 1);
        m_lanes.x.gravity[ball] = gravity.x;
        m_lanes.y.gravity[ball] = gravity.y;
        m_lanes.gravityZ[ball] = gravity.z;
    }
}

/// Returns which balls made the step; the others have left their lanes.
uint32_t SideBySide::moveInLanes(uint64_t step) {
    if (m_batch.gravity && m_batch.gravity_step_stride > 0) loadGravity(step);
    const uint32_t moved = m_steps->step(m_lanes);
    each(m_inLanes & ~moved, [&](uint32_t ball) { leave(ball, step); });
    return m_inLanes;
}

void SideBySide::moveAlone(uint32_t ball, uint64_t step, decltype(&makeStep) make) {
    m_balls[ball].step(step, make);
    if (m_balls[ball].isRunning())
        enter(ball, step + 1);
    else
        m_running &= ~(1U << ball);
}

} // namespace phys
