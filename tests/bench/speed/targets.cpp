// SPDX-License-Identifier: MIT
// The targets for speed beside the measured values: ratios to Chipmunk in one run, all engines in turn, CPU time.
#include "peers/engine.h"
#include "support/cpu_clock.h"
#include "support/maze_scenes.h"
#include "support/statistics.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace bench;

constexpr double kStep = 0.01; // s
constexpr int kRounds = 25;

// All mazes of one size, with an engine in each.
struct Track {
    std::vector<Scene> scenes;
    std::vector<std::unique_ptr<Engine>> engines;
};

// The measurements of one engine: one value per round.
struct Series {
    EngineKind kind;
    double dt = kStep;
    std::array<Track, kMazeSizes.size()> tracks;
    std::array<std::vector<double>, kMazeSizes.size()> secondsPerSimulated;
    std::vector<double> creation; // s, of the largest maze
};

std::vector<Scene> mazesOf(const MazeSize &size) {
    std::vector<Scene> scenes;
    for (const unsigned seed : size.seeds) scenes.push_back(mazeScene(size, seed));
    return scenes;
}

Series makeSeries(const EngineKind &kind, double dt) {
    Series series{kind, dt, {}, {}, {}};
    for (std::size_t size = 0; size < kMazeSizes.size(); ++size) {
        Track &track = series.tracks[size];
        track.scenes = mazesOf(kMazeSizes[size]);
        for (const Scene &scene : track.scenes) track.engines.push_back(kind.make(scene, dt));
    }
    return series;
}

double runTrack(Track &track, double dt) {
    double simulated = 0;
    const double spent = cpuTimeOf([&] {
        for (std::size_t maze = 0; maze < track.scenes.size(); ++maze) {
            run(*track.engines[maze], track.scenes[maze], dt);
            simulated += track.scenes[maze].duration;
        }
    });
    return spent / simulated;
}

void measureRound(std::vector<Series> &all) {
    for (std::size_t size = 0; size < kMazeSizes.size(); ++size)
        for (Series &series : all) {
            runTrack(series.tracks[size], series.dt); // the engine before it has taken caches and branch prediction
            series.secondsPerSimulated[size].push_back(runTrack(series.tracks[size], series.dt));
        }
    for (Series &series : all) {
        std::unique_ptr<Engine> engine;
        const Scene &scene = series.tracks.back().scenes.front();
        series.creation.push_back(cpuTimeOf([&] { engine = series.kind.make(scene, series.dt); }));
    }
}

// Ratios within the same round, so that a temporary slowdown of the machine affects both.
std::vector<double> ratios(const std::vector<double> &ours, const std::vector<double> &theirs) {
    std::vector<double> result;
    std::transform(ours.begin(), ours.end(), theirs.begin(), std::back_inserter(result), std::divides<>());
    return result;
}

const Series *find(const std::vector<Series> &all, const std::string &name, double dt) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Series &series) { return series.kind.name == name && series.dt == dt; });
    return found == all.end() ? nullptr : &*found;
}

void printSeries(const std::vector<Series> &all) {
    std::printf("%-18s %7s", "engine", "step");
    for (const MazeSize &size : kMazeSizes) std::printf("  %5d walls", size.walls);
    std::printf("  2011/118   creation, 2011 walls\n%-18s %7s", "", "ms");
    for (std::size_t size = 0; size < kMazeSizes.size(); ++size) std::printf("  %11s", "ns/step");
    std::printf("  %8s   %11s\n", "", "us");
    for (const Series &series : all) {
        std::printf("%-18s %7g", series.kind.name.c_str(), series.dt * 1e3);
        for (const auto &seconds : series.secondsPerSimulated)
            std::printf("  %11.1f", median(seconds) * series.dt * 1e9);
        std::printf("  %8.2f   %11.1f\n",
                    median(ratios(series.secondsPerSimulated.back(), series.secondsPerSimulated.front())),
                    median(series.creation) * 1e6);
    }
}

void printTarget(const char *what, double allowed, const std::vector<double> &measured) {
    const double value = median(measured);
    std::printf("%-62s %8.3f %9.3f %7.0f%%  %s\n", what, allowed, value, relativeSpread(measured) * 100,
                value <= allowed ? "met" : "MISSED");
}

void printMissing(const char *what) { std::printf("%-62s not measured: engine missing\n", what); }

std::vector<double> microseconds(std::vector<double> seconds) {
    for (double &value : seconds) value *= 1e6;
    return seconds;
}

void printTargets(const std::vector<Series> &all) {
    const Series *chipmunk = find(all, "chipmunk", kStep);
    const Series *cheap = find(all, PHYS_STEPPER_DEFAULT, kStep);
    const Series *exact = find(all, "exact", kStep);
    const Series *leaping = find(all, "exact", 0.5);
    std::printf("\n%-62s %8s %9s %8s\n", "target", "allowed", "measured", "spread");
    const char *share = "symplectic-euler / chipmunk, time per step, 118 walls, 10 ms";
    const char *growth = "symplectic-euler, time per step, 2011 walls / 118 walls";
    const char *exactShare = "exact / chipmunk, time per step, 118 walls, 10 ms";
    const char *leap = "exact once per tilt change (0.5 s), us per simulated second";
    const char *creation = "scene creation / chipmunk, 2011 walls";
    const auto small = [](const Series *series) { return series->secondsPerSimulated.front(); };
    cheap &&chipmunk ? printTarget(share, 0.2, ratios(small(cheap), small(chipmunk))) : printMissing(share);
    cheap ? printTarget(growth, 1.2, ratios(cheap->secondsPerSimulated.back(), small(cheap))) : printMissing(growth);
    exact &&chipmunk ? printTarget(exactShare, 0.6, ratios(small(exact), small(chipmunk))) : printMissing(exactShare);
    leaping ? printTarget(leap, 2, microseconds(small(leaping))) : printMissing(leap);
    cheap &&chipmunk ? printTarget(creation, 0.25, ratios(cheap->creation, chipmunk->creation))
                     : printMissing(creation);
}

} // namespace

int main() {
    std::vector<Series> all;
    std::vector<EngineKind> kinds = ourEngines();
    for (const EngineKind &kind : chipmunkEngines()) kinds.push_back(kind);
    for (const EngineKind &kind : kinds) {
        all.push_back(makeSeries(kind, kStep));
        if (kind.exactInDt) all.push_back(makeSeries(kind, 0.5));
    }
    for (int round = 0; round < kRounds; ++round) measureRound(all);
    std::printf(
        "Mazes of 16, 32 and 64 cells a side, five of each, frictionless, restitution 0.5, a new tilt each 0.5 s,\n"
        "10 s each; medians of %d rounds in turns, CPU time of the thread.\n\n",
        kRounds);
    printSeries(all);
    printTargets(all);
}
