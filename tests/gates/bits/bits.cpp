// SPDX-License-Identifier: MIT
// Prints one line for each stepper that promises the same bits everywhere, and each model: id, version, a hash of its
// states in all levels, and a hash of all results of steps in random scenes.
// Usage: bits LEVEL...
#include "random_scene.h"

#include <physics/physics.h>

#include <cinttypes>
#include <cstdio>
#include <vector>

namespace {

constexpr int kSteps = 3000;
constexpr double kDt = 0.004;
constexpr uint64_t kRandomScenes = 1000;
constexpr int kRandomSteps = 12;

/// The board leans to all sides in turn and never the same way twice.
phys_vec3 gravityAt(int step) {
    const int side = step / 60;
    const double lean = 0.75 + 0.0625 * (side % 7);
    const double signs[4][2] = {{1, 0.5}, {-0.5, 1}, {-1, -0.5}, {0.5, -1}};
    return {lean * signs[side % 4][0], lean * signs[side % 4][1], -9.75};
}

/// Mixes the states of one run into the hash; false if a step fails.
bool runLevel(const phys_stepper_info &info, const phys_scene *scene, uint32_t model, bits::Hash &hash) {
    phys_stepper *stepper = nullptr;
    phys_state state;
    phys_params params;
    if (phys_stepper_create(nullptr, info.id, scene, &stepper, nullptr)) return false;
    phys_scene_start(scene, &state);
    phys_params_init(&params, sizeof params);
    phys_stepper_info_init_params(&info, &params);
    params.model = model;
    params.options = PHYS_OPTION_ORIENTATION;
    phys_status status = PHYS_OK;
    for (int step = 0; step < kSteps && !status; ++step) {
        params.gravity = gravityAt(step);
        status = phys_step(stepper, &params, kDt, &state, &state, nullptr, nullptr);
        hash.add(phys_state_hash(&state));
    }
    phys_stepper_destroy(stepper);
    return status == PHYS_OK;
}

/// Hashes all that the library returns about one random ball in its scene; failures are hashed by their status.
void runRandom(const phys_stepper_info &info, uint64_t seed, uint32_t model, bits::Hash &hash) {
    bits::RandomScene random(seed);
    phys_scene *scene = nullptr;
    phys_stepper *stepper = nullptr;
    hash.add(static_cast<uint64_t>(random.create(&scene)));
    if (!scene) return;
    phys_state state;
    phys_params params;
    phys_scene_start(scene, &state);
    state.velocity = random.velocity();
    const phys_status made = phys_stepper_create(nullptr, info.id, scene, &stepper, nullptr);
    hash.add(static_cast<uint64_t>(made));
    for (int step = 0; step < kRandomSteps && !made; ++step) {
        if (step % 4 == 0) random.fill(info, model, params);
        phys_event events[16];
        phys_report report;
        phys_report_init(&report, sizeof report);
        report.events = events;
        report.event_capacity = 16;
        const phys_status status = phys_step(stepper, &params, random.dt(), &state, &state, &report, nullptr);
        hash.add(static_cast<uint64_t>(status));
        if (status) break;
        hash.add(phys_state_hash(&state));
        hash.add(report);
        hash.addContacts(scene, state.position, random.length());
    }
    phys_stepper_destroy(stepper);
    phys_scene_destroy(scene);
}

void print(const phys_stepper_info &info, uint32_t model, const std::vector<phys_scene *> &levels) {
    bits::Hash inLevels, inScenes;
    bool ran = true;
    for (const phys_scene *level : levels) ran &= runLevel(info, level, model, inLevels);
    for (uint64_t seed = 1; seed <= kRandomScenes; ++seed) runRandom(info, seed, model, inScenes);
    std::printf("%s version %s model %u levels %s%016" PRIx64 " scenes %016" PRIx64 "\n", info.id, info.version,
                static_cast<unsigned>(model), ran ? "" : "FAILED ", inLevels.value(), inScenes.value());
}

} // namespace

int main(int argc, char **argv) {
    std::vector<phys_scene *> levels;
    phys_error error{};
    for (int i = 1; i < argc; ++i) {
        phys_scene *scene = nullptr;
        if (phys_scene_load(argv[i], &scene, &error)) {
            std::fprintf(stderr, "bits: %s\n", error.text);
            return 2;
        }
        levels.push_back(scene);
    }
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(nullptr, i, &info) == PHYS_OK; ++i) {
        if (!(info.flags & PHYS_STEPPER_BITS_EVERYWHERE)) continue;
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) print(info, model, levels);
    }
    for (phys_scene *level : levels) phys_scene_destroy(level);
    return 0;
}
