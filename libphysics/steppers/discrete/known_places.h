// SPDX-License-Identifier: MIT
// What a stepper of fixed substeps keeps of its scene between steps: what it looked up last. All of it follows from the
// scene alone, so that no answer depends on what is kept.
#pragma once

#include "requirements.h"
#include "shared/floor_region.h"

namespace phys {

class KnownPlaces {
public:
    explicit KnownPlaces(const Scene &scene)
        : m_scene(scene)
        , m_regions(scene) {}

    const Scene &scene() const { return m_scene; }
    FloorRegions &regions() { return m_regions; }

private:
    const Scene &m_scene;
    FloorRegions m_regions;
};

} // namespace phys
