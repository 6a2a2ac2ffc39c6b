// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/engine.h"

#include <algorithm>
#include <cmath>

namespace inspector {

Engine::Engine(Scene scene, Stepper stepper)
    : m_scene(std::move(scene))
    , m_stepper(std::move(stepper)) {
    restart();
}

void Engine::setScene(Scene scene, Stepper stepper) {
    m_stepper = std::move(stepper);
    m_scene = std::move(scene);
    m_pilot = nullptr;
    restart();
}

void Engine::restart() {
    phys_state start;
    if (phys_scene_start(m_scene.get(), &start) == PHYS_OK) setState(start);
}

void Engine::setState(const phys_state &state) {
    m_state = m_previous = state;
    m_report = {};
    phys_report_init(&m_report, sizeof m_report);
    m_report.events = m_events.data();
    m_report.event_capacity = kEventCapacity;
}

// Asked at multiples of the control period, counted in steps from the start, so that a run can be repeated.
void Engine::askPilot() {
    if (!m_pilot) return;
    const auto interval = uint64_t(std::max(1.0, std::round(kControlPeriod / std::max(m_dt, 1e-9))));
    if (m_pilotIsNew || m_state.step % interval == 0) tiltBoard(m_inputs, m_pilot->tilt(m_state));
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
    return true;
}

Sample Engine::sample() const { return makeSample(m_state, m_inputs, m_report); }

} // namespace inspector
