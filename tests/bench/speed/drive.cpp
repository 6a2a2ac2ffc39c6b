// SPDX-License-Identifier: MIT
// Steps one engine many times and does nothing else, so that callgrind can count its instructions.
#include "peers/engine.h"
#include "support/maze_scenes.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

namespace {

using namespace bench;

constexpr double kStep = 0.01; // s

// Rolls back and forth in the middle of a cell, a few centimetres from the start, and never touches a wall.
void driveFree(Engine &engine, const Scene &scene, int steps) {
    constexpr int kHalfSwing = 10;
    const phys_vec3 there = steadyTilt(0.05, -0.02).front();
    const phys_vec3 back = steadyTilt(-0.05, 0.02).front();
    engine.place(scene.start);
    for (int done = 0; done < steps; done += kHalfSwing) {
        const int quarter = done / kHalfSwing % 4;
        engine.setGravity(quarter == 0 || quarter == 3 ? there : back);
        engine.advance(kStep, kHalfSwing);
    }
}

void driveMaze(Engine &engine, const Scene &scene, int steps) {
    const int stepsPerTilt = static_cast<int>(scene.tiltPeriod / kStep);
    engine.place(scene.start);
    for (int done = 0; done < steps; done += stepsPerTilt) {
        engine.setGravity(scene.gravity[static_cast<std::size_t>(done / stepsPerTilt) % scene.gravity.size()]);
        engine.advance(kStep, stepsPerTilt);
    }
}

int usage() {
    std::fprintf(stderr, "usage: bench_drive ENGINE free|rolling|maze STEPS\n"
                         "  free     frictionless, no wall touched, 118 walls\n"
                         "  rolling  the same, but rolling\n"
                         "  maze     frictionless, tilted anew each 0.5 s, 118 walls\n"
                         "engines:");
    for (const EngineKind &kind : allEngines()) std::fprintf(stderr, " %s", kind.name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
}

int drive(const EngineKind &kind, const std::string &where, int steps) {
    Scene scene = mazeScene(kMazeSizes.front(), kMazeSizes.front().seeds.front());
    scene.rolls = where == "rolling";
    const auto engine = kind.make(scene, kStep);
    if (where == "maze")
        driveMaze(*engine, scene, steps);
    else
        driveFree(*engine, scene, steps);
    const Ball ball = engine->ball();
    std::printf("%s %s %d steps: at (%.6f, %.6f) m\n", kind.name.c_str(), where.c_str(), steps, ball.position.x,
                ball.position.y);
    return 0;
}

} // namespace

int main(int count, char **arguments) {
    if (count != 4) return usage();
    const std::string name = arguments[1];
    const std::string where = arguments[2];
    const int steps = std::atoi(arguments[3]);
    if (steps <= 0 || (where != "free" && where != "rolling" && where != "maze")) return usage();
    try {
        for (const EngineKind &kind : allEngines())
            if (kind.name == name) return drive(kind, where, steps);
    } catch (const std::exception &problem) {
        std::fprintf(stderr, "bench_drive: %s\n", problem.what());
        return 1;
    }
    return usage();
}
