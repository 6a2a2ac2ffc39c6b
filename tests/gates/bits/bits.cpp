// SPDX-License-Identifier: MIT
// Prints one line for each stepper that promises the same bits everywhere: id, version, and a hash of its states in all
// levels and both models.
// Usage: bits LEVEL...
#include <physics/physics.h>

#include <cinttypes>
#include <cstdio>
#include <vector>

namespace {

constexpr int kSteps = 3000;
constexpr double kDt = 0.004;

/// The board leans to all sides in turn, never the same way twice.
phys_vec3 gravityAt(int step) {
    const int side = step / 60;
    const double lean = 0.75 + 0.0625 * (side % 7);
    const double signs[4][2] = {{1, 0.5}, {-0.5, 1}, {-1, -0.5}, {0.5, -1}};
    return {lean * signs[side % 4][0], lean * signs[side % 4][1], -9.75};
}

/// Mixes the states of one run into the hash; false if a step fails.
bool run(const phys_stepper_info &info, const phys_scene *scene, uint32_t model, uint64_t &hash) {
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
        hash = (hash ^ phys_state_hash(&state)) * 0x100000001b3U;
    }
    phys_stepper_destroy(stepper);
    return status == PHYS_OK;
}

} // namespace

int main(int argc, char **argv) {
    std::vector<phys_scene *> scenes;
    phys_error error{};
    for (int i = 1; i < argc; ++i) {
        phys_scene *scene = nullptr;
        if (phys_scene_load(argv[i], &scene, &error)) {
            std::fprintf(stderr, "bits: %s\n", error.text);
            return 2;
        }
        scenes.push_back(scene);
    }
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(nullptr, i, &info) == PHYS_OK; ++i) {
        if (!(info.flags & PHYS_STEPPER_BITS_EVERYWHERE)) continue;
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            uint64_t hash = 0xcbf29ce484222325U;
            bool ran = true;
            for (const phys_scene *scene : scenes) ran &= run(info, scene, model, hash);
            std::printf("%s version %s model %u %s %016" PRIx64 "\n", info.id, info.version, model,
                        ran ? "hash" : "FAILED", hash);
        }
    }
    for (phys_scene *scene : scenes) phys_scene_destroy(scene);
    return 0;
}
