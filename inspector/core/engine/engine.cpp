// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/engine.h"

#include "core/setup/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inspector {

namespace {

/// Distance between the ball and the nearest wall, m, searched for within growing radii; NaN if none is near.
double wallGap(const phys_scene *scene, const phys_vec3 &centre) {
    const double radius = phys_scene_radius(scene);
    for (const double reach : {2.0, 4.0, 8.0, 16.0, 32.0}) // radii
        if (const std::optional<phys_contact> wall = nearestWall(scene, centre, reach * radius)) return wall->gap;
    return std::numeric_limits<double>::quiet_NaN();
}

} // namespace

Engine::Engine(Scene scene, Stepper stepper)
    : m_scene(std::move(scene))
    , m_stepper(std::move(stepper)) {
    restart();
}

void Engine::setScene(Scene scene, Stepper stepper) {
    m_stepper = std::move(stepper);
    m_scene = std::move(scene);
    m_pilot = nullptr;
    m_start.reset();
    restart();
}

/// The tilt that the pilot set last belongs to the run that ends, so the next step asks the pilot again.
void Engine::restart() {
    m_inputs = m_given;
    if (m_start) return setState(*m_start);
    phys_state start;
    if (phys_scene_start(m_scene.get(), &start) == PHYS_OK) setState(start);
}

void Engine::setState(const phys_state &state, const EnergySums &sums) {
    m_state = m_previous = state;
    m_sums = m_previousSums = sums;
    m_report = {};
    phys_report_init(&m_report, sizeof m_report);
    m_report.events = m_events.data();
    m_report.event_capacity = kEventCapacity;
}

/// Called at multiples of its period, counted in steps from the start, so that a run is repeatable.
void Engine::askPilot() {
    if (!m_pilot) return;
    const auto interval = uint64_t(std::max(1.0, std::round(m_pilot->period() / std::max(m_dt, 1e-9))));
    if (m_pilotIsNew || m_state.step % interval == 0) tiltBoard(m_inputs, m_pilot->tilt(m_state, m_dt));
    m_pilotIsNew = false;
}

void Engine::setInputs(const Inputs &inputs) {
    const Tilt piloted = m_inputs.tilt;
    m_given = m_inputs = inputs;
    if (m_pilot) tiltBoard(m_inputs, piloted);
}

void Engine::setPilot(std::shared_ptr<const Pilot> pilot) {
    m_pilot = std::move(pilot);
    m_pilotIsNew = true;
    if (!m_pilot) m_inputs = m_given;
}

bool Engine::step(QString *error) {
    askPilot();
    phys_error failure;
    phys_state next;
    const phys_status status = phys_step(m_stepper.get(), &m_inputs.params, m_dt, &m_state, &next, &m_report, &failure);
    if (status != PHYS_OK) {
        tell(error, failure);
        return false;
    }
    m_previous = m_state;
    m_state = next;
    m_previousSums = m_sums;
    m_sums.impact += m_report.lost_impact;
    m_sums.rolling += m_report.lost_rolling;
    m_sums.slip += m_report.lost_slip;
    m_sums.scheme += m_report.energy_scheme;
    return true;
}

Sample Engine::sample() const {
    Sample sample = makeSample(m_state, m_inputs, m_report);
    const phys_vec3 &now = m_state.velocity;
    const phys_vec3 &before = m_previous.velocity;
    if (m_dt > 0.0)
        sample[Channel::Acceleration] = std::hypot(now.x - before.x, now.y - before.y, now.z - before.z) / m_dt;
    sample[Channel::LostImpact] = m_sums.impact;
    sample[Channel::LostRolling] = m_sums.rolling;
    sample[Channel::LostSlip] = m_sums.slip;
    sample[Channel::Scheme] = m_sums.scheme;
    sample[Channel::WallGap] = wallGap(m_scene.get(), m_state.position);
    return sample;
}

} // namespace inspector
