// SPDX-License-Identifier: MIT
// A stepper of fixed substeps. Where nothing is near a substep is the scheme's formula; contacts follow the law of
// contact (model.md 13.5). A scheme is a struct with its definition in the textbook, and how it goes on in contact:
//
//     template<class V> static Advance<V> advance(const Law<V> &law, const V &velocity, double h);
//     static constexpr Hold kHold;
#pragma once

#include "base/error.h"
#include "base/orientation.h"
#include "between_walls.h"
#include "contact/near.h"
#include "contact_step.h"
#include "overlap.h"
#include "requirements.h"
#include "scene/nearest.h"
#include "shared/law.h"

#include <physics/plugin.h>

#include <cmath>

namespace phys {

/// Energy that a smooth motion takes, J/kg.
struct SmoothLoss {
    double rolling = 0.0;
    double slip = 0.0;
};

template<class Scheme>
class DiscreteStep {
public:
    DiscreteStep(const Setting &setting, Reporter &report, const StepPlan &plan, double h)
        : m_plan(plan)
        , m_context{setting, report}
        , m_h(h) {}

    /// Whether a top face carries the ball.
    bool supports(const Ball &ball) const { return lookAround(ball).carrier; }

    /// Whether the ball stays as it is.
    bool rests(Ball &ball) const { return phys::rests(m_context, ball); }

    /// One substep that ends `after` seconds into the step. False if the ball is stuck.
    bool run(double after, Ball &ball) {
        const Around around = lookAround(ball);
        Ball free = ball;
        free.supported = around.carrier != nullptr;
        const SmoothLoss loss = move(free);
        if (m_plan.asReported) {
            book(loss);
            ball = free;
            collideAsReported(m_context, m_h, after, ball);
            return true;
        }
        if (!comesNear(around, ball, free)) {
            book(loss);
            ball = free;
            return true;
        }
        return runInContact(after - m_h, free, ball);
    }

    /// The same where no box is within reach but the one that carries the ball: false, and nothing done, elsewhere.
    bool runFarFromAnything(Ball &ball) {
        const Around around = lookAround(ball);
        Ball free = ball;
        free.supported = around.carrier != nullptr;
        const SmoothLoss loss = move(free);
        const bool staysOn = !around.carrier || Scene::isOver(*around.carrier, free.position.x, free.position.y);
        // The way may lead back: it stays in the triangle of its ends and this corner.
        const Vec3 way = free.position - ball.position;
        const Vec3 corner = 0.5 * m_h * ball.velocity;
        if (!staysOn || !isFar(around, way) || !isFar(around, corner)) return false;
        book(loss);
        ball = free;
        return true;
    }

    /// The smooth motion alone, as if there was nothing ahead.
    SmoothLoss move(Ball &ball) {
        if (!ball.supported) {
            moveBy(flightLaw(m_context.params()), ball);
            return {};
        }
        ball.velocity.z = 0.0;
        const phys_params &params = m_context.params();
        const FloorContact contact = floorContact(params, m_context.radius(), inPlane(ball.velocity), ball.spin);
        if (contact == FloorContact::Slips) return slipOn(ball);
        return roll(contact, velocityLaw(contact, params), ball);
    }

    /// The closed form where nothing but smooth upright walls are near a ball that rolls. False if it isn't that.
    bool rollBetweenWalls(const Contacts &contacts, Ball &ball) {
        const phys_params &params = m_context.params();
        const double radius = m_context.radius();
        std::optional<UprightWalls> walls = UprightWalls::find(m_context, contacts, ball);
        if (!walls || params.gravity.z >= 0.0) return false;
        const FloorContact contact = floorContact(params, radius, inPlane(ball.velocity), ball.spin);
        if (contact == FloorContact::Slips) return false;
        Law<Vec2> law = velocityLaw(contact, params);
        Ball next = ball;
        const double tolerance = m_context.scene().tolerance;
        std::optional<Vec2> drive;
        const bool keeps = Scheme::kHold == Hold::SecondOrder && !walls->arrives(tolerance, ball);
        if (Scheme::kHold == Hold::SecondOrder && walls->turns(ball)) return false;
        drive = keeps ? walls->keepDrive(law.A, tolerance, next) : walls->limitDrive(law.A, m_h, tolerance, next);
        if (!drive) return false;
        const bool grips = m_context.isRigid() && contact == FloorContact::Rolls;
        if (grips && glm::length(*drive) > 2.5 * params.sliding_friction * -params.gravity.z) return false;
        const Vec2 taken = law.A - *drive;
        law.A = *drive;
        const SmoothLoss loss = roll(contact, law, next);
        if (!keeps) {
            if (!walls->limitVelocity(taken, m_h, tolerance, ball, next)) return false;
            next.spin = spinAfter(contact, inPlane(next.velocity), next.spin, radius);
        }
        walls->arrive(m_context.scene(), next);
        book(loss);
        ball = next;
        return true;
    }

private:
    struct Around {
        const phys_box *carrier; ///< the box on whose top the ball lies, or nullptr
        double nearestSquared;   ///< of the other boxes: square of the distance to the centre, m^2
    };

    Around lookAround(const Ball &ball) const {
        const Scene &scene = m_context.scene();
        const Vec3 &p = ball.position;
        const bool mayRest = m_context.params().gravity.z < 0.0 && std::abs(ball.velocity.z) <= negligibleFall(ball);
        Around around{nullptr, INFINITY};
        visitNear(scene, p, kCandidateReach * scene.radius, [&](const phys_box &box, uint32_t) {
            const bool carries = mayRest && std::abs(p.z - (box.max.z + scene.radius)) <= scene.tolerance &&
                                 Scene::isOver(box, p.x, p.y);
            if (carries)
                around.carrier = &box;
            else
                around.nearestSquared = std::min(around.nearestSquared, squaredDistance(box, p));
        });
        return around;
    }

    /// Fall in a time too short to count.
    double negligibleFall(const Ball &ball) const {
        return ball.velocity.z == 0.0 ? 0.0 : negligibleSpeed(motionOf(ball), m_context.radius());
    }

    /// Whether nothing but what carries the ball is within the reach of its way.
    bool isFar(const Around &around, const Vec3 &way) const {
        const Scene &scene = m_context.scene();
        const double reach = scene.radius + scene.tolerance + std::abs(way.x) + std::abs(way.y) + std::abs(way.z);
        return reach <= kCandidateReach * scene.radius && reach * reach < around.nearestSquared;
    }

    /// Whether the ball touches anything but what carries it, or would overlap it at the end.
    bool comesNear(const Around &around, const Ball &ball, const Ball &free) const {
        const Scene &scene = m_context.scene();
        const double touching = scene.radius + scene.tolerance;
        if (around.nearestSquared <= touching * touching) return true;
        if (!m_plan.runs(PHYS_STAGE_SUBSTEPS) && isFar(around, free.position - ball.position)) return false;
        const double overlapping = scene.radius - scene.tolerance;
        bool overlaps = false;
        visitNear(scene, free.position, scene.radius, [&](const phys_box &box, uint32_t) {
            overlaps = overlaps || squaredDistance(box, free.position) < overlapping * overlapping;
        });
        return overlaps;
    }

    /// v = 0 stays 0 up to the stiction limit, the limit included: model.md 2.1 R4.
    SmoothLoss roll(FloorContact contact, Law<Vec2> law, Ball &ball) {
        law.resists = m_plan.runs(PHYS_STAGE_RESISTANCE);
        const Vec2 velocity = inPlane(ball.velocity);
        const Vec3 start = ball.position;
        const bool stays = velocity == Vec2(0.0) && glm::dot(law.A, law.A) <= law.B * law.B;
        if (stays) {
            // nothing moves
        } else if (m_plan.runs(PHYS_STAGE_VERTICAL)) {
            moveBy(Law<Vec3>{Vec3(law.A, 0.0), law.B, law.resists}, ball);
        } else {
            const Advance<Vec2> next = Scheme::advance(law, velocity, m_h);
            ball.velocity = Vec3(next.velocity, 0.0);
            ball.position += Vec3(next.displacement, 0.0);
        }
        const double spinAcross = m_context.isRigid() ? ball.spin.z : 0.0;
        ball.spin =
            spinAfter(contact, inPlane(ball.velocity), {ball.spin.x, ball.spin.y, spinAcross}, m_context.radius());
        return {m_context.report.wanted() ? 1.4 * law.B * glm::length(ball.position - start) : 0.0, 0.0};
    }

    void moveBy(const Law<Vec3> &law, Ball &ball) const {
        const Advance<Vec3> next = Scheme::advance(law, ball.velocity, m_h);
        ball.velocity = next.velocity;
        ball.position += next.displacement;
    }

    SmoothLoss slipOn(Ball &ball) {
        const phys_params &params = m_context.params();
        double path = 0.0;
        const Advance<Vec2> next = slip<Scheme>(params, m_context.radius(), m_h, inPlane(ball.velocity), ball.spin,
                                                m_context.report.wanted() ? &path : nullptr);
        ball.velocity = Vec3(next.velocity, 0.0);
        ball.position += Vec3(next.displacement, 0.0);
        return {0.0, params.sliding_friction * -params.gravity.z * path};
    }

    /// All contacts of the substep that begins `start` seconds into the step. free: the ball after it without them.
    [[gnu::noinline]] bool runInContact(double start, const Ball &free, Ball &ball) {
        const Ball before = ball;
        // The explicit rule moves with the old velocity, and along normals that press with the new one.
        const Vec3 ways[] = {free.position - ball.position, m_h * free.velocity};
        Contacts contacts;
        lookAhead(m_context, ball, std::span(ways, Scheme::kHold == Hold::Explicit ? 2 : 1), m_h, contacts);
        SpinOnFloor spin(m_context, contacts, ball);
        hit(m_context, contacts, start, ball);
        spin.follow(contacts, ball);
        if (rollBetweenWalls(contacts, ball)) {
            spin.settle(true, ball);
        } else {
            spin.settle(holdContacts(contacts, ball), ball);
        }
        if (leaveOverlaps(m_context, ball)) return true;
        // It doesn't fit where it was going. Where it came from it did, unless it started inside something.
        ball = before;
        ball.velocity = Vec3(0.0);
        ball.spin = Vec3(0.0);
        return leaveOverlaps(m_context, ball);
    }

    /// A substep of all contacts. Returns whether a top face pressed.
    bool holdContacts(const Contacts &contacts, Ball &ball) {
        if (Scheme::kHold != Hold::SecondOrder) return hold(m_context, contacts, Scheme::kHold, m_h, ball);
        Ball start = ball;
        const Contacts kept = keepContacts(contacts, start);
        const bool arrives = kept.count() > 1 && std::any_of(kept.begin(), kept.end(), [&](const Contact &contact) {
                                 return contact.gap > m_context.scene().tolerance;
                             });
        if (!arrives) {
            Reporter silent(nullptr, 0.0);
            Ball next = start;
            const bool pressesOnTop = holdOrFly({m_context.setting, silent}, kept, next);
            if (kept.empty() || !overlapsAnother(contacts, kept, next)) {
                const bool presses = m_context.report.wanted() ? holdOrFly(m_context, kept, start) : pressesOnTop;
                ball = m_context.report.wanted() ? start : next;
                return presses;
            }
        }
        // Held at one contact it comes to another within the substep: the rule that closes gaps meets both.
        return hold(m_context, contacts, Hold::Symplectic, m_h, ball);
    }

    bool holdOrFly(const StepContext &context, const Contacts &contacts, Ball &ball) const {
        if (!contacts.empty()) return hold(context, contacts, Hold::SecondOrder, m_h, ball);
        moveBy(flightLaw(m_context.params()), ball);
        return false;
    }

    /// Whether the ball overlaps a box that it came near to, but for those that it is held at.
    bool overlapsAnother(const Contacts &contacts, const Contacts &held, const Ball &ball) const {
        const Scene &scene = m_context.scene();
        const double overlapping = scene.radius - scene.tolerance;
        return std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
            const bool isHeld =
                std::any_of(held.begin(), held.end(), [&](const Contact &other) { return other.box == contact.box; });
            return !isHeld && squaredDistance(scene.boxes[contact.box], ball.position) < overlapping * overlapping;
        });
    }

    /// The contacts that the ball doesn't leave; it may leave those it touches with a speed that is none.
    Contacts keepContacts(const Contacts &contacts, Ball &ball) const {
        Contacts result = contacts;
        NormalSpan kept;
        result.drop([&](const Contact &contact) {
            const double speed = glm::dot(ball.velocity, contact.normal);
            const bool isTouched = contact.gap <= m_context.scene().tolerance;
            if (speed > 0.0 && (!isTouched || speed > contact.restSpeed)) return true;
            if (isTouched) kept.add(contact.normal);
            return false;
        });
        ball.velocity = kept.across(ball.velocity);
        return result;
    }

    void book(const SmoothLoss &loss) const {
        m_context.report.lostRolling(loss.rolling);
        m_context.report.lostSlip(loss.slip);
    }

    StepPlan m_plan;
    StepContext m_context;
    double m_h;
};

} // namespace phys
