// SPDX-License-Identifier: MIT
// Threads that share one scene and one registry, each with its own steppers, get the same bits as a single thread.
// Without Qt, so that ThreadSanitizer sees all of the code. Usage: threads LEVEL PLUGIN
#include <physics/physics.h>

#include <cstdio>
#include <cstring>
#include <thread>
#include <vector>

namespace {

constexpr int kThreads = 4;
constexpr int kSteps = 2000;
constexpr int kBalls = 17;

/// Hash of a run by each stepper, one after another; `shift` makes threads use different steppers at the same time.
std::vector<uint64_t> runAll(const phys_registry *registry, const phys_scene *scene, uint32_t shift) {
    const uint32_t count = phys_registry_count(registry);
    std::vector<uint64_t> hashes(count);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t index = (i + shift) % count;
        phys_stepper_info info;
        phys_stepper *stepper = nullptr;
        phys_state state;
        phys_params params;
        if (phys_registry_info(registry, index, &info)) continue;
        if (phys_stepper_create(registry, info.id, scene, &stepper, nullptr)) continue;
        phys_scene_start(scene, &state);
        phys_params_init(&params, sizeof params);
        phys_stepper_info_init_params(&info, &params);
        phys_status status = PHYS_OK;
        for (int step = 0; step < kSteps && !status; ++step) {
            const double side = step / 100 % 2 ? 0.9 : -0.9;
            params.gravity = {side, 0.5 * side, -9.7};
            status = phys_step(stepper, &params, 0.005, &state, &state, nullptr, nullptr);
        }
        if (!status) hashes[index] = phys_state_hash(&state);
        phys_stepper_destroy(stepper);
    }
    return hashes;
}

/// Balls that roll apart, in one batch whose ranges run on `threads` threads, each with its own stepper.
std::vector<phys_state> runBatch(const phys_registry *registry, const phys_stepper_info &info, const phys_scene *scene,
                                 int threads) {
    phys_state start;
    phys_params params;
    phys_scene_start(scene, &start);
    phys_params_init(&params, sizeof params);
    phys_stepper_info_init_params(&info, &params);
    std::vector<phys_state> states(kBalls, start);
    std::vector<phys_vec3> gravity(kBalls);
    for (int i = 0; i < kBalls; ++i) gravity[static_cast<size_t>(i)] = {0.1 * i - 0.8, 0.9 - 0.1 * i, -9.7};
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.ball_count = kBalls;
    batch.step_count = kSteps / 10;
    batch.dt = 0.005;
    batch.params = &params;
    batch.gravity = gravity.data();
    batch.gravity_ball_stride = sizeof gravity[0];
    batch.states = states.data();
    batch.states_stride = sizeof states[0];
    std::vector<std::thread> running;
    for (int i = 0; i < threads; ++i) {
        const uint64_t first = static_cast<uint64_t>(kBalls * i / threads);
        const uint64_t end = static_cast<uint64_t>(kBalls * (i + 1) / threads);
        running.emplace_back([&, first, end] {
            phys_stepper *stepper = nullptr;
            if (phys_stepper_create(registry, info.id, scene, &stepper, nullptr)) return;
            phys_batch_run(stepper, &batch, first, end - first, nullptr);
            phys_stepper_destroy(stepper);
        });
    }
    for (std::thread &thread : running) thread.join();
    return states;
}

/// The number of steppers whose results differ between ranges on threads and a single range.
int compareBatches(const phys_registry *registry, const phys_scene *scene) {
    int wrong = 0;
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(registry, i, &info) == PHYS_OK; ++i) {
        const std::vector<phys_state> expected = runBatch(registry, info, scene, 1);
        const std::vector<phys_state> found = runBatch(registry, info, scene, kThreads);
        const bool hasRun = expected[0].step > 0;
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): no padding
        if (hasRun && std::memcmp(found.data(), expected.data(), kBalls * sizeof expected[0]) == 0) continue;
        std::fprintf(stderr, "threads: a batch on threads by %s gives other bits, or doesn't run\n", info.id);
        ++wrong;
    }
    return wrong;
}

int compare(const phys_registry *registry, const phys_scene *scene) {
    const std::vector<uint64_t> expected = runAll(registry, scene, 0);
    for (uint32_t i = 0; i < expected.size(); ++i) {
        if (expected[i] != 0) continue;
        std::fprintf(stderr, "threads: stepper %u doesn't run at all\n", i);
        return 1;
    }
    std::vector<std::vector<uint64_t>> found(kThreads);
    std::vector<std::thread> threads;
    for (uint32_t i = 0; i < kThreads; ++i) {
        threads.emplace_back([&, i] { found[i] = runAll(registry, scene, i); });
    }
    for (std::thread &thread : threads) thread.join();
    for (int i = 0; i < kThreads; ++i) {
        if (found[static_cast<size_t>(i)] == expected) continue;
        std::fprintf(stderr, "threads: thread %d found other bits than one thread alone\n", i);
        return 1;
    }
    std::printf("threads: %d threads, %zu steppers, %d steps each: the same bits\n", kThreads, expected.size(), kSteps);
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    phys_registry *registry = nullptr;
    phys_scene *scene = nullptr;
    phys_error error{};
    const bool isReady = argc == 3 && !phys_registry_create(&registry, &error) &&
                         !phys_registry_load_file(registry, argv[2], &error) &&
                         !phys_scene_load(argv[1], &scene, &error);
    if (!isReady) std::fprintf(stderr, "threads: %s\n", argc == 3 ? error.text : "expected LEVEL PLUGIN");
    int code = isReady ? compare(registry, scene) : 2;
    if (code == 0 && compareBatches(registry, scene) > 0) code = 1;
    phys_scene_destroy(scene);
    phys_registry_destroy(registry);
    return code;
}
