// SPDX-License-Identifier: MIT
// One interface to all engines of the comparison, including our steppers.
#pragma once

#include "support/scene.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bench {

class Engine {
public:
    virtual ~Engine() = default;
    virtual void place(const Ball &ball) = 0;
    virtual void setGravity(const phys_vec3 &gravity) = 0;
    // The loop is part of the engine, so that no step contains a call through this interface.
    virtual void advance(double dt, int steps) = 0;
    virtual Ball ball() const = 0;
};

struct EngineKind {
    std::string name;
    bool ours = false;
    bool exactInDt = false; // a single step of any length is as accurate as many
    std::string settings;   // its settings and what it does differently, in words
    // Some engines are tuned for the step (s) with which they will be called.
    std::function<std::unique_ptr<Engine>(const Scene &, double dt)> make;
};

// Each list is empty if the engine wasn't found at build time.
std::vector<EngineKind> chipmunkEngines();
std::vector<EngineKind> box2dEngines();
std::vector<EngineKind> bulletEngines();
std::vector<EngineKind> odeEngines();
std::vector<EngineKind> mujocoEngines();
// A parameter row of the library's or of a stepper's own, by id.
struct Setting {
    std::string row;
    double value;
};

// One engine for each stepper in the library's registry that has all of these rows.
std::vector<EngineKind> ourEngines(const std::vector<Setting> &settings = {});

std::vector<EngineKind> allEngines();

// Runs from the scene's start through all of its tilts. If steps don't divide a tilt's period evenly, the nearest whole
// number of steps is taken, and each lasts the period divided by it.
void run(Engine &engine, const Scene &scene, double dt);

} // namespace bench
