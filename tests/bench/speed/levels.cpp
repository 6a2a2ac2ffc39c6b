// SPDX-License-Identifier: MIT
// Typical scenes: the ten levels, default parameters, a new random tilt each half second, so that the ball leans, rolls
// along walls and rests. Single steps, batches and Chipmunk are measured in turn, by the thread's CPU time.
#include "peers/engine.h"
#include "support/board.h"
#include "support/cpu_clock.h"
#include "support/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>

namespace {

using namespace bench;

constexpr double kStep = 0.01; // s
constexpr int kLevels = 10;
constexpr int kTilts = 40;
constexpr int kStepsPerTilt = 50;
constexpr int kSteps = kTilts * kStepsPerTilt;
constexpr uint64_t kBalls = 64; // of a batch: each has a tilt of its own
constexpr uint64_t kBatchSteps = 500;
constexpr int kRounds = 9;

struct Level {
    ScenePointer scene;
    Scene seenFromAbove; // for engines in two dimensions
    std::vector<phys_vec3> tilts;
};

Level levelOf(int number) {
    char file[20];
    std::snprintf(file, sizeof file, "/%02d.txt", number);
    Level level{loadScene(std::string(BENCH_LEVELS) + file), {}, randomTilts(static_cast<unsigned>(number), kTilts)};
    level.seenFromAbove = topView(*level.scene);
    return level;
}

/// What is measured: seconds of CPU time a step on one level.
struct Contender {
    std::string name;
    uint64_t steps; ///< that are made on a level
    std::function<double(const Level &)> secondsPerStep;
};

phys_params paramsOf(const char *id, uint32_t model, uint32_t options) {
    phys_stepper_info info;
    phys_error error;
    check(phys_registry_find(nullptr, id, &info, &error), error);
    phys_params params;
    phys_params_init(&params, sizeof params);
    phys_stepper_info_init_params(&info, &params);
    params.model = model;
    params.options = options;
    return params;
}

struct Way {
    const char *id;
    uint32_t model;
    uint32_t options;
    bool reports;
};

/// Makes `count` steps of dt under each tilt, which together last as long as the tilt; returns seconds per kStep of
/// motion.
double stepTilts(const Way &way, const Level &level, double dt, int count) {
    const StepperPointer stepper = createStepper(way.id, *level.scene);
    phys_params params = paramsOf(way.id, way.model, way.options);
    phys_event events[64];
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = events;
    report.event_capacity = 64;
    phys_state ball;
    phys_scene_start(level.scene.get(), &ball);
    phys_error error;
    const double spent = cpuTimeOf([&] {
        for (const phys_vec3 &gravity : level.tilts) {
            params.gravity = gravity;
            for (int step = 0; step < count; ++step) {
                check(phys_step(stepper.get(), &params, dt, &ball, &ball, way.reports ? &report : nullptr, &error),
                      error);
            }
        }
    });
    return spent / kSteps;
}

double stepOneByOne(const Way &way, const Level &level) { return stepTilts(way, level, kStep, kStepsPerTilt); }

double stepOncePerTilt(const Way &way, const Level &level) { return stepTilts(way, level, kStep * kStepsPerTilt, 1); }

double stepAsBatch(const Way &way, const Level &level) {
    const StepperPointer stepper = createStepper(way.id, *level.scene);
    const phys_params params = paramsOf(way.id, way.model, way.options);
    std::vector<phys_state> states(kBalls);
    for (phys_state &state : states) phys_scene_start(level.scene.get(), &state);
    std::vector<phys_vec3> gravity; // each ball begins with another of the tilts
    for (uint64_t ball = 0; ball < kBalls; ++ball) {
        for (uint64_t step = 0; step < kBatchSteps; ++step) {
            gravity.push_back(level.tilts[(ball * 7 + step / kStepsPerTilt) % level.tilts.size()]);
        }
    }
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.ball_count = kBalls;
    batch.step_count = kBatchSteps;
    batch.dt = kStep;
    batch.params = &params;
    batch.gravity = gravity.data();
    batch.gravity_ball_stride = kBatchSteps * sizeof(phys_vec3);
    batch.gravity_step_stride = sizeof(phys_vec3);
    batch.states = states.data();
    batch.states_stride = sizeof(phys_state);
    phys_error error;
    const double spent = cpuTimeOf([&] { check(phys_batch_run(stepper.get(), &batch, 0, kBalls, &error), error); });
    return spent / (kBalls * kBatchSteps);
}

double stepEngine(const EngineKind &kind, const Level &level) {
    const auto engine = kind.make(level.seenFromAbove, kStep);
    engine->place(level.seenFromAbove.start);
    const double spent = cpuTimeOf([&] {
        for (const phys_vec3 &gravity : level.tilts) {
            engine->setGravity(gravity);
            engine->advance(kStep, kStepsPerTilt);
        }
    });
    return spent / kSteps;
}

std::vector<Contender> contenders() {
    std::vector<Contender> all;
    const auto add = [&](const char *name, const Way &way, double (*step)(const Way &, const Level &)) {
        const uint64_t steps = step == stepAsBatch ? kBalls * kBatchSteps : kSteps;
        all.push_back({name, steps, [way, step](const Level &level) { return step(way, level); }});
    };
    for (const EngineKind &kind : chipmunkEngines()) {
        all.push_back({kind.name, kSteps, [kind](const Level &level) { return stepEngine(kind, level); }});
    }
    add("symplectic-euler", {"symplectic-euler", PHYS_MODEL_ROLLING, 0, false}, stepOneByOne);
    add("velocity-verlet", {"velocity-verlet", PHYS_MODEL_ROLLING, 0, false}, stepOneByOne);
    add("swept", {"swept", PHYS_MODEL_ROLLING, 0, false}, stepOneByOne);
    add("exact", {"exact", PHYS_MODEL_ROLLING, 0, false}, stepOneByOne);
    add("exact, a call a tilt", {"exact", PHYS_MODEL_ROLLING, 0, false}, stepOncePerTilt);
    add("symplectic-euler, report", {"symplectic-euler", PHYS_MODEL_ROLLING, PHYS_OPTION_ORIENTATION, true},
        stepOneByOne);
    add("symplectic-euler, turned", {"symplectic-euler", PHYS_MODEL_ROLLING, PHYS_OPTION_ORIENTATION, false},
        stepOneByOne);
    add("symplectic-euler, rigid", {"symplectic-euler", PHYS_MODEL_RIGID, 0, false}, stepOneByOne);
    add("exact, rigid", {"exact", PHYS_MODEL_RIGID, 0, false}, stepOneByOne);
    add("symplectic-euler, batch", {"symplectic-euler", PHYS_MODEL_ROLLING, 0, false}, stepAsBatch);
    add("swept, batch", {"swept", PHYS_MODEL_ROLLING, 0, false}, stepAsBatch);
    return all;
}

/// Medians over the rounds, of each contender on each level; NAN where it fails.
std::map<std::string, std::vector<double>> measure(const std::vector<Level> &levels) {
    std::map<std::string, std::vector<double>> medians;
    const std::vector<Contender> all = contenders();
    for (const Level &level : levels) {
        std::vector<std::vector<double>> rounds(all.size());
        for (int round = 0; round < kRounds; ++round) {
            for (size_t i = 0; i < all.size(); ++i) {
                try {
                    all[i].secondsPerStep(level); // the contender before it has taken caches and branch prediction
                    rounds[i].push_back(all[i].secondsPerStep(level));
                } catch (const std::exception &problem) {
                    if (round == 0) std::fprintf(stderr, "%s: %s\n", all[i].name.c_str(), problem.what());
                    rounds[i].push_back(NAN);
                }
            }
        }
        for (size_t i = 0; i < all.size(); ++i) medians[all[i].name].push_back(median(rounds[i]));
    }
    return medians;
}

double geometricMeanOfRatios(const std::vector<double> &ours, const std::vector<double> &theirs) {
    double sum = 0.0;
    for (size_t i = 0; i < ours.size(); ++i) sum += std::log(ours[i] / theirs[i]);
    return std::exp(sum / static_cast<double>(ours.size()));
}

struct Target {
    const char *name;
    double ratio; ///< to Chipmunk's step, built without assertions
};
constexpr Target kTargets[] = {{"symplectic-euler", 0.25},
                               {"velocity-verlet", 0.28},
                               {"swept", 0.6},
                               {"exact", NAN},
                               {"exact, a call a tilt", NAN},
                               {"symplectic-euler, report", 0.4},
                               {"symplectic-euler, rigid", 0.4},
                               {"exact, rigid", 1.5},
                               {"symplectic-euler, batch", 0.12},
                               {"swept, batch", 0.4}};

void print(const std::map<std::string, std::vector<double>> &medians) {
    std::printf("%-26s", "ns a step");
    for (int level = 1; level <= kLevels; ++level) std::printf(" %5d", level);
    std::printf("   ratio  target\n");
    const auto chipmunk = medians.find("chipmunk");
    const auto row = [&](const char *name, const std::vector<double> &seconds, double target) {
        std::printf("%-26s", name);
        for (const double second : seconds) std::printf(" %5.0f", second * 1e9);
        if (chipmunk == medians.end()) {
            std::printf("   not measured: engine missing\n");
            return;
        }
        const double ratio = geometricMeanOfRatios(seconds, chipmunk->second);
        std::printf("  %6.2f", ratio);
        if (!std::isnan(target)) std::printf("  %6.2f %s", target, ratio <= target ? "met" : "MISSED");
        std::printf("\n");
    };
    if (chipmunk != medians.end()) row("chipmunk", chipmunk->second, NAN);
    for (const Target &target : kTargets) row(target.name, medians.at(target.name), target.ratio);

    constexpr double kMostForOrientation = 20e-9; // s
    std::vector<double> orientation;
    const std::vector<double> &turned = medians.at("symplectic-euler, turned");
    const std::vector<double> &unturned = medians.at("symplectic-euler");
    std::transform(turned.begin(), turned.end(), unturned.begin(), std::back_inserter(orientation), std::minus<>());
    const double mean = std::accumulate(orientation.begin(), orientation.end(), 0.0) / kLevels;
    std::printf("%-26s", "orientation alone");
    for (const double second : orientation) std::printf(" %5.0f", second * 1e9);
    std::printf("   mean %.0f ns, at most %.0f ns: %s\n", mean * 1e9, kMostForOrientation * 1e9,
                mean <= kMostForOrientation ? "met" : "MISSED");
}

} // namespace

/// Runs one contender on all levels and does nothing else, for a profiler; prints the number of steps.
int runOnly(const std::string &name, const std::vector<Level> &levels) {
    const std::vector<Contender> all = contenders();
    const auto chosen = std::find_if(all.begin(), all.end(), [&](const Contender &each) { return each.name == name; });
    if (chosen == all.end()) {
        std::fprintf(stderr, "bench_levels: there is no '%s'\n", name.c_str());
        return 2;
    }
    for (const Level &level : levels) chosen->secondsPerStep(level);
    std::printf("%llu\n", static_cast<unsigned long long>(chosen->steps) * levels.size());
    return 0;
}

int main(int count, char **arguments) {
    std::vector<Level> levels;
    for (int number = 1; number <= kLevels; ++number) levels.push_back(levelOf(number));
    if (count == 3 && std::strcmp(arguments[1], "--only") == 0) return runOnly(arguments[2], levels);
    if (count > 1) {
        std::fputs("usage: bench_levels [--only NAME]\n", stderr);
        return 2;
    }
    const auto medians = measure(levels);
    std::printf(
        "The ten levels, default parameters, steps of 10 ms, a new tilt within 5 degrees each 0.5 s; batches of %llu "
        "balls;\nmedians of %d rounds in turns, CPU time of the thread; ratio: to Chipmunk (" BENCH_CHIPMUNK "), "
        "geometric mean.\n\n",
        static_cast<unsigned long long>(kBalls), kRounds);
    print(medians);
}
