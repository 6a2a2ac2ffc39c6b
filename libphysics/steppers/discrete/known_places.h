// SPDX-License-Identifier: MIT
// What a stepper of fixed substeps keeps of its scene between steps: what it looked up last. All of it follows from the
// scene alone, so that no answer depends on what is kept.
#pragma once

#include "floor_region.h"
#include "footing.h"

namespace phys {

class KnownPlaces {
public:
    explicit KnownPlaces(const Scene &scene)
        : m_footing(scene)
        , m_regions(scene) {}

    const Scene &scene() const { return m_footing.scene(); }
    LastFooting &footing() { return m_footing; }
    FloorRegions &regions() { return m_regions; }

private:
    LastFooting m_footing;
    FloorRegions m_regions;
};

} // namespace phys
