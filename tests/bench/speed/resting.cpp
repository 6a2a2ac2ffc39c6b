// SPDX-License-Identifier: MIT
// The cost of a resting ball relative to one that rolls freely: on the floor, against a rough wall, in a rough corner.
#include "support/board.h"
#include "support/cpu_clock.h"
#include "support/statistics.h"

#include <cstdio>
#include <vector>

namespace {

using namespace bench;

constexpr double kStep = 0.01; // s
constexpr double kRadius = 0.25;
constexpr double kMostOfFree = 0.5; // the target
constexpr int kSteps = 50;          // from each start
constexpr int kStarts = 400;
constexpr int kRounds = 9;

struct Place {
    const char *name;
    Ball start;
    Vec2 pull; ///< m/s^2
};
constexpr Place kFree{"free", {{0.0, 0.0}, {0.5, 0.25}}, {0.6, 0.5}};
constexpr Place kResting[] = {{"floor", {{0.0, 0.0}, {}}, {0.0, 0.0}},
                              {"wall", {{9.0 - kRadius, 0.0}, {}}, {0.6, 0.0}},
                              {"corner", {{9.0 - kRadius, 9.0 - kRadius}, {}}, {0.6, 0.5}}};

/// Two walls that meet, in the open.
Scene corner() {
    Scene scene;
    scene.radius = kRadius;
    scene.walls = {{9.0, -9.0, 9.5, 9.5}, {-9.0, 9.0, 9.0, 9.5}};
    return scene;
}

/// s a step.
double timeOf(phys_stepper *stepper, const phys_scene &scene, uint32_t model, const Place &place) {
    phys_params params;
    phys_params_init(&params, sizeof params);
    params.model = model;
    params.rolling_friction = 0.05;
    params.sliding_friction = 0.5;
    params.wall_friction = 0.5;
    params.gravity = {place.pull.x, place.pull.y, -kStrength};
    phys_state start;
    phys_scene_start(&scene, &start);
    start.position.x = place.start.position.x;
    start.position.y = place.start.position.y;
    start.velocity = {place.start.velocity.x, place.start.velocity.y, 0.0};
    start.spin = {-start.velocity.y / kRadius, start.velocity.x / kRadius, 0.0};
    phys_error error;
    check(phys_step(stepper, &params, kStep, &start, &start, nullptr, &error), error);
    std::vector<double> rounds;
    rounds.reserve(kRounds);
    for (int round = 0; round < kRounds; ++round) {
        rounds.push_back(cpuTimeOf([&] {
            for (int i = 0; i < kStarts; ++i) {
                phys_state ball = start;
                for (int step = 0; step < kSteps; ++step) {
                    check(phys_step(stepper, &params, kStep, &ball, &ball, nullptr, &error), error);
                }
            }
        }));
    }
    return median(rounds) / (kStarts * kSteps);
}

} // namespace

int main() {
    const ScenePointer scene = createScene(corner());
    std::printf("Steps of 10 ms; a ball that rolls freely in ns, one that rests as a share of it, at most %g.\n\n",
                kMostOfFree);
    std::printf("%-18s %-8s %6s %7s %7s %7s\n", "", "", kFree.name, kResting[0].name, kResting[1].name,
                kResting[2].name);
    for (uint32_t index = 0; index < phys_registry_count(nullptr); ++index) {
        phys_stepper_info info;
        phys_registry_info(nullptr, index, &info);
        const StepperPointer stepper = createStepper(info.id, *scene);
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            const double free = timeOf(stepper.get(), *scene, model, kFree);
            std::printf("%-18s %-8s %6.0f", info.id, model == PHYS_MODEL_RIGID ? "rigid" : "rolling", free * 1e9);
            bool isMet = true;
            for (const Place &place : kResting) {
                const double share = timeOf(stepper.get(), *scene, model, place) / free;
                std::printf(" %7.2f", share);
                isMet = isMet && share <= kMostOfFree;
            }
            std::printf("  %s\n", isMet ? "met" : "MISSED");
        }
    }
}
