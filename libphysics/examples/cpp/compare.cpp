// SPDX-License-Identifier: MIT
// Lets every stepper roll the same ball for a second and prints where each ends and what became of the energy.
// Usage: compare LEVEL [PLUGIN...]
#include "physics.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

constexpr double kDt = 0.005; // s
constexpr int kSteps = 200;

void run(const physics::Registry &registry, const phys_stepper_info &info, const physics::Scene &scene) {
    phys_params params = physics::defaultParams(info);
    params.gravity = physics::gravityFromTilt(0.10, 0.05);

    physics::Stepper stepper(registry, info.id, scene);
    phys_state state = scene.start();
    const double before = scene.energy(params, state);
    for (int i = 0; i < kSteps; ++i) state = stepper.step(params, kDt, state);
    std::printf("%-18s x %8.5f m  y %8.5f m  energy lost %8.5f J/kg\n", info.id, state.position.x, state.position.y,
                before - scene.energy(params, state));
}

} // namespace

int main(int argc, char **argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: %s LEVEL [PLUGIN...]\n", argv[0]);
        return 2;
    }
    try {
        physics::Registry registry;
        for (int i = 2; i < argc; ++i) registry.load(argv[i]);
        const physics::Scene scene(argv[1]);
        for (const phys_stepper_info &info : registry.steppers()) run(registry, info, scene);
    } catch (const physics::Error &error) {
        std::fprintf(stderr, "compare: %s: %s\n", phys_status_name(error.status()), error.what());
        return EXIT_FAILURE;
    }
    if (std::fclose(stdout) != 0) { // as on a full disk
        std::perror("compare: the output can't be written");
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
