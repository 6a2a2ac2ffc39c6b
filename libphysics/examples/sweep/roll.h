// SPDX-License-Identifier: MIT
// One job: a ball rolls through a level under a tilt that turns round, and what became of it.
#pragma once

#include "plan.h"

#include <physics/physics.h>

#include <map>
#include <memory>

namespace sweep {

/// Plain bytes: it travels between ranks as it is.
struct Outcome {
    phys_state state;
    uint64_t job;
    uint64_t impacts;
    double energyLost; ///< by impacts, rolling and slip, J/kg
    phys_error error;  ///< status PHYS_OK if all went well
};

/// Runs jobs; keeps the scenes that it has loaded.
class Roller {
public:
    /// Plugins that can't be loaded make every job fail with their reason.
    explicit Roller(const Plan &plan);
    Outcome run(uint64_t number);

private:
    struct DestroyRegistry {
        void operator()(phys_registry *registry) const { phys_registry_destroy(registry); }
    };
    struct DestroyScene {
        void operator()(phys_scene *scene) const { phys_scene_destroy(scene); }
    };
    const phys_scene *scene(const std::string &level, phys_error &error);
    void roll(const Job &job, Outcome &outcome);

    const Plan &m_plan;
    phys_error m_broken{};
    std::unique_ptr<phys_registry, DestroyRegistry> m_registry;
    std::map<std::string, std::unique_ptr<phys_scene, DestroyScene>> m_scenes;
};

} // namespace sweep
