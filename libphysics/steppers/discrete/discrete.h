// SPDX-License-Identifier: MIT
// A stepper of fixed substeps: move by the scheme's formula, then resolve overlaps (definition D of model.md 10).
// A scheme is a struct with one function, its definition in the textbook:
//
//     template<class V> static Advance<V> advance(const Law<V> &law, const V &velocity, double h);
#pragma once

#include "base/error.h"
#include "base/orientation.h"
#include "requirements.h"
#include "shared/law.h"
#include "surroundings.h"
#include "wall_slide.h"

#include <physics/plugin.h>

#include <cmath>

namespace phys {

template<class Scheme>
class DiscreteStep {
public:
    DiscreteStep(const Scene &scene, const phys_params &params, Reporter &report, const StepPlan &plan, double h)
        : m_plan(plan)
        , m_context{scene, params, report, plan.bounce, params.model == PHYS_MODEL_RIGID, plan.runs(PHYS_STAGE_GRID),
                    h} {}

    /// Whether the floor or a solid's flat top carries the ball.
    bool supports(const Ball &ball) const { return isSupported(lookAround(m_context, ball.position), ball); }

    /// One substep that ends `after` seconds into the step. False if the ball is stuck.
    bool run(double after, Ball &ball) {
        // It may have come down exactly on the floor with the last substep.
        if (ball.velocity.z < 0.0 && isOnFloor(ball)) landAt(after - m_context.h, ball);
        const Surroundings around = lookAround(m_context, ball.position);
        const Ball before = ball;
        const Vec3 drive = move(around, ball);
        if (!ball.supported && fallsThroughFloor(before, ball)) landAt(after, ball);
        const bool free = !canTouch(around, before, ball) || resolveOverlaps(m_context, before, drive, after, ball);
        slaveSpin(ball);
        return free;
    }

    /// The smooth motion alone, as if there was nothing ahead. Returns the acceleration that drives it.
    Vec3 move(const Surroundings &around, Ball &ball) {
        ball.supported = isSupported(around, ball);
        if (!ball.supported) return fly(ball);
        ball.velocity.z = 0.0;
        const Vec2 drive = m_context.rigid ? moveRigid(around, ball) : moveRolling(around, ball);
        slaveSpin(ball);
        return Vec3(drive, 0.0);
    }

    /// Whether the ball stays as it is: v = 0 and the resistance holds what the walls leave, model.md 6.3.
    bool rests(const Ball &ball) const {
        if (ball.velocity != Vec3(0.0)) return false;
        const Surroundings around = lookAround(m_context, ball.position);
        if (!isSupported(around, ball)) return false;
        const phys_params &params = m_context.params;
        const bool frictionless = m_context.rigid && params.sliding_friction == 0.0;
        if (m_context.rigid && !frictionless && inPlane(ball.spin) != Vec2(0.0)) return false;
        const Law<Vec2> law = velocityLaw(frictionless ? FloorContact::Slides : FloorContact::Rolls, params);
        const Vec2 drive = findPressing(m_context, around, ball, law.A).freePart(law.A);
        // Where friction can't hold the ball, only walls that take the whole force can.
        const double hold = m_context.rigid && !gripHolds(params) ? 0.0 : law.B;
        return glm::dot(drive, drive) <= hold * hold;
    }

private:
    bool isOnFloor(const Ball &ball) const {
        const Scene &scene = m_context.scene;
        const Vec3 &p = ball.position;
        return std::abs(p.z - scene.supportedZ) <= scene.tolerance && ball.velocity.z <= 0.0 && // false without a floor
               scene.overFloor(p.x, p.y);
    }

    /// By what gravity presses the ball on.
    bool isSupported(const Surroundings &around, const Ball &ball) const {
        if (m_context.params.gravity.z >= 0.0 || ball.velocity.z > 0.0) return false;
        return isOnFloor(ball) || carriedBySolid(m_context, around, ball.position);
    }

    /// In the rolling model the spin of a supported ball follows its velocity, model.md 2.1 R7.
    void slaveSpin(Ball &ball) const {
        if (!m_context.rigid && ball.supported) ball.spin = rollingSpin(inPlane(ball.velocity), m_context.scene.radius);
    }

    /// Leaves out the search for overlaps where the ball has not come as far as the nearest box was away.
    bool canTouch(const Surroundings &around, const Ball &before, const Ball &ball) const {
        if (m_plan.runs(PHYS_STAGE_SUBSTEPS) || !ball.supported) return true;
        const double radius = m_context.scene.radius;
        const Vec2 moved = inPlane(ball.position) - inPlane(before.position);
        const double reach = radius + std::abs(moved.x) + std::abs(moved.y);
        return reach > kCandidateReach * radius || reach * reach >= around.nearestSquared;
    }

    Vec2 moveRolling(const Surroundings &around, Ball &ball) {
        const Law<Vec2> law = rollingLaw(m_context.params);
        roll(around, law, ball);
        return law.A;
    }

    bool touches(const Surroundings &around) const {
        const double reach = m_context.scene.radius + m_context.scene.tolerance;
        return around.nearestSquared <= reach * reach;
    }

    /// The law on the free directions; v = 0 stays 0 up to the stiction limit, the limit included: model.md 2.1 R4.
    void roll(const Surroundings &around, Law<Vec2> law, Ball &ball) {
        if (m_context.bounce != Bounce::Plain && touches(around)) {
            law.A = findPressing(m_context, around, ball, law.A).freePart(law.A);
        }
        law.resists = m_plan.runs(PHYS_STAGE_RESISTANCE);
        const Vec2 velocity = inPlane(ball.velocity);
        if (velocity == Vec2(0.0) && glm::dot(law.A, law.A) <= law.B * law.B) return;
        const Vec3 start = ball.position;
        if (m_plan.runs(PHYS_STAGE_VERTICAL)) {
            moveBy(Law<Vec3>{Vec3(law.A, 0.0), law.B, law.resists}, ball);
        } else {
            const Advance<Vec2> next = Scheme::advance(law, velocity, m_context.h);
            ball.velocity = Vec3(next.velocity, 0.0);
            ball.position += Vec3(next.displacement, 0.0);
        }
        if (m_context.report.wanted()) m_context.report.lostRolling(1.4 * law.B * glm::length(ball.position - start));
    }

    void moveBy(const Law<Vec3> &law, Ball &ball) const {
        const Advance<Vec3> next = Scheme::advance(law, ball.velocity, m_context.h);
        ball.velocity = next.velocity;
        ball.position += next.displacement;
    }

    Vec2 moveRigid(const Surroundings &around, Ball &ball) {
        const phys_params &params = m_context.params;
        const double radius = m_context.scene.radius;
        const FloorContact contact = floorContact(params, radius, inPlane(ball.velocity), ball.spin);
        const bool slips = contact == FloorContact::Slips;
        const Law<Vec2> law = velocityLaw(contact, params);
        const Vec2 drive = slips ? slippingDrive(ball, params, radius) : law.A;
        const Pressing pressing = findPressing(m_context, around, ball, drive);
        if (pressing.any() && (slips || params.wall_friction > 0.0)) {
            ball.position += Vec3(slideAlongWalls(m_context, pressing, ball), 0.0);
        } else if (slips) {
            slipOn(ball);
        } else {
            roll(around, law, ball);
            ball.spin = spinAfter(contact, inPlane(ball.velocity), ball.spin, radius);
        }
        return drive;
    }

    void slipOn(Ball &ball) {
        const phys_params &params = m_context.params;
        double path = 0.0;
        const Advance<Vec2> next = slip<Scheme>(params, m_context.scene.radius, m_context.h, inPlane(ball.velocity),
                                                ball.spin, m_context.report.wanted() ? &path : nullptr);
        ball.velocity = Vec3(next.velocity, 0.0);
        ball.position += Vec3(next.displacement, 0.0);
        m_context.report.lostSlip(params.sliding_friction * -params.gravity.z * path);
    }

    Vec3 fly(Ball &ball) const {
        const Law<Vec3> law = flightLaw(m_context.params);
        moveBy(law, ball);
        return law.A;
    }

    void landAt(double after, Ball &ball) const {
        land(m_context, landingSpeed(m_context, -ball.velocity.z), after, ball);
    }

    bool fallsThroughFloor(const Ball &before, const Ball &ball) const {
        const Scene &scene = m_context.scene;
        return before.position.z >= scene.supportedZ && ball.position.z < scene.supportedZ && // false without a floor
               scene.overFloor(ball.position.x, ball.position.y);
    }

    StepPlan m_plan;
    StepContext m_context;
};

} // namespace phys
