// SPDX-License-Identifier: GPL-3.0-or-later
// Which events are bounces, and whose coefficients count in them.
#pragma once

#include <physics/physics.h>

namespace inspector {

/// Normal speed, m/s. Slower impacts come from a ball that leans on a wall; discrete steppers report them in every
/// step. The trade ignores them, and the event list groups them.
inline constexpr double kCountedImpact = 0.05;

inline bool isBounce(const phys_event &event) {
    return event.kind == PHYS_EVENT_IMPACT || event.kind == PHYS_EVENT_LANDING;
}

enum class Surface { Wall, Floor };

/// The surface of a bounce. The floor's coefficients count on top faces, the walls' on all other faces, on edges and on
/// corners (model.md 13.1). The kind decides, not the normal: that of an edge can be arbitrarily steep.
inline Surface surfaceOf(const phys_event &bounce) {
    return bounce.kind == PHYS_EVENT_LANDING ? Surface::Floor : Surface::Wall;
}

} // namespace inspector
