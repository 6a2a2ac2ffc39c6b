// SPDX-License-Identifier: MIT
// A thousand balls, each on a board tilted its own way, stepped by two threads: how many leave the level.
// Usage: threads LEVEL
#include "physics.hpp"

#include <algorithm>
#include <cstdio>
#include <future>

namespace {

constexpr int kBalls = 1000;
constexpr int kThreads = 2;

int run(const char *level) {
    const physics::Scene scene(level);
    const physics::Registry registry;
    const phys_params params = physics::defaultParams();
    std::vector<phys_state> states(kBalls, scene.start());
    std::vector<double> tiltsX; // rad
    for (int i = 0; i < kBalls; ++i) tiltsX.push_back(0.0002 * (i - kBalls / 2));
    const std::vector<phys_vec3> gravity = physics::gravitiesFromTilts(tiltsX, std::vector<double>(kBalls, 0.05));

    phys_batch batch = physics::defaultBatch();
    batch.stop_flags = PHYS_OUT;
    batch.ball_count = kBalls;
    batch.step_count = 2000;
    batch.dt = 0.01;
    batch.params = &params; // one for all: stride 0
    batch.gravity = gravity.data();
    batch.gravity_ball_stride = sizeof(phys_vec3);
    batch.states = states.data();
    batch.states_stride = sizeof(phys_state);

    std::vector<std::future<void>> parts; // a failure in a thread comes out of get()
    for (int i = 0; i < kThreads; ++i) {
        parts.push_back(std::async(std::launch::async, [&, i] {
            physics::Stepper stepper(registry, PHYS_STEPPER_DEFAULT, scene); // serves one thread
            stepper.run(batch, kBalls * i / kThreads, kBalls * (i + 1) / kThreads - kBalls * i / kThreads);
        }));
    }
    for (std::future<void> &part : parts) part.get();

    const auto with = [&](uint64_t flag) {
        return static_cast<int>(
            std::count_if(states.begin(), states.end(), [flag](const phys_state &s) { return s.flags & flag; }));
    };
    std::printf("after %g s, of %d balls %d have left the level and %d are at rest\n",
                static_cast<double>(batch.step_count) * batch.dt, kBalls, with(PHYS_OUT), with(PHYS_AT_REST));
    if (std::fclose(stdout) == 0) return 0;
    std::perror("threads: the output can't be written"); // as on a full disk
    return 1;
}

} // namespace

int main(int argc, char **argv) try {
    if (argc == 2) return run(argv[1]);
    std::fputs("Usage: threads LEVEL\n", stderr);
    return 2;
} catch (const physics::Error &error) {
    std::fprintf(stderr, "threads: %s\n", error.what());
    return 1;
}
