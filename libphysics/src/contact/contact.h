// SPDX-License-Identifier: MIT
// The features of boxes that a ball touches, and their properties: model.md 13.1.
#pragma once

#include "base/vec.h"
#include "contact/ball.h"
#include "contact/short_list.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>

namespace phys {

/// Velocity and spin, which impulses change.
struct Motion {
    Vec3 velocity;
    Vec3 spin;
};

/// J/kg
inline double kineticEnergy(const Motion &motion, double radius) {
    return 0.5 * glm::dot(motion.velocity, motion.velocity) + spinEnergy(motion.spin, radius);
}

/// v, shortened to length `most` if it is longer.
inline Vec3 clipped(const Vec3 &v, double most) {
    const double size = glm::length(v);
    return size > most ? most / size * v : v;
}

/// Velocity of the ball's surface tangential to a contact.
inline Vec3 slipAt(const Motion &motion, const Vec3 &normal, double radius) {
    const Vec3 surface = motion.velocity - radius * glm::cross(motion.spin, normal);
    return surface - glm::dot(surface, normal) * normal;
}

/// Relative to the motion, speeds along a normal that count as rounding: "tolv" in model.md 13.2.
inline constexpr double kNegligibleShare = 64.0 * kRounding;

/// The same in m/s.
inline double negligibleSpeed(const Motion &motion, double radius) {
    return kNegligibleShare * (glm::length(motion.velocity) + radius * glm::length(motion.spin));
}

/// Friction can halve a slip again and again without ending it. Components that are smaller than the motion before the
/// contacts by this factor count as zero, long before they underflow.
inline void dropTraces(const Motion &before, double radius, Motion &motion) {
    constexpr double kTrace = 1e-100;
    const double most = kTrace * (glm::length(before.velocity) + radius * glm::length(before.spin));
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(motion.velocity[axis]) < most) motion.velocity[axis] = 0.0;
        if (radius * std::abs(motion.spin[axis]) < most) motion.spin[axis] = 0.0;
    }
}

/// The contact of a ball with the feature of a box nearest to it; there is only one because a box is convex.
struct Contact {
    Vec3 point;               ///< of the box, nearest to the centre
    Vec3 normal;              ///< unit, from the point to the centre
    double gap;               ///< m; negative: overlaps
    std::array<int, 3> sides; ///< per axis: the centre lies below (-1), in (0) or above (+1) the box's extent
    double restitution;
    double restSpeed; ///< m/s: a slower approach doesn't bounce but is part of lasting contact
    double friction;  ///< 0 in the rolling model
    bool isTop;       ///< a top face, which carries the ball and on which it rolls
    bool isGlued;     ///< a top face in the rolling model: the spin there follows the velocity
    uint32_t box;     ///< its number in scene.boxes

    /// 1: a face, 2: an edge, 3: a corner.
    int axes() const { return std::abs(sides[0]) + std::abs(sides[1]) + std::abs(sides[2]); }
    bool isFace() const { return axes() == 1; }

    /// Whether a ball that it keeps out is no nearer to that place, which doesn't stand out of its face, or faces.
    bool isBefore(const Vec3 &place, double tolerance) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (sides[axis] != 0 && sides[axis] * (place[axis] - point[axis]) > tolerance) return false;
        }
        return true;
    }
    /// The component of a vector that turns the normal: across an edge; any component at a corner.
    Vec3 across(const Vec3 &v) const { return {sides[0] ? v.x : 0.0, sides[1] ? v.y : 0.0, sides[2] ? v.z : 0.0}; }
    /// The second derivative of the gap (m/s^2) due to the motion round the feature; 0 at a face.
    double curving(const Vec3 &velocity, double radius) const {
        if (isFace()) return 0.0;
        const Vec3 turning = across(velocity);
        return glm::dot(turning, turning) / radius;
    }
};

/// Normals closer than this count as one, model.md 13.1; for a stepper that looks ahead.
inline constexpr double kSameNormal = 1e-9;

/// The contacts of one moment, one for each normal.
class Contacts : public ShortList<Contact> {
public:
    static constexpr uint32_t kMost = kMostContacts;

    /// Removes the contacts for which `isUnwanted` is true, asking in order. The remaining ones keep their ties.
    template<class Predicate>
    void drop(Predicate isUnwanted) {
        uint32_t kept = 0;
        bool ties = true; // with the last one that was kept
        for (uint32_t i = 0; i < count(); ++i) {
            ties = ties && m_tiesWithPrevious[i];
            if (isUnwanted((*this)[i])) continue;
            m_tiesWithPrevious[kept] = kept > 0 && ties;
            (*this)[kept++] = (*this)[i];
            ties = true;
        }
        shorten(kept);
    }
    /// Removes edges and corners that a face, and corners that an edge shields from the ball: those that don't stand
    /// out of its plane, or planes.
    void dropHidden(double tolerance);
    /// Sorts by criteria that don't depend on the numbering of boxes, reflections or quarter turns.
    void sort(const Motion &motion, const Vec3 &gravity, double radius);
    /// Whether some contacts compare equal in `sort`.
    bool hasTies() const {
        return std::any_of(m_tiesWithPrevious.begin(), m_tiesWithPrevious.begin() + count(),
                           [](bool ties) { return ties; });
    }
    /// Reverses the order of contacts that compare equal in `sort`. False if there are none.
    bool reverseTies();

private:
    std::array<bool, kMost> m_tiesWithPrevious{}; ///< for sorted contacts
};

/// What determines contacts besides the ball.
struct Setting {
    Setting(const Scene &ofScene, const phys_params &ofParams)
        : scene(ofScene)
        , params(ofParams)
        , tolerance(ofScene.tolerance) {}

    const Scene &scene;
    const phys_params &params;
    double tolerance;                ///< m: smaller gaps count as zero
    double sameNormal = kSameNormal; ///< normals closer than this count as one

    bool isRigid() const { return params.model == PHYS_MODEL_RIGID; }
    Vec3 gravity() const { return toVec(params.gravity); }
};

/// Finds what a ball at `position` touches, or would overlap after any of the `ways` (m), in the order of
/// Contacts::sort. False if the centre is inside a box: that isn't a contact, and the ball must be pushed out first.
bool findContacts(const Setting &setting, const Vec3 &position, const Motion &motion, std::span<const Vec3> ways,
                  Contacts &out);

/// The same if only these boxes are near.
void findContactsAmong(const Setting &setting, const Vec3 &position, const Motion &motion,
                       std::span<const uint32_t> boxes, Contacts &out);

/// The contact with a face at a distance of exactly the radius, away from the face's ends. side: +1 or -1, the
/// direction of its normal along the axis.
Contact contactAtFace(const Setting &setting, const Vec3 &position, uint32_t box, int axis, int side);

inline bool findContacts(const Setting &setting, const Vec3 &position, const Motion &motion, const Vec3 &way,
                         Contacts &out) {
    return findContacts(setting, position, motion, std::span(&way, 1), out);
}

} // namespace phys
