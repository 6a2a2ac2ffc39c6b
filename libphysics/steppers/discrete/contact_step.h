// SPDX-License-Identifier: MIT
// Contacts in a substep: the law of contact (model.md 13) in the form for fixed substeps.
#pragma once

#include "contact/ball.h"
#include "contact/impact.h"
#include "contact/lasting.h"
#include "contact/least_push.h"
#include "floor_contact.h"
#include "registry/report.h"

#include <glm/common.hpp>

#include <optional>

namespace phys {

/// A slip below this share of the speeds counts as zero.
inline constexpr double kRolling = 1e-9;

/// What is constant during one step.
struct StepContext {
    Setting setting;
    Reporter &report;
    Work &work; ///< of the step

    const Scene &scene() const { return setting.scene; }
    const phys_params &params() const { return setting.params; }
    double radius() const { return setting.scene.radius; }
    bool isRigid() const { return setting.isRigid(); }
    bool hasRoughWalls() const { return isRigid() && params().wall_friction > 0.0; }
    /// Whether what presses a ball onto a floor, or lifts it, changes its motion there.
    bool rubsOnFloor() const { return (isRigid() ? params().sliding_friction : params().rolling_friction) > 0.0; }
};

inline bool touches(const StepContext &context, const Contact &contact) {
    return contact.gap <= context.setting.tolerance;
}

/// Below this share of gravity, or of sqrt(g R), a motion is the rounding error of a ball that stopped.
inline constexpr double kStill = 1e-12;

/// Energy dissipated by a smooth motion, J/kg.
struct SmoothLoss {
    double rolling = 0.0;
    double slip = 0.0;
};

inline void book(const SmoothLoss &loss, Reporter &report) {
    report.lostRolling(loss.rolling);
    report.lostSlip(loss.slip);
}

inline Motion motionOf(const Ball &ball) { return {ball.velocity, ball.spin}; }

inline void setMotion(const Motion &motion, Ball &ball) {
    ball.velocity = motion.velocity;
    ball.spin = motion.spin;
}

/// Finds what the ball touches, or reaches within h (s) along any of the `ways` (m).
void lookAhead(const StepContext &context, const Ball &ball, std::span<const Vec3> ways, double h, Contacts &contacts);

/// A landing on a top face where the position moves with the old velocity. Such a flight gains speed, and the ball
/// would hop there for ever, with neither the drive nor the resistance of a rolling ball. It lands with the velocity
/// that corresponds to the flight's energy: model.md 13.5.
class ExplicitLanding {
public:
    /// Called before the impacts: changes the substep's velocity to that one.
    ExplicitLanding(const StepContext &context, const Contacts &contacts, double h, Ball &ball);
    /// Called after them: changes it back.
    void leave(Ball &ball) const;

private:
    double m_early; ///< speed by which a substep's velocity is ahead of that at its position, m/s
    bool m_lands = false;
};

/// The impacts of this moment, `after` seconds into the step, and their events. False if nothing hits. Contacts
/// opposite to each other, between which the ball would bounce back and forth without end, are hit one at a time: the
/// later ones are dropped. Moves the ball towards what it would reach within h (s), and changes the gaps accordingly.
bool hit(const StepContext &context, Contacts &contacts, double after, double h, Ball &ball);

/// The rolling model's spin at a top face, which follows the velocity: model.md 13.1.
class SpinOnFloor {
public:
    /// Called before the impacts.
    SpinOnFloor(const StepContext &context, const Contacts &contacts, const Ball &ball);
    /// Called after them: a ball that lands on a top face rolls from now on.
    void follow(const Contacts &contacts, Ball &ball);
    /// Whether that gave the ball another spin.
    bool turns(const Ball &ball) const { return m_follows && m_before != ball.spin; }
    /// Called after the motion. If a face didn't press at the end, the ball gets back the spin that it had.
    void settle(bool presses, Ball &ball) const;

private:
    const StepContext &m_context;
    Vec3 m_before;          ///< the ball's spin
    Vec3 m_atImpact;        ///< spin with which it meets the impacts: that of rolling if a top face carries it already
    bool m_isCarried;       ///< whether one does
    bool m_follows = false; ///< whether it follows now
    double m_jump = 0.0;    ///< energy that the spin lost in the impacts, J/kg
};

/// A substep with lasting contacts. Returns whether a top face pressed; presses: for each contact whether it did, or
/// empty.
bool hold(const StepContext &context, const Contacts &contacts, ContactRule kind, double h, Ball &ball,
          std::span<bool> presses = {});

/// Puts a ball exactly onto a face, where rounding has moved it off; a touching one loses its speed along the normal.
void snapToFace(const StepContext &context, const Contact &face, Ball &ball);

/// Speed along normals that several contacts may remove, relative to the largest along one: normals at least 29 degrees
/// apart.
inline constexpr double kMostTaken = 4.0;

/// The span of several normals.
class NormalSpan {
public:
    void add(const Vec3 &normal) {
        constexpr double kParallel = 1e-9;
        if (m_count == 3 || glm::length(across(normal)) <= kParallel) return;
        if (m_count == 0) m_first = normal;
        if (m_count == 1) m_along = glm::normalize(glm::cross(m_first, normal));
        ++m_count;
    }
    uint32_t count() const { return m_count; }
    /// The component of a vector orthogonal to all of them.
    Vec3 across(const Vec3 &vector) const {
        if (m_count == 0) return vector;
        if (m_count == 1) return vector - glm::dot(vector, m_first) * m_first;
        // Both orders of two normals give the same bits; there are no negative zeros.
        return m_count == 2 ? glm::dot(vector, m_along) * m_along + Vec3(0.0) : Vec3(0.0);
    }

private:
    Vec3 m_first{0.0}; ///< normal
    Vec3 m_along{0.0}; ///< unit, orthogonal to the first two
    uint32_t m_count = 0;
};

/// leastPush in the mean of both orders, which favours none; changes the order.
Vec3 leastWay(std::span<Push> pushes, double negligible);

/// Moves the ball out of all boxes without changing its velocity. False if there is no room for it.
bool leaveOverlaps(const StepContext &context, Ball &ball);

/// Reduces a ball's kinetic energy by that of a push that lifted it by `way`. False if it has less.
bool payForLift(const StepContext &context, const Vec3 &way, Ball &ball);

/// Whether a velocity is so small that `rests` must be evaluated, which is rarely so for a moving ball.
inline bool mayRest(const Setting &setting, const Vec3 &velocity) {
    const Vec3 gravity = glm::abs(setting.gravity());
    return glm::dot(velocity, velocity) <= 1e-23 * (gravity.x + gravity.y + gravity.z) * setting.scene.radius;
}

/// Whether the ball stays at rest: it doesn't move, and its contacts can hold it. May remove rounding errors from its
/// motion.
bool rests(const StepContext &context, Ball &ball);

} // namespace phys
