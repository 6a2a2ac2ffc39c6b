// SPDX-License-Identifier: MIT
// Any scene, parameters, state and step sizes, with every stepper: a valid state, or one line and unchanged outputs.
#include "input.h"

#include <physics/physics.h>

#include <cmath>
#include <vector>

namespace {

constexpr int kMostBoxes = 24;
constexpr int kMostSteps = 8;

/// For inputs of at least this many bytes, the ball starts anywhere and with a spin.
constexpr uint8_t kAnywhere = 128;

/// After a step that took more of these, the rest of the input is skipped in favour of faster inputs.
constexpr uint32_t kMostWork = 200;

phys_vec3 vector(fuzz::Input &input) {
    const double x = input.number();
    const double y = input.number();
    return {x, y, input.number()};
}

phys_scene *sceneOf(fuzz::Input &input) {
    std::vector<phys_box> boxes(input.take<uint8_t>() % kMostBoxes);
    for (phys_box &box : boxes) {
        box.min = vector(input);
        const phys_vec3 size = vector(input);
        box.max = {box.min.x + std::abs(size.x), box.min.y + std::abs(size.y), box.min.z + std::abs(size.z)};
    }
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.boxes = boxes.empty() ? nullptr : boxes.data();
    desc.box_count = static_cast<uint32_t>(boxes.size());
    desc.radius = std::abs(input.number());
    desc.start = vector(input);
    phys_scene *scene = nullptr;
    phys_error error{};
    const phys_status status = phys_scene_create(&desc, &scene, &error);
    fuzz::demand(status ? !scene && error.text[0] : scene != nullptr);
    return scene;
}

phys_params paramsOf(fuzz::Input &input, const phys_stepper_info &info) {
    phys_params params;
    phys_params_init(&params, sizeof params);
    phys_stepper_info_init_params(&info, &params);
    params.model = input.take<uint8_t>() % 3; // 2: there is no such model
    params.options = input.take<uint8_t>() % 4;
    params.gravity = vector(input);
    params.restitution_wall = std::abs(input.number()) / 16.0;
    params.restitution_floor = std::abs(input.number()) / 16.0;
    params.rolling_friction = std::abs(input.number());
    params.sliding_friction = std::abs(input.number());
    params.wall_friction = std::abs(input.number());
    params.stepper[0] = input.take<uint8_t>() % 2;
    return params;
}

bool isFinite(const phys_vec3 &v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

phys_status stepAsBatch(phys_stepper *stepper, const phys_params &params, double dt, phys_state &state) {
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.ball_count = batch.step_count = 1;
    batch.dt = dt;
    batch.params = &params;
    batch.states = &state;
    return phys_batch_run(stepper, &batch, 0, 1, nullptr);
}

/// More balls than fit into the lanes, for some steps: each gets what phys_step gives in a loop.
void demandSameOfMany(phys_stepper *stepper, const phys_params &params, double dt, const phys_state &start) {
    constexpr uint64_t kBalls = 9, kSteps = 3;
    phys_state expected = start;
    uint64_t done = 0;
    phys_status status = PHYS_OK;
    while (done < kSteps && !(status = phys_step(stepper, &params, dt, &expected, &expected, nullptr, nullptr))) ++done;
    std::vector<phys_state> states(kBalls, start);
    uint64_t stepsDone[kBalls];
    phys_status statuses[kBalls];
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.ball_count = kBalls;
    batch.step_count = kSteps;
    batch.dt = dt;
    batch.params = &params;
    batch.states = states.data();
    batch.states_stride = sizeof(phys_state);
    batch.steps_done = stepsDone;
    batch.statuses = statuses;
    fuzz::demand(phys_batch_run(stepper, &batch, 0, kBalls, nullptr) == PHYS_OK);
    for (uint64_t ball = 0; ball < kBalls; ++ball) {
        fuzz::demand(std::memcmp(&states[ball], &expected, sizeof expected) == 0);
        fuzz::demand(stepsDone[ball] == done && statuses[ball] == status);
    }
}

/// Whether further steps are worth their time.
bool stepOnce(phys_stepper *stepper, const phys_params &params, double dt, phys_state &state) {
    phys_event events[4];
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = events;
    report.event_capacity = 4;
    const phys_state before = state;
    const phys_report freshReport = report;
    phys_error error{};
    const phys_status status = phys_step(stepper, &params, dt, &before, &state, &report, &error);
    if (status) {
        phys_state again = before;
        fuzz::demand(stepAsBatch(stepper, params, dt, again) == status);
        fuzz::demand(std::memcmp(&again, &before, sizeof again) == 0);
        fuzz::demand(error.status == status && error.text[0]);
        fuzz::demand(std::memcmp(&state, &before, sizeof state) == 0);
        fuzz::demand(std::memcmp(&report, &freshReport, sizeof report) == 0);
        return false;
    }
    fuzz::demand(isFinite(state.position) && isFinite(state.velocity) && isFinite(state.spin));
    fuzz::demand(std::isfinite(state.time) && (state.flags & ~uint64_t(PHYS_STATE_FLAGS)) == 0);
    fuzz::demand(report.event_count <= report.event_capacity);
    // The same again, in place and without a report, and as a batch of one: the same bits.
    phys_state again = before;
    fuzz::demand(phys_step(stepper, &params, dt, &again, &again, nullptr, nullptr) == PHYS_OK);
    fuzz::demand(std::memcmp(&again, &state, sizeof again) == 0);
    again = before;
    fuzz::demand(stepAsBatch(stepper, params, dt, again) == PHYS_OK);
    fuzz::demand(std::memcmp(&again, &state, sizeof again) == 0);
    constexpr uint32_t kLittleWork = 32; // as there are many of them
    if (report.substeps < kLittleWork && report.event_count < kLittleWork && !report.events_lost) {
        demandSameOfMany(stepper, params, dt, before);
    }
    return report.substeps < kMostWork && report.events_lost < kMostWork;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz::Input input(data, size);
    phys_stepper_info info;
    const auto choice = input.take<uint8_t>();
    phys_registry_info(nullptr, choice % phys_registry_count(nullptr), &info);
    phys_scene *scene = sceneOf(input);
    if (!scene) return 0;
    phys_stepper *stepper = nullptr;
    if (phys_stepper_create(nullptr, info.id, scene, &stepper, nullptr) == PHYS_OK) {
        phys_state state;
        phys_scene_start(scene, &state);
        state.velocity = vector(input);
        if (choice >= kAnywhere) {
            state.position = vector(input);
            state.spin = vector(input);
        }
        bool goesOn = true;
        for (int step = 0; goesOn && step < kMostSteps && !input.isEmpty(); ++step) {
            const phys_params params = paramsOf(input, info);
            goesOn = stepOnce(stepper, params, input.number() / 8.0, state);
        }
        phys_stepper_destroy(stepper);
    }
    phys_scene_destroy(scene);
    return 0;
}
