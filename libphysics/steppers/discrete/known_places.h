// SPDX-License-Identifier: MIT
// What a stepper of fixed substeps caches between steps: its last lookups, and what follows from the last parameters.
// All of it follows from the scene and the parameters alone, so that no result depends on the cache.
#pragma once

#include "prepared_step.h"
#include "requirements.h"
#include "shared/floor_region.h"

namespace phys {

class KnownPlaces {
public:
    explicit KnownPlaces(const Scene &scene)
        : m_scene(scene)
        , m_regions(scene, FloorRegions::Beside::faces) {}

    const Scene &scene() const { return m_scene; }
    FloorRegions &regions() { return m_regions; }
    PreparedStep &prepared() { return m_prepared; }

private:
    const Scene &m_scene;
    FloorRegions m_regions;
    PreparedStep m_prepared;
};

} // namespace phys
