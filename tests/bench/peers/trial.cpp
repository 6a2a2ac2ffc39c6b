// SPDX-License-Identifier: MIT
#include "peers/trial.h"

#include "reference/event_driven.h"
#include "support/cpu_clock.h"
#include "support/maze_scenes.h"
#include "support/scenes.h"
#include "support/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iterator>
#include <map>

namespace bench {

namespace {

constexpr double kSteps[] = {1.0 / 60, 0.01, 0.005, 0.002, 0.001, 0.0005, 0.0001}; // s
constexpr int kRepeats = 5;
constexpr double kLongRun = 2;     // s of CPU: longer runs aren't repeated
constexpr double kLongestRun = 25; // s of CPU: longer runs are skipped

// One engine in every scene of a group.
struct Candidate {
    const EngineKind *kind;
    Trial trial;
    std::vector<std::unique_ptr<Engine>> engines;
    std::vector<double> seconds; // one run through all scenes, for each repeat
};

double simulatedTime(const SceneGroup &group) {
    double total = 0;
    for (const Scene &scene : group.scenes) total += scene.duration;
    return total;
}

double stepsIn(const SceneGroup &group, double dt) {
    double steps = 0;
    for (const Scene &scene : group.scenes)
        steps += static_cast<double>(scene.gravity.size()) * std::max(1.0, std::round(scene.tiltPeriod / dt));
    return steps;
}

SceneError errorOf(Engine &engine, const Scene &scene, const Passage &truth, double dt) {
    SceneError error;
    const int steps = std::max(1, static_cast<int>(std::lround(scene.tiltPeriod / dt)));
    try {
        engine.place(scene.start);
        for (std::size_t period = 0; period < scene.gravity.size(); ++period) {
            engine.setGravity(scene.gravity[period]);
            engine.advance(scene.tiltPeriod / steps, steps);
            error.last = engine.ball();
            error.final = distance(error.last.position, truth.balls[period].position) / scene.radius;
            error.largest = std::max(error.largest, error.final);
        }
        if (!std::isfinite(error.final)) error.failure = "position is not a number";
    } catch (const std::exception &problem) {
        error.failure = problem.what();
    }
    return error;
}

// The first run measures the errors, and how long further runs will take.
void start(Candidate &candidate, const SceneGroup &group, const std::vector<Passage> &truths) {
    double seconds = 0;
    for (std::size_t index = 0; index < group.scenes.size(); ++index) {
        const Scene &scene = group.scenes[index];
        try {
            candidate.engines.push_back(candidate.kind->make(scene, candidate.trial.dt));
        } catch (const std::exception &problem) {
            SceneError error;
            error.failure = problem.what();
            candidate.trial.errors.push_back(error);
            continue;
        }
        Engine &engine = *candidate.engines.back();
        SceneError error;
        seconds += cpuTimeOf([&] { error = errorOf(engine, scene, truths[index], candidate.trial.dt); });
        candidate.trial.errors.push_back(error);
    }
    candidate.seconds.push_back(seconds);
}

void repeat(Candidate &candidate, const SceneGroup &group) {
    if (!candidate.trial.answered() || candidate.seconds.front() > kLongRun) return;
    candidate.seconds.push_back(cpuTimeOf([&] {
        for (std::size_t index = 0; index < group.scenes.size(); ++index)
            run(*candidate.engines[index], group.scenes[index], candidate.trial.dt);
    }));
}

void finish(Candidate &candidate, const SceneGroup &group) {
    const double seconds = median(candidate.seconds);
    candidate.trial.secondsPerStep = seconds / stepsIn(group, candidate.trial.dt);
    candidate.trial.secondsPerSimulated = seconds / simulatedTime(group);
    candidate.trial.spread = relativeSpread(candidate.seconds);
}

Trial trialOf(const SceneGroup &group, const EngineKind &kind, double dt) {
    Trial trial;
    trial.group = group.name;
    trial.engine = kind.name;
    trial.ours = kind.ours;
    trial.dt = dt;
    return trial;
}

class GroupMeasurement {
public:
    GroupMeasurement(const SceneGroup &group, const std::vector<EngineKind> &engines, const Progress &progress)
        : m_group(group)
        , m_engines(engines)
        , m_progress(progress) {
        for (const Scene &scene : group.scenes) m_truths.push_back(eventDriven<long double>(scene));
    }

    std::vector<Trial> run() {
        for (const double dt : kSteps) measureStep(dt, false);
        measureStep(m_group.scenes.front().tiltPeriod, true);
        return std::move(m_trials);
    }

private:
    // Runs all engines in turn. `leaping`: only those for which a single step of any length is as accurate as many.
    void measureStep(double dt, bool leaping) {
        std::vector<Candidate> candidates;
        for (const EngineKind &kind : m_engines) {
            if (leaping && !kind.exactInDt) continue;
            char label[100];
            std::snprintf(label, sizeof label, "%s, %g ms: %s", m_group.name.c_str(), dt * 1e3, kind.name.c_str());
            m_progress(label);
            Candidate candidate{&kind, trialOf(m_group, kind, dt), {}, {}};
            const double expected = m_secondsPerStep[kind.name] * stepsIn(m_group, dt);
            if (expected > kLongestRun) {
                std::snprintf(label, sizeof label, "not run: would take %.0f s", expected);
                candidate.trial.skipped = label;
                m_trials.push_back(candidate.trial);
                continue;
            }
            start(candidate, m_group, m_truths);
            candidates.push_back(std::move(candidate));
        }
        for (int round = 1; round < kRepeats; ++round)
            for (Candidate &candidate : candidates) repeat(candidate, m_group);
        for (Candidate &candidate : candidates) {
            finish(candidate, m_group);
            m_secondsPerStep[candidate.kind->name] = candidate.trial.secondsPerStep;
            m_trials.push_back(candidate.trial);
        }
    }

    const SceneGroup &m_group;
    const std::vector<EngineKind> &m_engines;
    const Progress &m_progress;
    std::vector<Passage> m_truths;
    std::map<std::string, double> m_secondsPerStep;
    std::vector<Trial> m_trials;
};

SceneGroup mazeGroup(const MazeSize &size) {
    SceneGroup group{"maze " + std::to_string(size.cells),
                     std::to_string(size.walls) + " walls, tilted anew each 0.5 s, 10 s, five mazes",
                     {}};
    for (const unsigned seed : size.seeds) group.scenes.push_back(mazeScene(size, seed));
    return group;
}

SceneGroup fastGroup() {
    constexpr int kPhases = 16;
    SceneGroup group{"fast", "300 m/s into a wall 0.2 m thick, 16 starting distances", {}};
    for (int phase = 0; phase < kPhases; ++phase) group.scenes.push_back(fastScene(phase, kPhases));
    return group;
}

} // namespace

std::vector<SceneGroup> allGroups() {
    std::vector<SceneGroup> groups{
        {"incline", "rolls from rest down 5 degrees, 2 s", {inclineScene()}},
        {"bounce", "between two walls, restitution 0.8, 10 s", {bounceScene()}},
        {"billiard", "a room on a level board, restitution 1, 10 s", {billiardScene()}},
        {"edge", "a corner is hit off centre, 1 s later", {edgeScene()}},
    };
    for (const MazeSize &size : kMazeSizes) groups.push_back(mazeGroup(size));
    groups.push_back(fastGroup());
    groups.push_back({"rest", "pressed into a corner by a tilt, 10 s", {restScene()}});
    return groups;
}

bool Trial::answered() const {
    return skipped.empty() && !errors.empty() &&
           std::all_of(errors.begin(), errors.end(), [](const SceneError &error) { return error.failure.empty(); });
}

double Trial::medianLargest() const {
    std::vector<double> all;
    for (const SceneError &error : errors) all.push_back(error.largest);
    return median(all);
}

double Trial::worstLargest() const {
    const auto worst = std::max_element(errors.begin(), errors.end(),
                                        [](const SceneError &a, const SceneError &b) { return a.largest < b.largest; });
    return worst->largest;
}

std::vector<Trial> measure(const std::vector<SceneGroup> &groups, const std::vector<EngineKind> &engines,
                           const Progress &progress) {
    std::vector<Trial> all;
    for (const SceneGroup &group : groups) {
        std::vector<Trial> trials = GroupMeasurement(group, engines, progress).run();
        std::move(trials.begin(), trials.end(), std::back_inserter(all));
    }
    return all;
}

} // namespace bench
