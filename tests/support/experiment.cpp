// SPDX-License-Identifier: MIT
#include "experiment.h"

#include <cmath>
#include <utility>

namespace support {

Experiment::Experiment(const SceneBuilder &scene, const QByteArray &stepper, uint32_t model)
    : m_id(stepper) {
    m_scene = scene.build(&m_error);
    prepare(model);
}

Experiment::Experiment(ScenePtr scene, const QByteArray &stepper, uint32_t model)
    : m_scene(std::move(scene))
    , m_id(stepper) {
    prepare(model);
}

void Experiment::prepare(uint32_t model) {
    phys_params_init(&params, sizeof params);
    params.model = model;
    params.gravity = {0.0, 0.0, -kNormalGravity};
    params.rolling_friction = 0.0;
    phys_report_init(&report, sizeof report);
    if (!m_scene) return;
    phys_scene_start(m_scene.get(), &state);
    renewStepper();
}

bool Experiment::renewStepper() {
    phys_stepper *stepper = nullptr;
    const phys_status status = phys_stepper_create(nullptr, m_id.constData(), m_scene.get(), &stepper, &m_error);
    m_stepper.reset(stepper);
    return status == PHYS_OK;
}

void Experiment::setLaw(double ax, double ay, double B) {
    params.gravity = {7.0 * ax / 5.0, 7.0 * ay / 5.0, -kNormalGravity};
    params.rolling_friction = 7.0 * B / 5.0 / kNormalGravity;
}

void Experiment::roll(double vx, double vy) {
    const double radius = phys_scene_radius(m_scene.get());
    state.velocity = {vx, vy, 0.0};
    state.spin = {-vy / radius, vx / radius, 0.0};
}

void Experiment::setPosition(double x, double y) {
    state.position.x = x;
    state.position.y = y;
}

bool Experiment::step(double dt) {
    if (!m_stepper) return false;
    report.events = m_events.data();
    report.event_capacity = static_cast<uint32_t>(m_events.size());
    return phys_step(m_stepper.get(), &params, dt, &state, &state, &report, &m_error) == PHYS_OK;
}

bool Experiment::stepTimes(uint64_t count, double dt) {
    for (uint64_t i = 0; i < count; ++i) {
        if (!step(dt)) return false;
    }
    return true;
}

bool Experiment::stepFor(double duration, double dt) {
    return stepTimes(static_cast<uint64_t>(std::llround(duration / dt)), dt);
}

} // namespace support
