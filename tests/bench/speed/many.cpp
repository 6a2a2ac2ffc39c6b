// SPDX-License-Identifier: MIT
// Many balls, many steps: steps per second of batches in a level, in the open and on two threads, compared with MuJoCo
// in the same maze with the same balls and duration.
#include "peers/engine.h"
#include "support/board.h"
#include "support/cpu_clock.h"
#include "support/maze_scenes.h"
#include "support/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>

namespace {

using namespace bench;

constexpr double kStep = 0.01; // s
constexpr uint64_t kBalls = 1024;
constexpr uint64_t kSteps = 500;
constexpr uint64_t kStepsPerTilt = 50;
constexpr int kRounds = 9;
constexpr const char *kLevel = BENCH_LEVELS "/10.txt";

/// Balls with the same start, each on a board of its own.
struct Balls {
    const phys_scene &scene;
    std::vector<phys_vec3> gravity; // of each ball's tilts, side by side
    std::vector<phys_state> states;
    phys_params params{};
    phys_batch batch{};

    /// The first tilt of each lasts.
    void keepTilts() { batch.gravity_step_stride = 0; }

    /// Frictionless ones slide.
    explicit Balls(const phys_scene &from, bool rolls = true)
        : scene(from) {
        for (uint64_t ball = 0; ball < kBalls; ++ball) {
            const auto tilts = randomTilts(static_cast<unsigned>(ball + 1), kSteps / kStepsPerTilt);
            for (uint64_t step = 0; step < kSteps; ++step) gravity.push_back(tilts[step / kStepsPerTilt]);
        }
        phys_params_init(&params, sizeof params);
        if (!rolls) {
            params.model = PHYS_MODEL_RIGID;
            params.rolling_friction = params.sliding_friction = 0;
        }
        phys_batch_init(&batch, sizeof batch);
        batch.ball_count = kBalls;
        batch.step_count = kSteps;
        batch.dt = kStep;
        batch.params = &params;
        batch.gravity = gravity.data();
        batch.gravity_ball_stride = kSteps * sizeof(phys_vec3);
        batch.gravity_step_stride = sizeof(phys_vec3);
        batch.states_stride = sizeof(phys_state);
        reset();
    }

    void reset() {
        phys_state start;
        phys_scene_start(&scene, &start);
        states.assign(kBalls, start);
        batch.states = states.data();
    }

    void run(phys_stepper *stepper, uint64_t first, uint64_t count) const {
        phys_error error;
        check(phys_batch_run(stepper, &batch, first, count, &error), error);
    }
};

ScenePointer openFloor(double radius) {
    constexpr double kFar = 1e3; // m
    const phys_box floor{{-kFar, -kFar, -1}, {kFar, kFar, 0}};
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.box_count = 1;
    description.boxes = &floor;
    description.radius = radius;
    description.start = {0, 0, radius};
    phys_error error;
    phys_scene *created = nullptr;
    check(phys_scene_create(&description, &created, &error), error);
    return ScenePointer(created);
}

double medianOf(const std::function<double()> &measure) {
    std::vector<double> rounds;
    rounds.reserve(kRounds);
    for (int round = 0; round < kRounds; ++round) rounds.push_back(measure());
    return median(rounds);
}

/// Millions of steps a second of CPU time on one thread.
double rate(Balls &&balls) {
    const StepperPointer stepper = createStepper(PHYS_STEPPER_DEFAULT, balls.scene);
    return medianOf([&] {
        balls.reset();
        return 1e-6 * kBalls * kSteps / cpuTimeOf([&] { balls.run(stepper.get(), 0, kBalls); });
    });
}

/// Seconds of CPU time of the thread that takes longest.
double timeOn(uint64_t threads, Balls &balls) {
    balls.reset();
    std::vector<double> spent(threads);
    std::vector<std::thread> workers;
    const uint64_t share = kBalls / threads;
    for (uint64_t i = 0; i < threads; ++i) {
        workers.emplace_back([&, i] {
            const StepperPointer stepper = createStepper(PHYS_STEPPER_DEFAULT, balls.scene);
            spent[i] = cpuTimeOf([&] { balls.run(stepper.get(), i * share, share); });
        });
    }
    for (std::thread &worker : workers) worker.join();
    return *std::max_element(spent.begin(), spent.end());
}

double gainOfTwoThreads(const phys_scene &scene) {
    Balls balls(scene);
    return medianOf([&] {
        const double one = timeOn(1, balls);
        return one / timeOn(2, balls);
    });
}

constexpr unsigned kThreads = 2;

/// Seconds of CPU time per step when balls are stepped one after the other, each on its own board, each thread with its
/// own simulation.
double secondsPerStep(const EngineKind &kind, const Scene &scene) {
    constexpr unsigned kOfThem = 32; // a part of the balls: the time is proportional to their number
    std::array<double, kThreads> spent{};
    std::vector<std::thread> threads;
    for (unsigned thread = 0; thread < kThreads; ++thread) {
        threads.emplace_back([&, thread] {
            const auto engine = kind.make(scene, kStep);
            spent[thread] = cpuTimeOf([&] {
                for (unsigned ball = thread; ball < kOfThem; ball += kThreads) {
                    engine->place(scene.start);
                    for (const phys_vec3 &gravity : randomTilts(ball + 1, kSteps / kStepsPerTilt)) {
                        engine->setGravity(gravity);
                        engine->advance(kStep, kStepsPerTilt);
                    }
                }
            });
        });
    }
    for (std::thread &thread : threads) thread.join();
    return (spent[0] + spent[1]) / (kOfThem * kSteps);
}

void print(const char *what, double least, double measured) {
    std::printf("%-78s %8.1f %9.1f  %s\n", what, least, measured, measured >= least ? "met" : "MISSED");
}

/// rate: ours, million steps a second.
void printBeside(const std::vector<EngineKind> &kinds, const Scene &scene, const char *what, double least,
                 double rate) {
    if (kinds.empty())
        std::printf("%-78s not measured: engine missing\n", what);
    else
        print(what, least, secondsPerStep(kinds.front(), scene) * 1e6 * rate);
}

Scene roomyMaze() { return mazeScene(kMazeSizes.front(), kMazeSizes.front().seeds.front()); }

void printRates(const phys_scene &level) {
    const ScenePointer open = openFloor(phys_scene_radius(&level));
    std::printf("%-78s %8s %9s\n", "1,024 balls, 500 steps of 10 ms, a tilt of its own each 0.5 s for each", "at least",
                "measured");
    const double inLevel = rate(Balls(level));
    print("level 10, symplectic-euler, one thread, million steps a second", 12, inLevel);
    Balls inTheOpen(*open);
    inTheOpen.keepTilts();
    print("in the open, each tilted as at first, one thread, million steps a second", 100, rate(std::move(inTheOpen)));
    print("level 10, symplectic-euler, two threads, times as fast", 1.9, gainOfTwoThreads(level));
    printBeside(mujocoEngines(), topView(level),
                "level 10, symplectic-euler, times as fast as MuJoCo's mj_step in a loop", 100, inLevel);
    const Scene maze = roomyMaze();
    const ScenePointer roomy = createScene(maze);
    printBeside(chipmunkEngines(), maze, "roomy maze, frictionless, symplectic-euler, times as fast as Chipmunk",
                1 / 0.06, rate(Balls(*roomy, maze.rolls)));
}

/// For a profiler; prints the number of steps.
void runOnce(const Balls &balls) {
    const StepperPointer stepper = createStepper(PHYS_STEPPER_DEFAULT, balls.scene);
    balls.run(stepper.get(), 0, kBalls);
    std::printf("%llu\n", static_cast<unsigned long long>(kBalls) * kSteps);
}

void runInRoomyMaze() {
    const Scene maze = roomyMaze();
    const ScenePointer roomy = createScene(maze);
    runOnce(Balls(*roomy, maze.rolls));
}

void runInTheOpen(const phys_scene &level) {
    const ScenePointer open = openFloor(phys_scene_radius(&level));
    Balls balls(*open);
    balls.keepTilts();
    runOnce(balls);
}

/// The same sweep as in tests/bench/speed/sweep.py, with results of its own.
void sweep(phys_stepper *stepper, const phys_state &start) {
    constexpr uint64_t kMany = 1000;
    phys_params params;
    phys_params_init(&params, sizeof params);
    std::vector<phys_state> states(kMany, start);
    std::vector<uint64_t> done(kMany);
    std::vector<phys_status> statuses(kMany);
    std::vector<phys_vec3> gravity(kMany);
    std::vector<double> alongX(kMany);
    const std::vector<double> alongY(kMany, 0.05), strengths(kMany, kStrength);
    for (uint64_t i = 0; i < kMany; ++i) alongX[i] = -0.1 + 0.2 * static_cast<double>(i) / (kMany - 1);
    phys_gravities_from_tilts(kMany, alongX.data(), alongY.data(), strengths.data(), gravity.data());
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.ball_count = batch.step_count = kMany;
    batch.dt = kStep;
    batch.params = &params;
    batch.gravity = gravity.data();
    batch.gravity_ball_stride = sizeof(phys_vec3);
    batch.states = states.data();
    batch.states_stride = sizeof(phys_state);
    batch.steps_done = done.data();
    batch.statuses = statuses.data();
    phys_error error;
    check(phys_batch_run(stepper, &batch, 0, kMany, &error), error);
    for (const phys_status status : statuses) check(status, error);
}

void printSweep(const phys_scene &level) {
    const StepperPointer stepper = createStepper(PHYS_STEPPER_DEFAULT, level);
    phys_state start;
    phys_scene_start(&level, &start);
    std::printf("%.9f\n", medianOf([&] { return cpuTimeOf([&] { sweep(stepper.get(), start); }); }));
}

} // namespace

int main(int count, char **arguments) {
    const ScenePointer level = loadScene(kLevel);
    const std::string what = count == 2 ? arguments[1] : "";
    if (count == 1) {
        printRates(*level);
    } else if (what == "--sweep") {
        printSweep(*level);
    } else if (what == "--roomy") {
        runInRoomyMaze();
    } else if (what == "--open") {
        runInTheOpen(*level);
    } else {
        std::fputs("usage: bench_many [--sweep|--roomy|--open]\n", stderr);
        return 2;
    }
}
