// SPDX-License-Identifier: MIT
#include "trial.h"

#include "support/state_difference.h"
#include "witness/draw.h"
#include "witness/judge.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>
#include <thread>
#include <vector>

namespace plugin_check {

namespace {

using witness::Case;

constexpr double kDuration = 0.5; // s
constexpr int kStarts = 6;
constexpr std::array<int, 3> kStepCounts{50, 200, 800};

/// Adds the distances to the brute force's end, for each number of steps; a line if a run fails.
std::string addErrors(const Subject &subject, const Case &scene, std::array<double, 3> &errors) {
    witness::BruteForce force(scene.boxes, scene.radius);
    witness::Motion motion = {witness::vectorOf(scene.start.position), witness::vectorOf(scene.start.velocity),
                              witness::vectorOf(scene.start.spin)};
    phys_params params = scene.params;
    params.gravity = scene.legs[0].gravity;
    if (!force.run(witness::lawOf(params, scene.radius), kDuration, motion)) return "no reference";
    for (size_t i = 0; i < errors.size(); ++i) {
        Run run(subject, scene);
        for (int step = 0; step < kStepCounts[i]; ++step) run.step(kDuration / kStepCounts[i]);
        if (run.status()) return run.why();
        errors[i] += static_cast<double>(length(witness::vectorOf(run.state.position) - motion.place));
    }
    return {};
}

/// The order of convergence in a scene of half a second, compared with the brute force: of the mean over starts that
/// differ by parts of a step's way, because the error of an impact depends on where in its step it falls.
Measure orderIn(const Subject &subject, Case scene) {
    scene.legs[0].dt = kDuration;
    const phys_vec3 first = scene.start.position;
    const double way = scene.start.velocity.x * kDuration / kStepCounts[0]; // of the longest step
    std::array<double, 3> errors{};
    for (int start = 0; start < kStarts; ++start) {
        scene.start.position.x = first.x - start * way / kStarts;
        const std::string problem = addErrors(subject, scene, errors);
        if (!problem.empty()) return {true, problem};
    }
    for (double &error : errors) error /= kStarts;
    const std::string figures =
        format("errors %.2g, %.2g, %.2g m with 10, 2.5, 0.625 ms", errors[0], errors[1], errors[2]);
    if (errors[2] < 1e-9) return {false, "none is left: " + figures};
    const double order = std::log2(errors[0] / errors[2]) / 4;
    return {order < 0.5,
            (order < 0.5 ? "doesn't converge to the law's motion: " : format("order %.1f: ", order)) + figures};
}

} // namespace

Measure smoothMotion(const Subject &subject) {
    Case scene = board(PHYS_MODEL_ROLLING);
    scene.params.rolling_friction = 0.01;
    scene.legs[0].gravity = {0.8, -0.5, -9.7};
    roll(scene, -0.1, 0.15);
    return orderIn(subject, scene);
}

Measure impacts(const Subject &subject) {
    Case scene = board(PHYS_MODEL_ROLLING);
    scene.params.restitution_wall = 0.6;
    scene.boxes.push_back({{0.05, -1, 0}, {0.06, 1, 0.05}});
    scene.boxes.push_back({{-0.06, -1, 0}, {-0.05, 1, 0.05}});
    scene.legs[0].gravity = {0.4, 0.2, -9.79};
    roll(scene, 0.37, 0.05);
    Measure rolling = orderIn(subject, scene);
    if (rolling.isWrong || modelOf(subject) == PHYS_MODEL_ROLLING) return rolling;
    scene.params.model = PHYS_MODEL_RIGID;
    scene.params.wall_friction = 0.2;
    Measure rigid = orderIn(subject, scene);
    rigid.text = "rigid, rough walls: " + rigid.text;
    return rigid.isWrong ? rigid : rolling;
}

Measure invariants(const Subject &subject) {
    std::map<std::string, std::string> found; // by check: the first one of each
    std::map<std::string, int> refused;
    int runs = 0;
    for (uint64_t seed = 1; seed <= 5; ++seed) {
        for (const char *kind : {"boxes", "thin", "roof", "gap", "room", "kerb", "tiles"}) {
            for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
                size_t index = 0;
                while (witness::kinds()[index] != kind) ++index;
                const Case scene = witness::drawCase(index, seed, model);
                const witness::Verdict verdict = witness::examine(subject.registry, subject.id, scene);
                ++runs;
                if (verdict.status) ++refused[phys_status_name(verdict.status)];
                if (verdict.check.empty() || found.count(verdict.check)) continue;
                found[verdict.check] = std::string("--seed ") + std::to_string(seed) + " --kind " + kind + " --model " +
                                       (model ? "rigid" : "rolling") + ": " + verdict.what;
            }
        }
    }
    Measure measure;
    measure.isWrong = !found.empty() || refused.count(phys_status_name(PHYS_ERROR_PLUGIN_RESULT));
    measure.text = format("%g scenes", runs);
    for (const auto &[check, what] : found) measure.text.append("\n        ").append(check).append(": ").append(what);
    for (const auto &[status, count] : refused)
        measure.text += "\n        refused with " + status + ": " + std::to_string(count);
    return measure;
}

Measure law(const Subject &subject) {
    int compared = 0;
    int wrong = 0;
    std::string first;
    for (uint64_t seed = 1; seed <= 4; ++seed) {
        for (const char *kind : {"boxes", "thin", "gap", "pressed"}) {
            size_t index = 0;
            while (witness::kinds()[index] != kind) ++index;
            const Case scene = witness::drawSmoothCase(index, seed, seed % 2 ? PHYS_MODEL_RIGID : PHYS_MODEL_ROLLING);
            const std::optional<witness::Truth> truth = witness::Truth::of(scene);
            if (!truth) continue;
            const witness::Verdict verdict = witness::judgeLaw(subject.registry, subject.id, scene, *truth);
            ++compared;
            if (verdict.check.empty()) continue;
            if (!wrong++) first = "; " + scene.name + ": " + verdict.what;
        }
    }
    return {wrong > 0, format("goes elsewhere in %g of %g scenes", wrong, compared) + first};
}

Measure energyAtRest(const Subject &subject) {
    double worst = 0;
    for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
        Run run(subject, board(model));
        const double before = run.energy();
        for (int i = 0; i < 1000; ++i) run.step(0.01);
        if (run.status() == PHYS_ERROR_UNSUPPORTED && modelOf(subject) != model) continue; // reported under invariants
        if (run.status()) return {true, run.why()};
        worst = std::max(worst, std::abs(run.energy() - before));
    }
    return {worst > 1e-9, format("changes by %.2g J/kg in 10 s", worst)};
}

Measure energyPerBounce(const Subject &subject) {
    Case scene = board(PHYS_MODEL_ROLLING);
    scene.params.restitution_wall = 1;
    scene.params.rolling_friction = 0;
    scene.boxes.push_back({{0.05, -1, 0}, {0.06, 1, 0.05}});
    scene.start.velocity = {0.3, 0, 0};
    scene.start.spin = {0, 0.3 / 0.006, 0};
    Run run(subject, scene);
    const double before = run.energy();
    for (int i = 0; i < 30; ++i) run.step(0.01);
    if (run.status()) return {true, run.why()};
    const double change = (run.energy() - before) / before;
    return {change > 1e-9, format("changes by the part %.2g at restitution 1", change)};
}

Measure tunnelling(const Subject &subject) {
    for (int doubling = 0; doubling < 23; ++doubling) {
        const double speed = std::ldexp(0.1, doubling);
        Case scene = board(PHYS_MODEL_ROLLING);
        scene.boxes = {{{-100, -100, -1}, {100, 100, 0}}, {{0.05, -100, 0}, {0.051, 100, 10}}};
        scene.start.velocity = {speed, 0, 0};
        scene.start.spin = {0, speed / 0.006, 0};
        Run run(subject, scene);
        for (int i = 0; i < 100; ++i) {
            if (run.step(0.01) && i == 0 && run.state.position.x == 0)
                return {true, format("stands still at %.3g m/s", speed)};
            if (run.state.position.x > 0.05)
                return {true, format("through 1 mm of wall at %.3g m/s, steps of 10 ms", speed)};
        }
        if (run.status()) return {false, format("none up to %.3g m/s, then ", speed) + run.why()};
    }
    return {false, "none up to 800 km/s"};
}

Measure threads(const Subject &subject) {
    const Case scene = witness::drawSmoothCase(0, 3, modelOf(subject));
    std::array<phys_state, 5> ends{};
    const auto work = [&](size_t index) {
        Run run(subject, scene);
        for (int i = 0; i < 200; ++i) run.step(0.002);
        ends[index] = run.state;
    };
    work(0);
    std::vector<std::thread> all;
    for (size_t i = 1; i < ends.size(); ++i) all.emplace_back(work, i);
    for (std::thread &thread : all) thread.join();
    for (const phys_state &end : ends) {
        const std::string difference = support::firstDifference(ends[0], end);
        if (!difference.empty()) return {true, "other bits in a repeat on another thread: " + difference};
    }
    return {false, "same bits in a repeat and on four threads"};
}

Measure extremes(const Subject &subject) {
    Measure measure;
    const auto look = [&](const char *name, const Case &scene, double dt) {
        Run run(subject, scene);
        for (int i = 0; i < 3; ++i) run.step(dt);
        const phys_vec3 &p = run.state.position;
        const bool isFine = std::isfinite(p.x) && std::isfinite(p.y) && p.z > 0.99 * scene.radius;
        const bool isRefused = run.status() != PHYS_OK;
        if (!isFine || run.status() == PHYS_ERROR_PLUGIN_RESULT) measure.isWrong = true;
        measure.text += (measure.text.empty() ? "" : ", ") + std::string(name) +
                        (isRefused ? std::string(" ") + phys_status_name(run.status())
                         : isFine  ? " ok"
                                   : " through the floor");
    };
    Case scene = board(modelOf(subject));
    scene.start.velocity = {0.1, 0, 0};
    look("1 ns", scene, 1e-9);
    look("1 s", scene, 1.0);
    Case fast = scene;
    fast.boxes = {{{-1e3, -1e3, -1}, {1e3, 1e3, 0}}}; // it goes 300 m
    fast.start.velocity = {1e4, 0, 0};
    look("10 km/s", fast, 0.01);
    Case small = scene;
    small.radius = 1e-6;
    small.start.position.z = 1e-6;
    look("1 um of ball", small, 1e-3);
    Case large = scene;
    large.boxes = {{{-1e6, -1e6, -1e3}, {1e6, 1e6, 0}}};
    large.radius = 1e3;
    large.start.position.z = 1e3;
    look("1 km of ball", large, 1.0);
    return measure;
}

/// Invalid calls end with a status, and nothing is written.
Measure misuse(const Subject &subject) {
    const Case scene = board(modelOf(subject));
    Measure measure{false, "refused, outputs untouched"};
    const auto refuses = [&](const char *what, double dt, const std::function<void(Run &)> &spoil) {
        Run run(subject, scene);
        spoil(run);
        const phys_state before = run.state;
        if (!run.step(dt) && isSame(before, run.state)) return;
        measure = {true, std::string(what) + " isn't refused"};
    };
    refuses("a time step below zero", -0.01, [](Run &) {});
    refuses("a time step that isn't a number", std::nan(""), [](Run &) {});
    refuses("a place that isn't a number", 0.01, [](Run &run) { run.state.position.x = std::nan(""); });
    refuses("restitution 2", 0.01, [](Run &run) { run.params.restitution_wall = 2; });
    return measure;
}

namespace {

/// The time of one step in the smallest of three runs, of 0.2 s or 2000 steps each, s; 0 and why if one fails.
double secondsPerStep(const Subject &subject, const Case &scene, std::string &why) {
    double best = 1e300;
    int count = 1;
    for (int repeat = 0; repeat < 4; ++repeat) { // the first one is for `count`
        Run run(subject, scene);
        run.state.velocity = {0.3, 0, 0};
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < count; ++i) run.step(0.001);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        if (run.status()) why = run.why();
        best = std::min(best, taken.count() / count);
        count = static_cast<int>(std::clamp(0.2 / best, 1.0, 2000.0));
    }
    return why.empty() ? best : 0;
}

} // namespace

/// Its text begins with the nanoseconds that a step takes.
Measure cost(const Subject &subject) {
    Case scene = board(PHYS_MODEL_ROLLING);
    scene.boxes = {{{-1, -1, -0.1}, {1, 1, 0}}, {{0.05, -1, 0}, {0.06, 1, 0.05}}, {{-0.06, -1, 0}, {-0.05, 1, 0.05}}};
    scene.params.restitution_wall = 1;
    scene.params.rolling_friction = 0;
    std::string why;
    Measure measure{false, format("%.0f ns a step; beside it", 1e9 * secondsPerStep(subject, scene, why))};
    if (!why.empty())
        return {true, "nothing else is asked, because a ball that rolls between two walls ends with " + why};
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(nullptr, i, &info) == PHYS_OK; ++i) {
        const double other = secondsPerStep({nullptr, info.id}, scene, why);
        measure.text += std::string(" ") + info.id + format(" %.0f", 1e9 * other);
    }
    return measure;
}

} // namespace plugin_check
