// SPDX-License-Identifier: MIT
#include "roll.h"

#include <cmath>

namespace sweep {

namespace {

constexpr double kTilt = 0.1;        // rad
constexpr uint64_t kStepsASide = 64; // the board leans to +x, +y, -x, -y in turn, so many steps each
constexpr uint32_t kRoom = 64;       // for events of one step

/// The tilt of a step, from its number alone: no job depends on another.
phys_vec3 gravityOf(uint64_t step) {
    static const double sides[4][2] = {{kTilt, 0}, {0, kTilt}, {-kTilt, 0}, {0, -kTilt}};
    const double *side = sides[step / kStepsASide % 4];
    phys_vec3 gravity{};
    phys_gravity_from_tilt(side[0], side[1], 9.81, &gravity);
    return gravity;
}

uint64_t impactsIn(const phys_report &report) {
    uint64_t count = report.events_lost;
    for (uint32_t i = 0; i < report.event_count; ++i) count += report.events[i].kind == PHYS_EVENT_IMPACT ? 1 : 0;
    return count;
}

/// Steps until the time is up, the ball is out or a step fails.
void stepThrough(phys_stepper *stepper, phys_params params, double dt, double seconds, Outcome &outcome) {
    phys_event events[kRoom];
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = events;
    report.event_capacity = kRoom;
    const auto steps = static_cast<uint64_t>(std::llround(seconds / dt));
    phys_state &state = outcome.state;
    while (state.step < steps && !(state.flags & PHYS_OUT)) {
        params.gravity = gravityOf(state.step);
        if (phys_step(stepper, &params, dt, &state, &state, &report, &outcome.error)) return;
        outcome.impacts += impactsIn(report);
        outcome.energyLost += report.lost_impact + report.lost_rolling + report.lost_slip;
    }
}

} // namespace

Roller::Roller(const Plan &plan)
    : m_plan(plan) {
    phys_registry *registry = nullptr;
    if (phys_registry_create(&registry, &m_broken)) return;
    m_registry.reset(registry);
    for (const std::string &plugin : plan.plugins) {
        if (phys_registry_load_file(registry, plugin.c_str(), &m_broken)) return;
    }
}

const phys_scene *Roller::scene(const std::string &level, phys_error &error) {
    auto &known = m_scenes[level];
    phys_scene *loaded = nullptr;
    if (!known && phys_scene_load(level.c_str(), &loaded, &error) == PHYS_OK) known.reset(loaded);
    return known.get();
}

void Roller::roll(const Job &job, Outcome &outcome) {
    phys_stepper_info info;
    if (phys_registry_find(m_registry.get(), job.stepper.c_str(), &info, &outcome.error)) return;
    phys_params params;
    phys_params_init(&params, sizeof params);
    phys_stepper_info_init_params(&info, &params);
    params.rolling_friction = job.friction;
    params.restitution_wall = job.restitution;
    if (phys_params_check(&params, &outcome.error)) return;

    const phys_scene *scene = this->scene(job.level, outcome.error);
    phys_stepper *stepper = nullptr;
    if (!scene || phys_stepper_create(m_registry.get(), info.id, scene, &stepper, &outcome.error)) return;
    phys_scene_start(scene, &outcome.state);
    stepThrough(stepper, params, job.dt, m_plan.seconds, outcome);
    phys_stepper_destroy(stepper);
}

Outcome Roller::run(uint64_t number) {
    Outcome outcome{};
    outcome.job = number;
    outcome.error = m_broken;
    if (!m_broken.status) roll(m_plan.job(number), outcome);
    return outcome;
}

} // namespace sweep
