// SPDX-License-Identifier: MIT
// An immutable scene: the given boxes, and data that steppers derive from them.
#pragma once

#include "base/vec.h"
#include "scene/grid.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace phys {

/// Up to this many boxes (a floor and four walls), testing all of them costs less than a lookup in the grid.
inline constexpr size_t kHandful = 5;

/// The grid lists boxes up to this many radii from a centre: contact, and half a radius of motion.
inline constexpr double kCandidateReach = 1.5;

/// Relative size of a rounding step: "u" in model.md.
inline constexpr double kRounding = 2.220446049250313e-16;

struct Scene {
    std::vector<phys_box> given;    ///< as the caller gave them; their numbers are public
    std::vector<phys_box> boxes;    ///< merged, floors and walls alike (model.md 5.6), ordered by their lowest part
    std::vector<uint32_t> allBoxes; ///< 0, 1, 2, ...: the list of boxes where no grid is needed
    std::vector<uint32_t> firstPart, parts; ///< partsOf(i) is [firstPart[i], firstPart[i + 1]) of parts
    Grid grid;                              ///< of boxes; reach: kCandidateReach radii

    double radius = 0.0;
    Vec3 start{0.0};
    phys_box bounds{};
    bool hasFloor = false;
    double floorTop = 0.0;   ///< m; -infinity without a floor
    double supportedZ = 0.0; ///< height of a supported centre: floorTop + radius
    double tolerance = 0.0;  ///< m: 4 rounding steps of the largest coordinate, model.md 5.2

    bool hasManyBoxes = false; ///< so many that the grid is used
    bool isPlanar() const { return nonPlanarReason.empty(); }

    // Why the scene isn't planar (model.md 0); empty if it is.
    std::string nonPlanarReason;

    /// Boxes within kCandidateReach radii of a centre at (x, y), seen from above: a superset, ascending.
    std::span<const uint32_t> boxesNear(double x, double y, bool useGrid) const {
        return useGrid ? grid.near(x, y) : std::span<const uint32_t>(allBoxes);
    }

    /// Calls visit(box) for the boxes that overlap or touch the region between two corners, without duplicates, in any
    /// order.
    template<class Visit>
    void visitBoxes(const Vec3 &low, const Vec3 &high, Visit visit) const {
        grid.visitOverlapping(inPlane(low), inPlane(high), [&](uint32_t i) {
            const phys_box &box = boxes[i];
            const bool outside = box.max.x < low.x || box.min.x > high.x || box.max.y < low.y || box.min.y > high.y ||
                                 box.max.z < low.z || box.min.z > high.z;
            if (!outside) visit(i);
        });
    }

    /// Numbers of the given boxes of a merged one, ascending.
    std::span<const uint32_t> partsOf(uint32_t box) const {
        return std::span(parts).subspan(firstPart[box], firstPart[box + 1] - firstPart[box]);
    }

    /// Number of the given box in a merged one that is nearest to `point`; on ties the lowest.
    uint32_t givenBox(uint32_t box, const Vec3 &point) const;

    /// Whether one box whose top is the floor's plane lies below all positions within `reach` (m) of (x, y) along each
    /// axis, borders included.
    bool overFloor(double x, double y, double reach = 0.0) const;

    /// Whether a ball at this position is beyond the board.
    bool isOut(const phys_vec3 &centre) const { return !isOver(bounds, centre.x, centre.y); }

    static bool isOver(const phys_box &box, double x, double y) {
        return x >= box.min.x && x <= box.max.x && y >= box.min.y && y <= box.max.y;
    }
};

// Each explains why a scene can't have this; PHYS_OK if it can.
phys_status checkRadius(double radius, phys_error *err);
phys_status checkStart(const phys_vec3 &start, phys_error *err);
phys_status checkBox(const phys_box &box, uint32_t number, phys_error *err);

/// Checks a description and makes the scene. Throws std::bad_alloc only.
phys_status makeScene(const phys_scene_desc &desc, Scene &out, phys_error *err);

} // namespace phys

struct phys_scene : phys::Scene {};
