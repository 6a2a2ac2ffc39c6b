// SPDX-License-Identifier: MIT
// A substep of a ball that lies on a floor and meets only smooth vertical faces: bounces act along one axis, and faces
// remove part of the drive, model.md 13.5. Everything else is left to DiscreteStep.
#pragma once

#include "contact_step.h"
#include "floor_contact.h"
#include "floor_view.h"
#include "requirements.h"

#include <cmath>
#include <optional>

namespace phys {

/// Speeds below this share count as zero.
inline constexpr double kZero = 1e-9;

template<class Scheme>
class FloorRun {
public:
    /// A substep of h seconds. The context must outlive it.
    FloorRun(const StepContext &context, const StepPlan &plan, double h)
        : m_context(context)
        , m_stages(plan.stages)
        , m_h(h) {}

    /// Makes the substep, which begins `start` seconds into the step. If the ball may meet anything else, returns false
    /// and changes nothing.
    bool run(double start, Ball &ball) const {
        if (!liesOnFloor(ball)) return false;
        const Ahead ahead = rollAhead(ball);
        const Vec3 end = ball.position + Vec3(ahead.roll.displacement, 0.0);
        FloorView view;
        if (!view.look(m_context, ball.position, end, sum(ahead.roll.displacement))) return false;
        if (!view.isEmpty() && !view.findFaces(m_context, ball.position, end)) return false;
        if (!view.faces().empty()) return meetFaces(start, view, ball);
        if (mayLean(view, ball, ahead.roll.velocity)) return false;
        finish(ahead.roll, ball);
        return true;
    }

    /// The same without any event: the ball rolls freely, or along faces that it touches and doesn't leave. For a
    /// stepper with events inside a step: returns false and changes nothing if there may be an event.
    bool glide(Ball &ball) const {
        if (!liesOnFloor(ball)) return false;
        Ahead ahead = rollAhead(ball);
        const bool slips = ahead.contact == FloorContact::Slips;
        if (slips && m_context.params().rolling_friction > 0.0) return false; // starts once the slip has ended
        // The ball may reverse: its path stays in the bounds of its ends and this corner.
        const Vec2 turn = m_h * shareOfTurn(ahead.law, inPlane(ball.velocity), m_h) * inPlane(ball.velocity);
        const Vec3 end = ball.position + Vec3(ahead.roll.displacement, 0.0);
        FloorView view;
        if (!view.look(m_context, ball.position, end, std::max(sum(turn), sum(ahead.roll.displacement)))) return false;
        if (!view.isEmpty()) {
            if (!view.findFaces(m_context, ball.position, ball.position)) return false;
            if (!view.faces().empty() && (slips || !rollAlong(view.faces(), ball, ahead))) return false;
            const Vec2 from = inPlane(ball.position), to = from + ahead.roll.displacement, corner = from + turn;
            if (!view.isClear(m_context, glm::min(from, glm::min(to, corner)), glm::max(from, glm::max(to, corner))))
                return false;
        }
        finish(ahead.roll, ball);
        return true;
    }

    Law<Vec2> lawOnFloor(FloorContact contact) const { return velocityLaw(contact, m_context.params()); }

    /// The smooth motion of a ball on the floor alone.
    SmoothLoss roll(FloorContact contact, const Law<Vec2> &law, Ball &ball) const {
        FreeRoll next;
        rollFreely(contact, law, ball, next);
        place(next, ball);
        return next.loss;
    }

    /// Whether friction on the floor suffices for the part of the drive that the walls leave.
    bool grips(FloorContact contact, const Vec2 &drive) const {
        const phys_params &params = m_context.params();
        const bool needsGrip = m_context.isRigid() && contact == FloorContact::Rolls;
        return !needsGrip || glm::length(drive) <= 2.5 * params.sliding_friction * -params.gravity.z;
    }

    /// What is lost, J/kg, as the spin of a ball that a floor begins to carry becomes that of rolling: model.md 2.1 R7.
    double lossOfSpin(const Ball &ball) const {
        if (!m_context.report.wanted() || m_context.isRigid()) return 0.0;
        const double radius = m_context.radius();
        return spinEnergy(ball.spin, radius) - spinEnergy(rollingSpin(inPlane(ball.velocity), radius), radius);
    }

    void book(const SmoothLoss &loss) const { phys::book(loss, m_context.report); }

private:
    /// The result of the smooth law for a motion on the floor.
    struct FreeRoll {
        Vec2 velocity, displacement;
        Vec3 spin;
        SmoothLoss loss;
    };

    /// The substep as if there were no walls.
    struct Ahead {
        FloorContact contact;
        Law<Vec2> law; ///< valid unless the contact slips
        FreeRoll roll;
    };

    /// Never smaller than the length.
    static double sum(const Vec2 &v) { return std::abs(v.x) + std::abs(v.y); }

    bool liesOnFloor(const Ball &ball) const { return ball.velocity.z == 0.0 && m_context.params().gravity.z <= 0.0; }

    Ahead rollAhead(const Ball &ball) const {
        const FloorContact contact =
            floorContact(m_context.params(), m_context.radius(), inPlane(ball.velocity), ball.spin);
        const Law<Vec2> law = lawOnFloor(contact);
        Ahead ahead{contact, law, {}};
        rollFreely(contact, law, ball, ahead.roll);
        return ahead;
    }

    // Stored one by one: a processor stalls if it loads together what was just stored separately, which would make
    // swept a tenth slower.
    static void set(Vec2 &to, const Vec2 &from) { to.x = from.x, to.y = from.y; }
    static void set(Vec3 &to, const Vec3 &from) { to.x = from.x, to.y = from.y, to.z = from.z; }

    static void place(const FreeRoll &next, Ball &ball) {
        ball.position.x += next.displacement.x;
        ball.position.y += next.displacement.y;
        set(ball.velocity, Vec3(next.velocity, 0.0));
        set(ball.spin, next.spin);
    }

    void finish(const FreeRoll &next, Ball &ball) const {
        m_context.report.lostSlip(lossOfSpin(ball));
        book(next.loss);
        place(next, ball);
        ball.supported = true;
    }

    void rollFreely(FloorContact contact, const Law<Vec2> &law, const Ball &ball, FreeRoll &next) const {
        if (contact == FloorContact::Slips) {
            next = slipFreely(ball);
            return;
        }
        const Advance<Vec2> moved = advance(law, inPlane(ball.velocity));
        const double drilling = m_context.isRigid() ? ball.spin.z : 0.0;
        const Vec3 spin(ball.spin.x, ball.spin.y, drilling);
        set(next.velocity, moved.velocity);
        set(next.displacement, moved.displacement);
        set(next.spin, spinAfter(contact, moved.velocity, spin, m_context.radius()));
        next.loss.rolling = m_context.report.wanted()
                                ? 1.4 * law.B * resistedWay<Scheme>(law, inPlane(ball.velocity), moved, m_h)
                                : 0.0;
        next.loss.slip = 0.0;
    }

    FreeRoll slipFreely(const Ball &ball) const {
        const phys_params &params = m_context.params();
        double path = 0.0;
        Vec3 spin = ball.spin;
        const Advance<Vec2> slipped = slip<Scheme>(params, m_context.radius(), m_h, inPlane(ball.velocity), spin,
                                                   m_context.report.wanted() ? &path : nullptr);
        const double lost = params.sliding_friction * -params.gravity.z * path;
        return {slipped.velocity, slipped.displacement, spin, {0.0, lost}};
    }

    /// v = 0 stays 0 up to the stiction limit, including the limit: model.md 2.1 R4.
    Advance<Vec2> advance(const Law<Vec2> &law, const Vec2 &velocity) const {
        if (velocity == Vec2(0.0) && glm::dot(law.A, law.A) <= law.B * law.B) return {Vec2(0.0), Vec2(0.0)};
        if (!(m_stages & PHYS_STAGE_VERTICAL)) return Scheme::advance(law, velocity, m_h);
        const Law<Vec3> inSpace{Vec3(law.A, 0.0), law.B};
        const Advance<Vec3> moved = Scheme::advance(inSpace, Vec3(velocity, 0.0), m_h);
        return {inPlane(moved.velocity), inPlane(moved.displacement)};
    }

    /// A bounce off the faces that are approached fast enough. Returns whether there was one. Moves the ball towards
    /// them: restitution takes its share of the gaps too, model.md 13.5.
    bool bounce(std::span<UprightFace> faces, Ball &ball) const {
        const auto restSpeed = [&](const UprightFace &face) { return restSpeedOf(face); };
        const auto approach = [&](const UprightFace &face) { return -ball.velocity[face.axis] * face.normal; };
        if (std::none_of(faces.begin(), faces.end(),
                         [&](const UprightFace &face) { return approach(face) > restSpeed(face); }))
            return false;
        const double negligible = negligibleSpeed(motionOf(ball), m_context.radius());
        for (UprightFace &face : faces) {
            const double speed = approach(face);
            if (speed <= negligible) continue;
            const double restitution = speed > restSpeed(face) ? m_context.params().restitution_wall : 0.0;
            ball.velocity[face.axis] += (1.0 + restitution) * speed * face.normal;
            const double left = restitution * restitution * face.gap;
            const double climb = (&m_context.params().gravity.x)[face.axis] * face.normal * face.gap;
            if (face.gap - left <= m_context.setting.tolerance || climb > 0.5 * speed * speed) continue;
            face.gap = left;
            ball.position[face.axis] = face.place + left * face.normal;
        }
        return true;
    }

    double restSpeedOf(const UprightFace &face) const {
        return 2.0 * m_h * std::max(0.0, -(&m_context.params().gravity.x)[face.axis] * face.normal);
    }

    /// Rolls along faces that the ball touches and continues to touch, under the drive that they leave. False if it
    /// leaves them, or may stop.
    bool rollAlong(std::span<const UprightFace> faces, const Ball &ball, Ahead &ahead) const {
        if (m_context.hasRoughWalls()) return false;
        const Vec2 velocity = inPlane(ball.velocity);
        for (const UprightFace &face : faces) {
            if (velocity[face.axis] != 0.0) return false;
            if (ahead.law.A[face.axis] * face.normal < 0.0) ahead.law.A[face.axis] = 0.0;
        }
        if (!grips(ahead.contact, ahead.law.A)) return false;
        rollFreely(ahead.contact, ahead.law, ball, ahead.roll);
        const bool mayStop = ahead.law.B > 0.0 && velocity != Vec2(0.0);
        return !mayStop || glm::dot(ahead.roll.velocity, velocity) > kZero * glm::dot(velocity, velocity);
    }

    /// Whether the explicit rule, which moves with the old velocity, may lean on what only the new one leads to, and
    /// which changes the pressure on the floor: a rough edge that the ball rounds, or the edge of a roof or a kerb.
    bool mayLean(const FloorView &view, const Ball &ball, const Vec2 &newVelocity) const {
        if constexpr (Scheme::kContactRule != ContactRule::Explicit) return false;
        const bool mayPress =
            m_context.hasRoughWalls() ? !view.isEmpty() : m_context.rubsOnFloor() && view.hasSlopes(m_context, ball);
        return mayPress && !view.hasRoom(m_context, ball.position, ball.position + m_h * Vec3(newVelocity, 0.0));
    }

    bool meetFaces(double start, FloorView &view, Ball &ball) const {
        const phys_params &params = m_context.params();
        if (m_context.hasRoughWalls()) return false;
        const std::span<UprightFace> faces = view.faces();
        Ball next = ball;
        next.supported = true;
        const bool bounces = bounce(faces, next);
        const Ball bounced = next;
        const FloorContact contact = floorContact(params, m_context.radius(), inPlane(next.velocity), next.spin);
        const std::optional<SmoothLoss> loss =
            contact == FloorContact::Slips ? slipAway(faces, next) : rollBeside(contact, faces, next);
        if (!loss || !view.hasRoom(m_context, ball.position, next.position)) return false;
        m_context.report.lostSlip(lossOfSpin(ball));
        book(*loss);
        if (bounces) bookBounce(start, faces, ball, bounced);
        ball = next;
        return true;
    }

    bool isTouched(const UprightFace &face) const { return face.gap <= m_context.scene().tolerance; }

    /// Slips on the floor without pressing on any face. Nothing, if it would.
    std::optional<SmoothLoss> slipAway(std::span<const UprightFace> faces, Ball &ball) const {
        const Vec3 before = ball.velocity;
        const SmoothLoss loss = roll(FloorContact::Slips, {}, ball);
        const bool isAway = std::all_of(faces.begin(), faces.end(), [&](const UprightFace &face) {
            const bool isLeft = ball.velocity[face.axis] * face.normal >= (isTouched(face) ? 0.0 : -face.gap / m_h);
            return isLeft && (Scheme::kContactRule != ContactRule::SecondOrder || leaves(face, before));
        });
        return isAway ? std::optional(loss) : std::nullopt;
    }

    /// Order 2 keeps a ball at the faces that it leaves more slowly.
    bool leaves(const UprightFace &face, const Vec3 &velocity) const {
        return velocity[face.axis] * face.normal > (isTouched(face) ? restSpeedOf(face) : 0.0);
    }

    /// Rolls or slides along the faces that the drive presses it on. Nothing, if friction on the floor doesn't suffice.
    std::optional<SmoothLoss> rollBeside(FloorContact contact, std::span<const UprightFace> faces, Ball &ball) const {
        Law<Vec2> law = lawOnFloor(contact);
        // While held at one face the ball comes to another within the substep: the rule of order 1 handles both.
        const bool arrives = std::any_of(faces.begin(), faces.end(), [&](const UprightFace &face) {
            return !isTouched(face) && ball.velocity[face.axis] * face.normal <= 0.0;
        });
        const bool keeps = Scheme::kContactRule == ContactRule::SecondOrder && !arrives;
        std::array<bool, 2> presses{};
        for (uint32_t i = 0; i < faces.size(); ++i) {
            const UprightFace &face = faces[i];
            double &speed = ball.velocity[face.axis];
            double &drive = law.A[face.axis];
            if (keeps) {
                if (leaves(face, ball.velocity)) continue;
                if (speed != 0.0) speed = 0.0; // a zero keeps its sign, as in a region
                presses[i] = drive * face.normal < 0.0;
                if (presses[i]) drive = 0.0;
            } else if (isTouched(face) && drive * face.normal < -speed * face.normal / m_h) {
                presses[i] = true;
                drive = -speed / m_h;
            }
        }
        if (!grips(contact, law.A)) return std::nullopt;
        const SmoothLoss loss = roll(contact, law, ball);
        for (uint32_t i = 0; i < faces.size(); ++i) {
            const UprightFace &face = faces[i];
            double &speed = ball.velocity[face.axis];
            if (!keeps && !isTouched(face) && speed * face.normal < -face.gap / m_h) {
                speed = -face.gap / m_h * face.normal;
                presses[i] = true;
            }
            if (!presses[i]) continue;
            ball.position[face.axis] = face.place;
            if (isTouched(face)) speed = 0.0;
        }
        ball.spin = spinAfter(contact, inPlane(ball.velocity), ball.spin, m_context.radius());
        return loss;
    }

    void bookBounce(double start, std::span<const UprightFace> faces, const Ball &before, const Ball &after) const {
        Reporter &report = m_context.report;
        report.passes(1);
        if (!report.wanted()) return;
        // The spin, which follows the velocity, contributes.
        const double inertia = m_context.isRigid() ? 0.5 : 0.7;
        report.lostImpact(inertia *
                          (glm::dot(before.velocity, before.velocity) - glm::dot(after.velocity, after.velocity)));
        for (const UprightFace &face : faces) {
            const double approach = before.velocity[face.axis] * face.normal;
            if (!(approach < 0.0)) continue;
            Vec3 normal(0.0);
            normal[face.axis] = face.normal;
            Vec3 point = before.position;
            point[face.axis] = face.place - m_context.radius() * face.normal;
            report.event(PHYS_EVENT_IMPACT, start, point, normal, approach,
                         std::max(0.0, after.velocity[face.axis] * face.normal),
                         m_context.scene().givenBox(face.box, point));
        }
    }

    const StepContext &m_context;
    uint32_t m_stages; ///< PHYS_STAGE_* bits
    double m_h;
};

} // namespace phys
