// SPDX-License-Identifier: MIT
// What a stepper of fixed substeps caches between steps: its last lookups, which follow from the scene alone, and what
// follows from parameters and length of the last step. No result depends on the cache.
#pragma once

#include "floor_kind.h"
#include "region_step.h"
#include "requirements.h"
#include "shared/floor_region.h"

namespace phys {

/// What a single step in a region takes from its parameters and length.
struct KnownDrive {
    bool isUsual = false; ///< whether there may be such steps
    FloorKind kind;
    bool mayLean = false;
    RegionLimits limits{};
    FloorDrive<double> drive{{0.0, 0.0}, 0.0, 0.0, 0.0, 0.0};
};

class KnownPlaces {
public:
    explicit KnownPlaces(const Scene &scene)
        : m_scene(scene)
        , m_regions(scene, FloorRegions::Beside::faces) {}

    const Scene &scene() const { return m_scene; }
    FloorRegions &regions() { return m_regions; }
    KnownDrive &drive() { return m_drive; }

private:
    const Scene &m_scene;
    FloorRegions m_regions;
    KnownDrive m_drive;
};

} // namespace phys
