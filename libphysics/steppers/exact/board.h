// SPDX-License-Identifier: MIT
// What the exact stepper asks of a scene: contacts at a point, how far a face or a floor reaches, ways out of boxes.
#pragma once

#include "scene/nearest.h"
#include "scene/scene.h"

#include <array>
#include <optional>
#include <vector>

namespace phys {

/// A solid that the ball touches.
struct Touch {
    Vec3 normal; ///< unit, from the solid to the centre
    Vec3 point;  ///< of the solid, nearest to the centre
    uint32_t solid;
    uint32_t feature; ///< PHYS_FEATURE_*
};

/// Different normals at one place; more are refused.
inline constexpr size_t kMostTouches = 16;

struct Touches {
    std::array<Touch, kMostTouches> items;
    uint32_t count = 0;
    bool overflow = false;

    const Touch *begin() const { return items.data(); }
    const Touch *end() const { return items.data() + count; }
};

/// A plane x = const or y = const with solids behind it: the ball's normal there is exactly an axis.
struct Plane {
    int axis = 0;      ///< 0: x, 1: y
    double sign = 1.0; ///< of the normal along the axis
    double coordinate = 0.0;
};

struct Heights {
    double low, high;
};

class Board {
public:
    explicit Board(const Scene &scene);

    const Scene &scene() const { return *m_scene; }
    double radius() const { return m_scene->radius; }
    double tolerance() const { return m_scene->tolerance; }

    /// Largest angle between two normals that belong to one flat contact, model.md 5.6: two boxes flush within the
    /// tolerance are touched at once up to sqrt(2 R tolerance) from their joint.
    double sameNormal() const { return 2.0 * m_grazing; }

    /// Angle between a velocity and an edge's tangent below which the ball passes the edge within two tolerances.
    double grazing() const { return m_grazing; }

    /// Solids within the tolerance, those with the same normal as one (faces before edges).
    void findTouches(const Vec3 &p, Touches &touches) const;

    /// Whether a ball at p that goes no further than `way` surely meets no solid and stays on its floor. For short
    /// ways.
    bool isOpen(const Vec3 &p, double way) const;

    /// Solids that a ball with its centre in the rectangle can touch: a superset, valid until the next call.
    std::span<const uint32_t> near(const Vec2 &low, const Vec2 &high) const;

    /// Coordinate along the other axis up to which solids behind `plane` carry on without a gap from `from` towards
    /// `direction` (+-1), looked for no further than `limit`.
    double faceEnd(const Plane &plane, const Vec3 &p, double direction, double limit) const;

    /// The solid behind `plane` at p that carries a ball furthest towards `direction`.
    uint32_t carrier(const Plane &plane, const Vec3 &p, const Vec3 &direction) const;

    /// Lowest and highest z up to which the solids that a ball at p touches with this normal carry it.
    Heights heights(const Vec3 &p, const Vec3 &normal) const;

    /// Whether a solid lies wholly behind the plane.
    bool isBehind(const Plane &plane, uint32_t solid) const;

    /// Moves a centre out of the solids it penetrates, model.md 5.7: in the plane for a supported ball. False if it is
    /// wedged. deepest: raised to the deepest penetration seen.
    bool pushOut(Vec3 &p, bool supported, double &deepest) const;

    /// The floor that supports a ball at p (borders included, within the tolerance) which is about to move along
    /// `direction`: not one that it is just leaving. Its number in scene.floors.
    std::optional<uint32_t> floorUnder(const Vec3 &p, const Vec2 &direction) const;

private:
    void add(const Touch &touch, Touches &touches) const;

    const Scene *m_scene;
    double m_grazing;
    mutable std::vector<uint32_t> m_near; // scratch: room for all solids, or all floors
};

} // namespace phys
