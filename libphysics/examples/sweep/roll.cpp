// SPDX-License-Identifier: MIT
#include "roll.h"

#include <algorithm>
#include <cmath>

namespace sweep {

namespace {

constexpr double kTilt = 0.1;        // rad
constexpr uint64_t kStepsASide = 64; // the board leans to +x, +y, -x, -y in turn, so many steps each

/// The tilt of a step, from its number alone: no job depends on another.
phys_vec3 gravityOf(uint64_t step) {
    static const double sides[4][2] = {{kTilt, 0}, {0, kTilt}, {-kTilt, 0}, {0, -kTilt}};
    const double *side = sides[step / kStepsASide % 4];
    phys_vec3 gravity{};
    phys_gravity_from_tilt(side[0], side[1], 9.81, &gravity);
    return gravity;
}

/// Steps until the time is up, the ball is out or a step fails: a batch for each side that the board leans to.
void stepThrough(phys_stepper *stepper, phys_params params, double dt, double seconds, Outcome &outcome) {
    const auto steps = static_cast<uint64_t>(std::llround(seconds / dt));
    phys_state &state = outcome.state;
    phys_status status = PHYS_OK;
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.stop_flags = PHYS_OUT;
    batch.ball_count = 1;
    batch.dt = dt;
    batch.params = &params;
    batch.states = &state;
    batch.statuses = &status;
    batch.impacts = &outcome.impacts;
    batch.energy_lost = &outcome.energyLost;
    while (state.step < steps && !(state.flags & PHYS_OUT)) {
        params.gravity = gravityOf(state.step);
        batch.step_count = std::min(kStepsASide, steps - state.step);
        if (phys_batch_run(stepper, &batch, 0, 1, &outcome.error)) return;
        if (!status) continue;
        phys_step(stepper, &params, dt, &state, &state, nullptr, &outcome.error); // says why it fails
        return;
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
