// SPDX-License-Identifier: MIT
// A stepper of fixed substeps. Where nothing is near a substep is the scheme's formula; contacts follow the law of
// contact (model.md 13.5). A scheme is a struct with its definition in the textbook, and how it goes on in contact:
//
//     template<class Law, class V> static Advance<V> advance(const Law &law, const V &velocity, double h);
//     static constexpr ContactRule kContactRule;
#pragma once

#include "base/error.h"
#include "base/orientation.h"
#include "between_walls.h"
#include "contact/near.h"
#include "contact_step.h"
#include "floor_view.h"
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

/// A share of a speed that is none.
inline constexpr double kZero = 1e-9;

template<class Scheme>
class DiscreteStep {
public:
    DiscreteStep(const Setting &setting, Reporter &report, const StepPlan &plan, double h)
        : m_plan(plan)
        , m_context{setting, report}
        , m_h(h) {}

    /// Whether a top face carries the ball.
    bool supports(const Ball &ball) const { return m_endedOnFloor || lookAround(ball).carrier; }

    /// Whether the ball stays as it is.
    bool rests(Ball &ball) const { return phys::rests(m_context, ball); }

    /// Whether a substep left the ball as it was, but for rounding, and so will all that follow: it rests, or turns on
    /// the spot.
    bool stays(const Ball &before, const Ball &after) const {
        const Vec3 pull = m_h * m_context.setting.gravity();
        const double negligible = kStill * kStill * glm::dot(pull, pull);
        const Vec3 turned = m_context.radius() * (after.spin - before.spin);
        return glm::dot(before.velocity, before.velocity) <= negligible &&
               glm::dot(after.velocity, after.velocity) <= negligible && glm::dot(turned, turned) <= negligible;
    }

    /// A substep of a ball that lies on a floor and meets nothing but upright smooth faces, `start` seconds into the
    /// step: bounces act along one axis, and the drive loses what faces take, model.md 13.5. False, and nothing done,
    /// elsewhere.
    bool runOnFloor(double start, Ball &ball) {
        const phys_params &params = m_context.params();
        if (ball.velocity.z != 0.0 || !(params.gravity.z < 0.0)) return false;
        const Vec2 velocity = inPlane(ball.velocity);
        const FloorContact contact = floorContact(params, m_context.radius(), velocity, ball.spin);
        FreeRoll next;
        rollFreely(contact, lawOnFloor(contact), velocity, ball.spin, next);
        const Vec3 end(inPlane(ball.position) + next.displacement, ball.position.z);
        FloorView view;
        if (!view.look(m_context, ball.position, end, sum(next.displacement))) return false;
        if (!view.isEmpty()) {
            if (!view.findFaces(m_context, ball.position, end)) return false;
            if (!view.faces().empty()) return meetFaces(start, view, ball);
        }
        finish(next, ball);
        return true;
    }

    /// The same without any event: the ball rolls freely, or along faces that it touches and doesn't leave. For a
    /// stepper that has events inside a step: false, and nothing done, if there is or may be one.
    bool glideOnFloor(Ball &ball) {
        const phys_params &params = m_context.params();
        if (ball.velocity.z != 0.0 || !(params.gravity.z < 0.0)) return false;
        const Vec2 velocity = inPlane(ball.velocity);
        const FloorContact contact = floorContact(params, m_context.radius(), velocity, ball.spin);
        if (contact == FloorContact::Slips && params.rolling_friction > 0.0) return false; // works once that has ended
        Law<Vec2> law = lawOnFloor(contact);
        FreeRoll next;
        rollFreely(contact, law, velocity, ball.spin, next);
        FloorView view;
        // The way may lead back: it stays in the triangle of its ends and this corner.
        const Vec2 turn = 0.5 * m_h * velocity;
        const double way = std::max(sum(turn), sum(next.displacement));
        if (!view.look(m_context, ball.position, ball.position + Vec3(next.displacement, 0.0), way)) return false;
        if (!view.isEmpty()) {
            if (!view.findFaces(m_context, ball.position, ball.position)) return false;
            if (!view.faces().empty()) {
                if (contact == FloorContact::Slips || !pressOnFaces(view.faces(), velocity, law)) return false;
                if (!grips(contact, law)) return false;
                rollFreely(contact, law, velocity, ball.spin, next);
                const bool mayStop = law.B > 0.0 && velocity != Vec2(0.0);
                if (mayStop && glm::dot(next.velocity, velocity) <= kZero * glm::dot(velocity, velocity)) return false;
            }
            const Vec2 start = inPlane(ball.position), end = start + next.displacement, corner = start + turn;
            if (!view.isClear(m_context, glm::min(start, glm::min(end, corner)),
                              glm::max(start, glm::max(end, corner))))
                return false;
        }
        finish(next, ball);
        return true;
    }

    /// One substep that ends `after` seconds into the step. False if the ball is stuck.
    bool run(double after, Ball &ball) {
        m_endedOnFloor = !m_plan.asReported && runOnFloor(after - m_h, ball);
        if (m_endedOnFloor) return true;
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

    /// The smooth motion alone, as if there was nothing ahead.
    SmoothLoss move(Ball &ball) {
        if (!ball.supported) {
            moveBy(flightLaw(m_context.params()), ball);
            return {};
        }
        ball.velocity.z = 0.0;
        const phys_params &params = m_context.params();
        const FloorContact contact = floorContact(params, m_context.radius(), inPlane(ball.velocity), ball.spin);
        return roll(contact, lawOnFloor(contact), ball);
    }

    /// The closed form where nothing but smooth upright walls are near a ball that rolls. False if it isn't that.
    bool rollBetweenWalls(const Contacts &contacts, Ball &ball) {
        const phys_params &params = m_context.params();
        const double radius = m_context.radius();
        std::optional<UprightWalls> walls = UprightWalls::find(m_context, contacts, ball);
        if (!walls || params.gravity.z >= 0.0) return false;
        const FloorContact contact = floorContact(params, radius, inPlane(ball.velocity), ball.spin);
        if (contact == FloorContact::Slips) return false;
        Law<Vec2> law = lawOnFloor(contact);
        Ball next = ball;
        const double tolerance = m_context.scene().tolerance;
        std::optional<Vec2> drive;
        const bool keeps = Scheme::kContactRule == ContactRule::SecondOrder && !walls->arrives(tolerance, ball);
        if (Scheme::kContactRule == ContactRule::SecondOrder && walls->turns(ball)) return false;
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
    /// A bounce off the faces that come fast enough. Returns whether there was one.
    bool bounce(std::span<const UprightFace> faces, Ball &ball) const {
        const auto restSpeed = [&](const UprightFace &face) { return restSpeedOf(face); };
        const auto approach = [&](const UprightFace &face) { return -ball.velocity[face.axis] * face.normal; };
        if (std::none_of(faces.begin(), faces.end(),
                         [&](const UprightFace &face) { return approach(face) > restSpeed(face); }))
            return false;
        const double negligible = negligibleSpeed(motionOf(ball), m_context.radius());
        for (const UprightFace &face : faces) {
            const double speed = approach(face);
            if (speed <= negligible) continue;
            const double restitution = speed > restSpeed(face) ? m_context.params().restitution_wall : 0.0;
            ball.velocity[face.axis] += (1.0 + restitution) * speed * face.normal;
        }
        return true;
    }

    double restSpeedOf(const UprightFace &face) const {
        return 2.0 * m_h * std::max(0.0, -(&m_context.params().gravity.x)[face.axis] * face.normal);
    }

    /// Takes from the drive what presses on faces along which the ball moves. False if it doesn't.
    bool pressOnFaces(std::span<const UprightFace> faces, const Vec2 &velocity, Law<Vec2> &law) const {
        if (m_context.isRigid() && m_context.params().wall_friction > 0.0) return false;
        for (const UprightFace &face : faces) {
            if (velocity[face.axis] != 0.0) return false;
            if (law.A[face.axis] * face.normal < 0.0) law.A[face.axis] = 0.0;
        }
        return true;
    }

    /// Whether friction on the floor holds against what the walls leave of the drive.
    bool grips(FloorContact contact, const Law<Vec2> &law) const {
        const phys_params &params = m_context.params();
        const bool needsGrip = m_context.isRigid() && contact == FloorContact::Rolls;
        return !needsGrip || glm::length(law.A) <= 2.5 * params.sliding_friction * -params.gravity.z;
    }

    bool meetFaces(double start, FloorView &view, Ball &ball) {
        const phys_params &params = m_context.params();
        const double radius = m_context.radius();
        if (m_context.isRigid() && params.wall_friction > 0.0) return false;
        const std::span<UprightFace> faces = view.faces();
        Ball next = ball;
        next.supported = true;
        const bool bounces = bounce(faces, next);
        const FloorContact contact = floorContact(params, radius, inPlane(next.velocity), next.spin);
        if (contact == FloorContact::Slips) return false;
        const Ball bounced = next;
        Law<Vec2> law = lawOnFloor(contact);
        const double tolerance = m_context.scene().tolerance;
        // Held at one face it comes to another within the substep: the rule of order 1 meets both.
        const bool arrives = std::any_of(faces.begin(), faces.end(), [&](const UprightFace &face) {
            return face.gap > tolerance && next.velocity[face.axis] * face.normal <= 0.0;
        });
        const bool keeps = Scheme::kContactRule == ContactRule::SecondOrder && !arrives;
        std::array<bool, 2> presses{};
        for (uint32_t i = 0; i < faces.size(); ++i) {
            const UprightFace &face = faces[i];
            double &speed = next.velocity[face.axis];
            double &drive = law.A[face.axis];
            const bool isTouched = face.gap <= tolerance;
            if (keeps) {
                const bool leaves = speed * face.normal > (isTouched ? restSpeedOf(face) : 0.0);
                if (leaves) continue;
                speed = 0.0;
                presses[i] = drive * face.normal < 0.0;
                if (presses[i]) drive = 0.0;
            } else if (isTouched && drive * face.normal < -speed * face.normal / m_h) {
                presses[i] = true;
                drive = -speed / m_h;
            }
        }
        if (!grips(contact, law)) return false;
        const SmoothLoss loss = roll(contact, law, next);
        for (uint32_t i = 0; i < faces.size(); ++i) {
            const UprightFace &face = faces[i];
            double &speed = next.velocity[face.axis];
            if (!keeps && face.gap > tolerance && speed * face.normal < -face.gap / m_h) {
                speed = -face.gap / m_h * face.normal;
                presses[i] = true;
            }
            if (!presses[i]) continue;
            next.position[face.axis] = face.place;
            if (face.gap <= tolerance) speed = 0.0;
        }
        if (!view.hasRoom(m_context, ball.position, next.position)) return false;
        next.spin = spinAfter(contact, inPlane(next.velocity), next.spin, radius);
        book(loss);
        if (bounces) bookBounce(start, faces, ball, bounced);
        ball = next;
        return true;
    }

    void bookBounce(double start, std::span<const UprightFace> faces, const Ball &before, const Ball &after) const {
        Reporter &report = m_context.report;
        report.passes(1);
        if (!report.wanted()) return;
        // The spin that follows the velocity has its share.
        const double inertia = m_context.isRigid() ? 0.5 : 0.7;
        report.lostImpact(inertia *
                          (glm::dot(before.velocity, before.velocity) - glm::dot(after.velocity, after.velocity)));
        for (const UprightFace &face : faces) {
            const double approach = before.velocity[face.axis] * face.normal;
            if (!(approach < 0.0)) continue;
            Vec3 normal(0.0);
            normal[face.axis] = face.normal;
            const Vec3 point = before.position - (m_context.radius() + face.gap) * normal;
            report.event(PHYS_EVENT_IMPACT, start, point, normal, approach,
                         std::max(0.0, after.velocity[face.axis] * face.normal),
                         m_context.scene().givenBox(face.box, point));
        }
    }

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

    /// Never smaller than the length.
    static double sum(const Vec2 &v) { return std::abs(v.x) + std::abs(v.y); }

    /// What the smooth law makes of a motion on the floor.
    struct FreeRoll {
        Vec2 velocity, displacement;
        Vec3 spin;
        SmoothLoss loss;
    };

    // Number by number: a processor waits where it reads two at once that were just written one by one.
    static void set(Vec2 &to, const Vec2 &from) { to.x = from.x, to.y = from.y; }
    static void set(Vec3 &to, const Vec3 &from) { to.x = from.x, to.y = from.y, to.z = from.z; }

    static void place(const FreeRoll &next, Ball &ball) {
        ball.position.x += next.displacement.x;
        ball.position.y += next.displacement.y;
        set(ball.velocity, Vec3(next.velocity, 0.0));
        set(ball.spin, next.spin);
    }

    void finish(const FreeRoll &next, Ball &ball) const {
        book(next.loss);
        place(next, ball);
        ball.supported = true;
    }

    Law<Vec2> lawOnFloor(FloorContact contact) const {
        Law<Vec2> law = velocityLaw(contact, m_context.params());
        law.resists = m_plan.runs(PHYS_STAGE_RESISTANCE);
        return law;
    }

    /// Inlined, as what it takes and gives would go through memory in pieces of other sizes, which costs as much as it
    /// does itself.
    [[gnu::always_inline]] void rollFreely(FloorContact contact, const Law<Vec2> &law, const Vec2 &velocity,
                                           const Vec3 &spin, FreeRoll &next) const {
        if (contact == FloorContact::Slips) return slipFreely(velocity, spin, next);
        advance(law, velocity, next);
        const double drilling = m_context.isRigid() ? spin.z : 0.0;
        set(next.spin, spinAfter(contact, next.velocity, {spin.x, spin.y, drilling}, m_context.radius()));
        next.loss.rolling = m_context.report.wanted() ? 1.4 * law.B * glm::length(next.displacement) : 0.0;
        next.loss.slip = 0.0;
    }

    [[gnu::noinline]] void slipFreely(const Vec2 &velocity, const Vec3 &spin, FreeRoll &next) const {
        const phys_params &params = m_context.params();
        double path = 0.0;
        next.spin = spin;
        const Advance<Vec2> slipped = slip<Scheme>(params, m_context.radius(), m_h, velocity, next.spin,
                                                   m_context.report.wanted() ? &path : nullptr);
        next.velocity = slipped.velocity;
        next.displacement = slipped.displacement;
        next.loss = {0.0, params.sliding_friction * -params.gravity.z * path};
    }

    /// v = 0 stays 0 up to the stiction limit, the limit included: model.md 2.1 R4.
    [[gnu::always_inline]] void advance(const Law<Vec2> &law, const Vec2 &velocity, FreeRoll &next) const {
        if (velocity == Vec2(0.0) && glm::dot(law.A, law.A) <= law.B * law.B) {
            next.velocity = next.displacement = Vec2(0.0);
        } else if (m_plan.runs(PHYS_STAGE_VERTICAL)) {
            const Law<Vec3> inSpace{Vec3(law.A, 0.0), law.B, law.resists};
            const Advance<Vec3> moved = Scheme::advance(inSpace, Vec3(velocity, 0.0), m_h);
            set(next.velocity, inPlane(moved.velocity));
            set(next.displacement, inPlane(moved.displacement));
        } else {
            const Advance<Vec2> moved = Scheme::advance(law, velocity, m_h);
            set(next.velocity, moved.velocity);
            set(next.displacement, moved.displacement);
        }
    }

    [[gnu::noinline]] SmoothLoss roll(FloorContact contact, const Law<Vec2> &law, Ball &ball) const {
        FreeRoll next;
        rollFreely(contact, law, inPlane(ball.velocity), ball.spin, next);
        place(next, ball);
        return next.loss;
    }

    void moveBy(const Law<Vec3> &law, Ball &ball) const {
        const Advance<Vec3> next = Scheme::advance(law, ball.velocity, m_h);
        ball.velocity = next.velocity;
        ball.position += next.displacement;
    }

    /// Where the ball may be at the end of a substep, from its start.
    class Ways {
    public:
        bool isFull() const { return m_count == m_ways.size(); }
        void add(const Vec3 &way) { m_ways[m_count++] = way; }
        std::span<const Vec3> list() const { return {m_ways.data(), m_count}; }

    private:
        std::array<Vec3, 5> m_ways;
        uint32_t m_count = 0;
    };

    /// All contacts of the substep that begins `start` seconds into the step. free: the ball after it without them.
    [[gnu::noinline]] bool runInContact(double start, const Ball &free, Ball &ball) {
        const Ball before = ball;
        Ways ways;
        ways.add(free.position - ball.position);
        // The explicit rule moves with the old velocity, and along normals that press with the new one.
        if (Scheme::kContactRule == ContactRule::Explicit) ways.add(m_h * free.velocity);
        Contacts contacts;
        if (m_context.report.wanted()) {
            Reporter silent(nullptr, 0.0);
            DiscreteStep trial(m_context.setting, silent, m_plan, m_h);
            trial.meetAll(start, ways, contacts, ball);
            ball = before;
            meet(start, ways, contacts, ball);
        } else {
            meetAll(start, ways, contacts, ball);
        }
        const Vec3 reached = ball.position;
        if (leaveOverlaps(m_context, ball)) {
            payForLift(m_context, contacts, ball.position - reached, ball);
            return true;
        }
        // It doesn't fit where it was going. Where it came from it did, unless it started inside something.
        ball = before;
        ball.velocity = Vec3(0.0);
        ball.spin = Vec3(0.0);
        return leaveOverlaps(m_context, ball);
    }

    /// Contacts lead the ball to where it wouldn't have come without them: what it would overlap there, it meets, too.
    /// Between two edges impacts may follow each other ever faster. Adds to the ways those that it takes.
    void meetAll(double start, Ways &ways, Contacts &contacts, Ball &ball) {
        const Ball before = ball;
        meet(start, ways, contacts, ball);
        while (!ways.isFull() && overlapsAnother(contacts, ball)) {
            const uint32_t met = contacts.count();
            ways.add(ball.position - before.position);
            ball = before;
            meet(start, ways, contacts, ball);
            if (contacts.count() == met) return;
        }
    }

    /// The contacts that the ball has, or comes to on the ways.
    void meet(double start, const Ways &ways, Contacts &contacts, Ball &ball) {
        lookAhead(m_context, ball, ways.list(), m_h, contacts);
        SpinOnFloor spin(m_context, contacts, ball);
        hitInThisScheme(contacts, start, ball);
        spin.follow(contacts, ball);
        if (rollBetweenWalls(contacts, ball)) {
            spin.settle(true, ball);
        } else {
            spin.settle(holdContacts(contacts, ball), ball);
        }
    }

    void hitInThisScheme(const Contacts &contacts, double start, Ball &ball) const {
        if constexpr (Scheme::kContactRule == ContactRule::Explicit) {
            const ExplicitLanding landing(m_context, contacts, m_h, ball);
            hit(m_context, contacts, start, ball);
            landing.leave(ball);
        } else {
            hit(m_context, contacts, start, ball);
        }
    }

    /// Whether the ball overlaps a box of which no contact is known.
    bool overlapsAnother(const Contacts &contacts, const Ball &ball) const {
        const Scene &scene = m_context.scene();
        const double overlapping = scene.radius - scene.tolerance;
        bool overlaps = false;
        visitNear(scene, ball.position, scene.radius, [&](const phys_box &box, uint32_t number) {
            if (squaredDistance(box, ball.position) >= overlapping * overlapping) return;
            overlaps = overlaps || std::none_of(contacts.begin(), contacts.end(),
                                                [&](const Contact &contact) { return contact.box == number; });
        });
        return overlaps;
    }

    /// A substep of all contacts. Returns whether a top face pressed.
    bool holdContacts(const Contacts &contacts, Ball &ball) {
        if (Scheme::kContactRule != ContactRule::SecondOrder)
            return hold(m_context, contacts, Scheme::kContactRule, m_h, ball);
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
        return hold(m_context, contacts, ContactRule::Symplectic, m_h, ball);
    }

    bool holdOrFly(const StepContext &context, const Contacts &contacts, Ball &ball) const {
        if (!contacts.empty()) return hold(context, contacts, ContactRule::SecondOrder, m_h, ball);
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

    /// The contacts that the ball doesn't leave; it may leave those it touches with a speed that is none. That speed is
    /// taken, unless normals are so nearly parallel that it would be far more: two edges of a hair crack.
    Contacts keepContacts(const Contacts &contacts, Ball &ball) const {
        Contacts result = contacts;
        NormalSpan kept;
        double fastest = 0.0;
        result.drop([&](const Contact &contact) {
            const double speed = glm::dot(ball.velocity, contact.normal);
            const bool isTouched = contact.gap <= m_context.scene().tolerance;
            if (speed > 0.0 && (!isTouched || speed > contact.restSpeed)) return true;
            if (!isTouched) return false;
            kept.add(contact.normal);
            fastest = std::max(fastest, std::abs(speed));
            return false;
        });
        const Vec3 across = kept.across(ball.velocity);
        if (glm::distance(across, ball.velocity) <= kMostTaken * fastest) ball.velocity = across;
        return result;
    }

    void book(const SmoothLoss &loss) const {
        m_context.report.lostRolling(loss.rolling);
        m_context.report.lostSlip(loss.slip);
    }

    StepPlan m_plan;
    StepContext m_context;
    double m_h;
    bool m_endedOnFloor = false; ///< the last substep that ran
};

} // namespace phys
