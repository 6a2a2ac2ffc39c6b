// SPDX-License-Identifier: MIT
// What a stepper of fixed substeps caches between steps: its last lookups. They follow from the scene alone, so that no
// result depends on the cache.
#pragma once

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

private:
    const Scene &m_scene;
    FloorRegions m_regions;
};

} // namespace phys
