// SPDX-License-Identifier: MIT
// What is certain of the motion of a ball on a floor, without evaluating the law of contact. In case of doubt the event
// loop decides.
#pragma once

#include "scene/scene.h"

#include <cmath>

namespace phys {

/// Relative to the numbers beside it, what may be rounding.
inline constexpr double kUnsure = 1e-9;

class FloorPull {
public:
    Vec2 level;      ///< gravity along the floor, m/s^2
    double pressure; ///< gravity into it, m/s^2

    FloorPull(const Scene &scene, const phys_params &params)
        : level(inPlane(params.gravity))
        , pressure(-params.gravity.z)
        , m_scene(scene)
        , m_params(params) {}

    bool isRigid() const { return m_params.model == PHYS_MODEL_RIGID; }
    /// Without friction the ball glides: its spin stays, and nothing resists.
    bool glides() const { return isRigid() && m_params.sliding_friction == 0.0; }
    /// m/s^2: the sum of components, which is no smaller than the length.
    double gravity() const { return std::abs(level.x) + std::abs(level.y) + pressure; }
    /// m/s^2: of a ball that slips.
    double friction() const { return m_params.sliding_friction * pressure; }
    /// m/s^2: rolling resistance, of a ball that rolls or glides.
    double resistance() const { return glides() ? 0.0 : 5.0 / 7.0 * (m_params.rolling_friction * pressure); }
    /// m/s^2: its acceleration without resistance.
    Vec2 drive() const { return glides() ? level : 5.0 / 7.0 * level; }

    /// m/s^2: an upper bound for it.
    double mostAcceleration() const { return std::abs(drive().x) + std::abs(drive().y) + resistance(); }

    /// Whether the ball moves and, in the rigid model, rolls and continues to. spin: the given one.
    bool rolls(const Vec2 &velocity, const Vec3 &spin) const {
        constexpr double kNoMotion = 1e-13; // relative: smaller values are rounding
        const double R = m_scene.radius, speedSquared = glm::dot(velocity, velocity);
        const double turning = R * R * glm::dot(spin, spin);
        if (!(speedSquared > kNoMotion * kNoMotion * (R * gravity() + turning))) return false;
        if (!isRigid()) return true;
        constexpr double kNoSlip = 64.0 * kRounding;
        const Vec2 slip = velocity - spinSpeed(spin, R);
        return glm::dot(slip, slip) <= kNoSlip * kNoSlip * speedSquared && keepsRolling();
    }

    /// Rigid model: whether friction suffices for a ball that rolls.
    bool keepsRolling() const { return 4.0 / 49.0 * glm::dot(level, level) < friction() * friction(); }

    /// Whether the ball rests and the pull overcomes resistance along an axis, so that it starts to roll.
    bool starts(int axis, const Vec3 &velocity, const Vec3 &spin) const {
        if (velocity != Vec3(0.0) || spin.x != 0.0 || spin.y != 0.0 || (isRigid() && !keepsRolling())) return false;
        const double drive = 5.0 / 7.0 * level[axis], most = resistance();
        return drive * drive > (1.0 + kUnsure) * (most * most);
    }

    /// Whether it moves and rolls or glides on.
    bool goesOn(const Vec2 &velocity, const Vec3 &spin) const {
        return glides() ? velocity != Vec2(0.0) : rolls(velocity, spin);
    }

    /// Whether a velocity that friction (m/s^2) opposes turns: it isn't parallel to the pull.
    bool turns(const Vec2 &v, double friction) const {
        constexpr double kLeast = 1e-10; // sine of the angle between the velocity and its rate of change
        const double across = v.x * level.y - v.y * level.x;
        const double most = kLeast * (std::abs(level.x) + std::abs(level.y) + friction);
        return friction > 0.0 && across * across > most * most * glm::dot(v, v);
    }

    /// Whether the pull presses a ball that rolls or glides against a smooth face along which it moves. across: axis of
    /// the face's normal; side: its direction.
    bool presses(int across, int side, const Vec2 &velocity, const Vec3 &spin) const {
        if (isRigid() && (m_params.wall_friction > 0.0 || (spin[1 - across] != 0.0 && !glides()))) return false;
        const double R = m_scene.radius, push = -side * drive()[across];
        const double speedSquared = glm::dot(velocity, velocity);
        const double scale = R * gravity() + speedSquared + (isRigid() ? R * R * glm::dot(spin, spin) : speedSquared);
        return push * R * R > (kUnsure * R + 8.0 * m_scene.tolerance) * scale;
    }

    /// Of a ball that rolls or glides along an axis, m/s^2.
    double accelerationAlong(int axis, double speed) const {
        return drive()[axis] - (speed > 0.0 ? 1.0 : -1.0) * resistance();
    }

    /// The same in any direction.
    Vec2 accelerationAlong(const Vec2 &heading) const { return drive() - resistance() * heading; }

    /// Whether that acceleration lasts for a time: resistance neither stops nor reverses the ball.
    bool keepsAcceleration(double speed, double acceleration, double time) const {
        const double slows = speed > 0.0 ? -acceleration : acceleration;
        return resistance() == 0.0 || slows * time < (1.0 - kUnsure) * std::abs(speed);
    }

private:
    const Scene &m_scene;
    const phys_params &m_params;
};

} // namespace phys
