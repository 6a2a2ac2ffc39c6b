// SPDX-License-Identifier: MIT
#include "peers/engine.h"

#include <algorithm>
#include <cmath>

namespace bench {

std::vector<EngineKind> allEngines() {
    std::vector<EngineKind> all;
    for (const auto &engines :
         {ourEngines(), chipmunkEngines(), box2dEngines(), bulletEngines(), odeEngines(), mujocoEngines()})
        all.insert(all.end(), engines.begin(), engines.end());
    return all;
}

void run(Engine &engine, const Scene &scene, double dt) {
    const int steps = std::max(1, static_cast<int>(std::lround(scene.tiltPeriod / dt)));
    engine.place(scene.start);
    for (const phys_vec3 &gravity : scene.gravity) {
        engine.setGravity(gravity);
        engine.advance(scene.tiltPeriod / steps, steps);
    }
}

} // namespace bench
