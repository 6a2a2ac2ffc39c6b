// SPDX-License-Identifier: MIT
// What contacts do to a ball in a substep: the law of contact (model.md 13) in the form that fixed substeps need.
#pragma once

#include "contact/ball.h"
#include "contact/impact.h"
#include "contact/lasting.h"
#include "registry/report.h"

#include <glm/common.hpp>

namespace phys {

/// Slip below this share of the speeds is none.
inline constexpr double kRolling = 1e-9;

/// What stays the same during one step.
struct StepContext {
    Setting setting;
    Reporter &report;
    Work &work; ///< of lasting contacts

    const Scene &scene() const { return setting.scene; }
    const phys_params &params() const { return setting.params; }
    double radius() const { return setting.scene.radius; }
    bool isRigid() const { return setting.isRigid(); }
};

/// Below this share of gravity, or of sqrt(g R), is what rounding leaves of a ball that stopped.
inline constexpr double kStill = 1e-12;

inline Motion motionOf(const Ball &ball) { return {ball.velocity, ball.spin}; }

inline void setMotion(const Motion &motion, Ball &ball) {
    ball.velocity = motion.velocity;
    ball.spin = motion.spin;
}

/// Finds what the ball touches or reaches within h (s) on any of the `ways` (m).
void lookAhead(const StepContext &context, const Ball &ball, std::span<const Vec3> ways, double h, Contacts &contacts);

/// A landing on a top face where the position moves with the old velocity: such a flight gains speed, and the ball
/// would hop there for ever, with neither the drive nor the resistance of one that rolls. The ball bounces with the
/// speed that the flight's energy has at the face: model.md 13.5.
class ExplicitLanding {
public:
    /// Before the impacts: from the substep's velocity to that at the face.
    ExplicitLanding(const StepContext &context, const Contacts &contacts, double h, Ball &ball);
    /// After them: back.
    void leave(Ball &ball) const;

private:
    bool m_lands = false;
    double m_head = 0.0; ///< what the gap gives to the square of the speed, m^2/s^2
    double m_early;      ///< speed by which a substep's velocity is ahead of its place's, m/s
};

/// The impacts of this moment, `after` seconds into the step, and their events. False if nothing hits. Contacts
/// that face one another, between which the ball would bounce to and fro without an end, are met one at a time: the
/// later ones are dropped.
bool hit(const StepContext &context, Contacts &contacts, double after, Ball &ball);

/// The rolling model's spin at a top face, which follows the velocity: model.md 13.1.
class SpinOnFloor {
public:
    /// Before the impacts.
    SpinOnFloor(const StepContext &context, const Contacts &contacts, const Ball &ball);
    /// After them: what comes down on a top face rolls from here on.
    void follow(const Contacts &contacts, Ball &ball);
    /// After the motion. A face that didn't press in the end gives the ball back the spin that it had.
    void settle(bool presses, Ball &ball) const;

private:
    const StepContext &m_context;
    bool m_rolled = false;  ///< already before the impacts
    bool m_follows = false; ///< does now
    Vec3 m_before;          ///< spin before the impacts
    double m_jump = 0.0;    ///< energy that the spin lost when it began to follow, J/kg
};

/// How a substep goes on with the motion that its lasting contacts leave.
enum class ContactRule {
    Symplectic,  ///< with the new velocity
    Explicit,    ///< with the old one, but for what contacts take of it
    SecondOrder, ///< with their mean
};

/// A substep with lasting contacts. Returns whether a top face pressed; presses: whether each contact did, or empty.
bool hold(const StepContext &context, const Contacts &contacts, ContactRule kind, double h, Ball &ball,
          std::span<bool> presses = {});

/// Puts a ball onto a face exactly, where rounding would leave it beside; a touching one loses its speed along it.
void snapToFace(const StepContext &context, const Contact &face, Ball &ball);

/// Speed along normals that contacts may take together, of the fastest along one: normals of at least 29 degrees.
inline constexpr double kMostTaken = 4.0;

/// What several normals span.
class NormalSpan {
public:
    void add(const Vec3 &normal);
    uint32_t count() const { return m_count; }
    /// The part of a vector that is at right angles to all of them.
    Vec3 across(const Vec3 &vector) const;

private:
    Vec3 m_first{0.0}; ///< normal
    Vec3 m_along{0.0}; ///< unit, at right angles to the first two
    uint32_t m_count = 0;
};

/// Moves the ball out of all boxes. Its velocity stays. False if there is no room for it.
bool leaveOverlaps(const StepContext &context, Ball &ball);

/// Takes from a ball's motion the energy of a push that lifted it by `way`. One that began the substep, with these
/// contacts, inside a box is lifted for nothing.
void payForLift(const StepContext &context, const Contacts &contacts, const Vec3 &way, Ball &ball);

/// Whether a velocity is so small that `rests` needs to be asked. Seldom true of one that moves on.
inline bool mayRest(const Setting &setting, const Vec3 &velocity) {
    const Vec3 gravity = glm::abs(setting.gravity());
    return glm::dot(velocity, velocity) <= 1e-23 * (gravity.x + gravity.y + gravity.z) * setting.scene.radius;
}

/// Whether the ball stays as it is: it stands still, and its contacts can hold it. May take rounding from its motion.
bool rests(const StepContext &context, Ball &ball);

} // namespace phys
