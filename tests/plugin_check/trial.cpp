// SPDX-License-Identifier: MIT
#include "trial.h"

#include <array>
#include <cstdio>

namespace plugin_check {

std::string format(const char *text, double a, double b, double c) {
    std::array<char, 200> line{};
    std::snprintf(line.data(), line.size(), text, a, b, c);
    return line.data();
}

witness::Case board(uint32_t model) {
    witness::Case scene = witness::emptyCase();
    scene.boxes = {{{-1, -1, -0.1}, {1, 1, 0}}};
    scene.params.model = model;
    scene.params.sliding_friction = 0.3;
    scene.start.position = {0, 0, kRadius};
    scene.legs = {{{0, 0, -9.81}, 0.01, 1}};
    return scene;
}

void roll(witness::Case &scene, double x, double y) {
    scene.start.velocity = {x, y, 0};
    scene.start.spin = {-y / scene.radius, x / scene.radius, 0};
}

Run::Run(const Subject &subject, const witness::Case &scene) {
    const phys_scene_desc desc = witness::descOf(scene.boxes, scene.radius, scene.start.position);
    phys_scene *created = nullptr;
    phys_stepper *made = nullptr;
    m_status = phys_scene_create(&desc, &created, &m_error);
    m_scene.reset(created);
    if (!m_status) m_status = phys_stepper_create(subject.registry, subject.id.c_str(), created, &made, &m_error);
    m_stepper.reset(made);
    params = scene.params;
    params.gravity = scene.legs[0].gravity;
    phys_stepper_info info;
    if (!phys_registry_find(subject.registry, subject.id.c_str(), &info, nullptr)) {
        phys_stepper_info_init_params(&info, &params);
    }
    state = scene.start;
}

bool Run::step(double dt, phys_report *report) {
    if (!m_status) m_status = phys_step(m_stepper.get(), &params, dt, &state, &state, report, &m_error);
    return m_status == PHYS_OK;
}

double Run::energy() const {
    double value = 0;
    phys_energy(m_scene.get(), &params, &state, &value);
    return value;
}

uint32_t modelOf(const Subject &subject) {
    Run run(subject, board(PHYS_MODEL_RIGID));
    run.step(0.001);
    return run.status() == PHYS_ERROR_UNSUPPORTED ? PHYS_MODEL_ROLLING : PHYS_MODEL_RIGID;
}

} // namespace plugin_check
