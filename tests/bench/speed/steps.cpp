// SPDX-License-Identifier: MIT
// Google Benchmark rows: every stepper in the mazes and the ten levels, scene creation, and what each stage costs.
#include "peers/engine.h"
#include "support/board.h"
#include "support/maze_scenes.h"

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

namespace {

using namespace bench;

constexpr double kStep = 0.01; // s

using Work = std::function<void(benchmark::State &)>;

void addRow(const std::string &name, const Work &work) {
    benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State &state) {
        try {
            work(state);
        } catch (const std::exception &problem) {
            state.SkipWithError(problem.what());
        }
    });
}

benchmark::Counter perUnit(double units) {
    return {units, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

std::vector<phys_stepper_info> steppers() {
    std::vector<phys_stepper_info> all(phys_registry_count(nullptr));
    for (uint32_t index = 0; index < all.size(); ++index) phys_registry_info(nullptr, index, &all[index]);
    return all;
}

// --------------------------------------------------------------------------------------------------- whole runs --

// One row: a frictionless run of 10 s in one maze.
void addMazeRow(const EngineKind &kind, const MazeSize &size, double dt) {
    char name[100];
    std::snprintf(name, sizeof name, "maze/%d walls/%s/%g ms", size.walls, kind.name.c_str(), dt * 1e3);
    addRow(name, [kind, &size, dt](benchmark::State &state) {
        const Scene scene = mazeScene(size, size.seeds.front());
        const auto engine = kind.make(scene, dt);
        for ([[maybe_unused]] auto _ : state) run(*engine, scene, dt);
        state.counters["s/step"] = perUnit(scene.duration / dt);
        state.counters["s/simulated s"] = perUnit(scene.duration);
    });
}

struct ModelRow {
    const char *name;
    uint32_t model;
};
constexpr ModelRow kModels[] = {{"rolling", PHYS_MODEL_ROLLING}, {"rigid", PHYS_MODEL_RIGID}};

phys_params paramsOf(const phys_stepper_info &info, uint32_t model) {
    phys_params params;
    phys_params_init(&params, sizeof params);
    phys_stepper_info_init_params(&info, &params);
    params.model = model;
    return params;
}

// As the game plays it: default parameters, 10 s from the start, the same tilts everywhere.
void addLevelRow(int level, const phys_stepper_info &info, const ModelRow &model) {
    char name[100];
    std::snprintf(name, sizeof name, "level/%02d/%s/%s", level, info.id, model.name);
    addRow(name, [level, info, model](benchmark::State &state) {
        char file[20];
        std::snprintf(file, sizeof file, "/%02d.txt", level);
        const ScenePointer scene = loadScene(std::string(BENCH_LEVELS) + file);
        const StepperPointer stepper = createStepper(info.id, *scene);
        const std::vector<phys_vec3> tilts = randomTilts(1, 20);
        constexpr int kStepsPerTilt = 50;
        phys_params params = paramsOf(info, model.model);
        for ([[maybe_unused]] auto _ : state) {
            phys_state ball;
            phys_scene_start(scene.get(), &ball);
            for (const phys_vec3 &gravity : tilts) {
                params.gravity = gravity;
                for (int step = 0; step < kStepsPerTilt; ++step) {
                    phys_error error;
                    check(phys_step(stepper.get(), &params, kStep, &ball, &ball, nullptr, &error), error);
                }
            }
            benchmark::DoNotOptimize(ball);
        }
        state.counters["s/step"] = perUnit(static_cast<double>(tilts.size()) * kStepsPerTilt);
    });
}

// ------------------------------------------------------------------------------------------------ scene creation --

void addCreationRow(const MazeSize &size) {
    addRow("scene/" + std::to_string(size.walls) + " walls", [&size](benchmark::State &state) {
        const Scene scene = mazeScene(size, size.seeds.front());
        const std::size_t before = mallinfo2().uordblks;
        const ScenePointer kept = createScene(scene);
        state.counters["bytes"] = static_cast<double>(mallinfo2().uordblks - before);
        for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(createScene(scene));
    });
}

// -------------------------------------------------------------------------------------------------------- stages --

// The same step twice, once where it needs the stage and once where it doesn't; default stepper, 10 ms.
struct StageCase {
    const char *name;
    uint32_t stage;
    void (*ask)(phys_params &, phys_state &);
    void (*spare)(phys_params &, phys_state &);
};

void nothing(phys_params &, phys_state &) {}

const StageCase kStageCases[] = {
    {"resistance", PHYS_STAGE_RESISTANCE, [](phys_params &params, phys_state &) { params.rolling_friction = 0.003; },
     [](phys_params &params, phys_state &) { params.rolling_friction = 0; }},
    {"orientation", PHYS_STAGE_ORIENTATION,
     [](phys_params &params, phys_state &) { params.options |= PHYS_OPTION_ORIENTATION; }, nothing},
    {"slip", PHYS_STAGE_SLIP,
     [](phys_params &params, phys_state &ball) {
         params.model = PHYS_MODEL_RIGID, ball.spin = {0, 0, 0};
     },
     [](phys_params &params, phys_state &) { params.model = PHYS_MODEL_RIGID; }},
    {"vertical motion", PHYS_STAGE_VERTICAL, [](phys_params &, phys_state &ball) { ball.position.z += 0.1; }, nothing},
    {"substeps (9)", PHYS_STAGE_SUBSTEPS, [](phys_params &, phys_state &ball) { ball.velocity.x *= 200; }, nothing},
    {"grid", PHYS_STAGE_GRID, nothing, nothing}, // follows from the scene: one wall more
    {"all", 0, [](phys_params &params, phys_state &) { params.options |= PHYS_OPTION_ALL_STAGES; }, nothing},
};

// Four walls are few enough to test each of them; five need the grid.
Scene roomScene(bool needsGrid) {
    Scene scene;
    scene.walls = {{-2.2, -2, -2, 2}, {2, -2, 2.2, 2}, {-2.2, -2.2, 2.2, -2}, {-2.2, 2, 2.2, 2.2}};
    if (needsGrid) scene.walls.push_back({3, -2, 3.2, 2});
    return scene;
}

Scene sceneOf(const StageCase &stage, bool runs) {
    if (stage.stage == PHYS_STAGE_GRID) return roomScene(runs);
    return mazeScene(kMazeSizes.front(), kMazeSizes.front().seeds.front());
}

// Rolls along x in the middle of a cell, no wall in reach.
phys_state rollingBall(const phys_scene &scene) {
    phys_state ball;
    phys_scene_start(&scene, &ball);
    ball.velocity = {0.5, 0, 0};
    ball.spin = {0, 0.5 / phys_scene_radius(&scene), 0};
    return ball;
}

void addStageRow(const StageCase &stage, bool runs) {
    addRow(std::string("stage/") + stage.name + (runs ? "/run" : "/left out"), [&stage, runs](benchmark::State &state) {
        const ScenePointer scene = createScene(sceneOf(stage, runs));
        const StepperPointer stepper = createStepper(PHYS_STEPPER_DEFAULT, *scene);
        phys_stepper_info info;
        phys_error error;
        check(phys_registry_find(nullptr, PHYS_STEPPER_DEFAULT, &info, &error), error);
        phys_params params = paramsOf(info, PHYS_MODEL_ROLLING);
        params.rolling_friction = 0;
        phys_gravity_from_tilt(0.02, 0.01, kStrength, &params.gravity);
        phys_state ball = rollingBall(*scene);
        (runs ? stage.ask : stage.spare)(params, ball);
        phys_requirements required;
        check(phys_stepper_requirements(stepper.get(), &params, kStep, &ball, &required, &error), error);
        if (stage.stage != 0 && ((required.stages & stage.stage) != 0) != runs) {
            state.SkipWithError("the step doesn't run the stages that this row is about");
            return;
        }
        phys_state next;
        for ([[maybe_unused]] auto _ : state) {
            check(phys_step(stepper.get(), &params, kStep, &ball, &next, nullptr, &error), error);
            benchmark::DoNotOptimize(next);
        }
    });
}

void addAllRows() {
    for (const MazeSize &size : kMazeSizes)
        for (const EngineKind &kind : ourEngines()) {
            addMazeRow(kind, size, kStep);
            if (kind.exactInDt) addMazeRow(kind, size, 0.5);
        }
    constexpr int kLevels = 10;
    for (int level = 1; level <= kLevels; ++level)
        for (const phys_stepper_info &info : steppers())
            for (const ModelRow &model : kModels) addLevelRow(level, info, model);
    for (const MazeSize &size : kMazeSizes) addCreationRow(size);
    for (const StageCase &stage : kStageCases)
        for (const bool runs : {false, true}) addStageRow(stage, runs);
}

} // namespace

int main(int count, char **arguments) {
    addAllRows();
    benchmark::Initialize(&count, arguments);
    if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
