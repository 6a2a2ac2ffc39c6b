// SPDX-License-Identifier: MIT
#include "registry/ball_run.h"

#include "base/appendable.h"
#include "base/error.h"
#include "registry/arguments.h"
#include "registry/clock.h"
#include "registry/params.h"

#include <algorithm>
#include <iterator>

namespace phys {

phys_params wholeParams(const phys_params &given) {
    return isOlder(given) ? completed(given, phys_params_init) : given;
}

BallRun::BallRun(phys_stepper &stepper, const phys_batch &batch, uint64_t ball, bool paramsAreChecked)
    : m_stepper(&stepper)
    , m_batch(&batch)
    , m_number(ball)
    , m_params(wholeParams(*at(batch.params, batch.params_stride, ball)))
    , m_gravity(batch.gravity ? at(batch.gravity, batch.gravity_ball_stride, ball) : nullptr)
    , m_path(batch.path ? at(batch.path, batch.path_ball_stride, ball) : nullptr)
    , m_result(at(batch.states, batch.states_stride, ball))
    , m_states{*m_result, {}}
    , m_isRunning(batch.step_count > 0 && !(m_result->flags & batch.stop_flags)) {
    if (!m_isRunning) return;
    m_params.gravity = gravity(0);
    m_status = check(paramsAreChecked);
    m_isRunning = m_status == PHYS_OK;
}

phys_status BallRun::check(bool paramsAreChecked) const {
    if (!paramsAreChecked) {
        if (const phys_status status = checkParams(*m_stepper->api, m_params, nullptr)) return status;
    }
    if (m_gravity && !gravityIsValid(m_params)) return PHYS_ERROR_RANGE; // checked before the state, as in phys_step
    return checkState(state(), nullptr);
}

/// Adds the figures of a report to the ball's tally.
phys_status BallRun::stepAndTally(phys_state &next) {
    phys_event events[64];
    phys_report report{};
    report.struct_size = sizeof report;
    report.event_capacity = std::size(events);
    report.events = events;
    if (const phys_status status = makeStep(*m_stepper, m_params, m_batch->dt, state(), next, &report, nullptr)) {
        return status;
    }
    const auto isImpact = [](const phys_event &event) { return event.kind == PHYS_EVENT_IMPACT; };
    const uint64_t impacts =
        report.events_lost + static_cast<uint64_t>(std::count_if(events, events + report.event_count, isImpact));
    const double lost = report.lost_impact + report.lost_rolling + report.lost_slip;
    if (m_batch->impacts) m_batch->impacts[m_number] += impacts;
    if (m_batch->energy_lost) m_batch->energy_lost[m_number] += lost;
    m_tallyIsUnchanged = impacts == 0 && lost == 0.0;
    return PHYS_OK;
}

phys_status BallRun::tryStep(decltype(&makeStep) make, phys_state &next) {
    if (m_gravity && !gravityIsValid(m_params)) return PHYS_ERROR_RANGE;
    if (const phys_status status = checkPull(*m_stepper->scene, m_params, state(), nullptr)) return status;
    if (wantsTally(*m_batch)) return stepAndTally(next);
    return make(*m_stepper, m_params, m_batch->dt, state(), next, nullptr, nullptr);
}

uint64_t BallRun::nextStop() const {
    const uint64_t steps = m_batch->step_count, every = m_batch->path_every;
    if (!m_path) return steps;
    const uint64_t last = m_pathCount * every;
    return steps - last < every ? steps : last + every;
}

uint64_t BallRun::advance(uint64_t step, decltype(&makeStep) make) {
    m_params.gravity = gravity(step);
    m_done = step;
    m_status = tryStep(make, m_states[1 - m_now]);
    m_isRunning = m_status == PHYS_OK;
    if (!m_isRunning) return step;
    m_now = 1 - m_now;
    ++m_done;
    m_isRunning = !(state().flags & m_batch->stop_flags);
    if (!m_isRunning || !wasUnchanged()) return m_done;
    const uint64_t more = std::min(stepsOfSameGravity(step), stepsWithinTime());
    advanceClock(m_batch->dt, more, state());
    return m_done + more;
}

/// Whether the last step left the ball and its tally as they were, as the same step will then do again. Plugins may
/// have a memory.
bool BallRun::wasUnchanged() const {
    if (m_batch->dt == 0.0) return true;
    return (state().flags & PHYS_AT_REST) && !m_stepper->isPlugin && m_tallyIsUnchanged &&
           isSameBall(m_states[0], m_states[1]);
}

/// The number of steps after this one, until the next stop, that have the same gravity.
uint64_t BallRun::stepsOfSameGravity(uint64_t step) const {
    const uint64_t most = nextStop() - (step + 1);
    if (!m_gravity || m_batch->gravity_step_stride == 0) return most;
    uint64_t count = 0;
    while (count < most && areSame(gravity(step + 1 + count), m_params.gravity)) ++count;
    return count;
}

/// A number of further steps that don't lead beyond the greatest time, however it is rounded.
uint64_t BallRun::stepsWithinTime() const {
    constexpr double kGreatest = kLargestNumber * (1.0 - 16.0 * kRounding);
    const double steps = (kGreatest - state().time) / m_batch->dt; // infinite or NaN for dt = 0
    if (!(steps < static_cast<double>(kCountedSteps))) return kCountedSteps;
    return steps > 0.0 ? static_cast<uint64_t>(steps) : 0;
}

void BallRun::stop(const phys_state &state) {
    if (m_path && m_pathCount < pathLength(*m_batch)) m_path[m_pathCount++] = state;
}

void BallRun::explain(phys_error &reason) const {
    phys_state unused;
    fail(&reason, m_status, "%s", phys_status_text(m_status)); // for a plugin that doesn't fail again
    phys_step(m_stepper, &m_params, m_batch->dt, &state(), &unused, nullptr, &reason);
}

void BallRun::finish() {
    if (m_isRunning) m_done = m_batch->step_count;
    *m_result = state();
    if (m_path) std::fill(m_path + m_pathCount, m_path + pathLength(*m_batch), state());
}

} // namespace phys
