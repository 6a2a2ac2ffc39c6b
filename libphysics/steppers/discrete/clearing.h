// SPDX-License-Identifier: MIT
// Where nothing needs to be looked up: a rectangle of places in which the ball touches nothing.
#pragma once

#include "base/pairs.h"
#include "footing.h"
#include "scene/scene.h"

namespace phys {

/// Keeps the rectangle that the ball was last seen in. What a rectangle promises follows from the scene alone, so that
/// no answer depends on which one is kept: a way that leaves it is looked up.
class Clearing {
public:
    explicit Clearing(const Scene &scene)
        : m_scene(scene)
        , m_footing(scene) {}

    const Scene &scene() const { return m_scene; }
    LastFooting &footing() { return m_footing; }

    /// Whether a ball on the floor touches nothing wherever its centre is between two corners (m), and has the floor
    /// under it. May be false where that is so, but the rectangle that is kept doesn't show it.
    bool holds(const Vec2 &low, const Vec2 &high) const {
        return isWithinRectangle(&low.x, &high.x, &m_low.x, &m_high.x);
    }

    /// Finds and keeps a rectangle around a place. False if a ball there touches something or has no floor.
    bool findAround(const Vec2 &place);

private:
    const Scene &m_scene;
    LastFooting m_footing;
    Vec2 m_low{INFINITY}, m_high{-INFINITY}; ///< holds nothing yet
};

} // namespace phys
