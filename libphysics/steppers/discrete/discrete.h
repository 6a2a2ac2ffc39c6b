// SPDX-License-Identifier: MIT
// A stepper of fixed substeps. Where nothing is near, a substep is the scheme's formula; contacts follow the law of
// contact (model.md 13.5). A scheme is a struct with its textbook definition and its rule for contacts:
//
//     template<class Law, class V> static Advance<V> advance(const Law &law, const V &velocity, double h);
//     static constexpr ContactRule kContactRule;
#pragma once

#include "base/error.h"
#include "between_walls.h"
#include "contact/near.h"
#include "contact_step.h"
#include "floor_run.h"
#include "overlap.h"
#include "requirements.h"
#include "scene/nearest.h"
#include "shared/law.h"

#include <physics/plugin.h>

#include <cmath>

namespace phys {

template<class Scheme>
class DiscreteStep {
public:
    DiscreteStep(const Setting &setting, Reporter &report, Work &work, const StepPlan &plan, double h)
        : m_plan(plan)
        , m_context{setting, report, work}
        , m_onFloor(m_context, plan, h)
        , m_h(h) {}
    DiscreteStep(const DiscreteStep &) = delete;

    /// Whether a top face carries the ball.
    bool supports(const Ball &ball) const {
        if (m_endedOnFloor) return true;
        const bool isPulledOff = m_context.params().gravity.z > 0.0;
        if (!isPulledOff && !mayLie(ball)) return false;
        if (!isPulledOff && lookAround(ball).carrier) return true;
        // Within rounding beyond its end the face still carries the ball, unless the ball moves on.
        Contacts contacts;
        findContacts(m_context.setting, ball.position, motionOf(ball), Vec3(0.0), contacts);
        const bool isOnTop = std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
            return contact.isTop && std::abs(contact.gap) <= m_context.setting.tolerance;
        });
        return isOnTop && (!isPulledOff || pressesOnTop(contacts, ball));
    }

    /// The spin of a ball at the beginning of a step: in the rolling model it follows the velocity where a top face
    /// carries the ball, model.md 2.1 R7.
    Vec3 spinAtStart(const Ball &ball) const {
        const Vec3 rolling = rollingSpin(inPlane(ball.velocity), m_context.radius());
        return m_context.isRigid() || ball.spin == rolling || !supports(ball) ? ball.spin : rolling;
    }

    /// Whether the ball stays as it is. Once it does, the step is over: it isn't asked again.
    bool rests(Ball &ball) { return m_rests = m_rests || phys::rests(m_context, ball); }

    /// Whether a substep left the ball unchanged up to rounding, so that all following ones will too: it rests, or
    /// turns in place.
    bool stays(const Ball &before, const Ball &after) const {
        const Vec3 pull = m_h * m_context.setting.gravity();
        const double negligible = kStill * kStill * glm::dot(pull, pull);
        const Vec3 turned = m_context.radius() * (after.spin - before.spin);
        return glm::dot(before.velocity, before.velocity) <= negligible &&
               glm::dot(after.velocity, after.velocity) <= negligible && glm::dot(turned, turned) <= negligible;
    }

    /// One substep that ends `after` seconds into the step. False if the ball is stuck.
    bool run(double after, Ball &ball) {
        m_endedOnFloor = !m_plan.asReported && m_onFloor.run(after - m_h, ball);
        if (m_endedOnFloor) return true;
        Around around = lookAround(ball);
        if (!m_plan.asReported && overlaps(around)) { // it began the step inside a box
            if (!leaveOverlaps(m_context, ball)) return false;
            around = lookAround(ball);
        }
        Ball free = ball;
        free.supported = around.carrier != nullptr;
        const SmoothLoss loss = move(free);
        if (m_plan.asReported) {
            m_onFloor.book(loss);
            ball = free;
            collideAsReported(m_context, m_h, after, ball);
            return true;
        }
        if (!comesNear(around, ball, free)) {
            m_onFloor.book(loss);
            ball = free;
            return true;
        }
        runInContact(after - m_h, free, ball);
        return true;
    }

    /// The smooth motion alone, without obstacles.
    SmoothLoss move(Ball &ball) {
        if (!ball.supported) {
            moveBy(flightLaw(m_context.params()), m_h, ball);
            return {};
        }
        ball.velocity.z = 0.0;
        const phys_params &params = m_context.params();
        const FloorContact contact = floorContact(params, m_context.radius(), inPlane(ball.velocity), ball.spin);
        const double spin = m_onFloor.lossOfSpin(ball);
        SmoothLoss loss = m_onFloor.roll(contact, m_onFloor.lawOnFloor(contact), ball);
        loss.slip += spin;
        return loss;
    }

    /// The closed form for a rolling ball with only smooth vertical walls near. False if that doesn't apply.
    bool rollBetweenWalls(const Contacts &contacts, Ball &ball) {
        const phys_params &params = m_context.params();
        const double radius = m_context.radius();
        std::optional<UprightWalls> walls = UprightWalls::find(m_context, contacts, ball);
        if (!walls || params.gravity.z > 0.0) return false;
        const FloorContact contact = floorContact(params, radius, inPlane(ball.velocity), ball.spin);
        if (contact == FloorContact::Slips) return false;
        Law<Vec2> law = m_onFloor.lawOnFloor(contact);
        Ball next = ball;
        const double tolerance = m_context.scene().tolerance;
        std::optional<Vec2> drive;
        const bool keeps = Scheme::kContactRule == ContactRule::SecondOrder && !walls->arrives(tolerance, ball);
        if (Scheme::kContactRule == ContactRule::SecondOrder && walls->turns(ball)) return false;
        drive = keeps ? walls->keepDrive(law.A, tolerance, next) : walls->limitDrive(law.A, m_h, tolerance, next);
        if (!drive) return false;
        if (!m_onFloor.grips(contact, *drive)) return false;
        const Vec2 taken = law.A - *drive;
        law.A = *drive;
        const SmoothLoss loss = m_onFloor.roll(contact, law, next);
        if (!keeps) {
            if (!walls->limitVelocity(taken, m_h, tolerance, ball, next)) return false;
            next.spin = spinAfter(contact, inPlane(next.velocity), next.spin, radius);
        }
        walls->arrive(m_context.scene(), next);
        m_onFloor.book(loss);
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
        const bool lies = mayLie(ball);
        Around around{nullptr, INFINITY};
        visitNear(scene, p, kCandidateReach * scene.radius, [&](const phys_box &box, uint32_t) {
            const bool carries =
                lies && std::abs(p.z - (box.max.z + scene.radius)) <= scene.tolerance && Scene::isOver(box, p.x, p.y);
            if (carries)
                around.carrier = &box;
            else
                around.nearestSquared = std::min(around.nearestSquared, squaredDistance(box, p));
        });
        return around;
    }

    bool overlaps(const Around &around) const {
        const double overlapping = m_context.radius() - m_context.scene().tolerance;
        return around.nearestSquared < overlapping * overlapping;
    }

    /// Whether a top face under the ball would carry it: if it falls, then for too short a time to count.
    bool mayLie(const Ball &ball) const {
        if (m_context.params().gravity.z > 0.0) return false;
        return ball.velocity.z == 0.0 ||
               std::abs(ball.velocity.z) <= negligibleSpeed(motionOf(ball), m_context.radius());
    }

    /// Whether nothing except what carries the ball is within reach of its path.
    bool isFar(const Around &around, const Vec3 &way) const {
        const Scene &scene = m_context.scene();
        const double reach = scene.radius + scene.tolerance + std::abs(way.x) + std::abs(way.y) + std::abs(way.z);
        return reach <= kCandidateReach * scene.radius && reach * reach < around.nearestSquared;
    }

    /// Whether the ball touches anything except what carries it, or would overlap something at the end.
    bool comesNear(const Around &around, const Ball &ball, const Ball &free) const {
        const Scene &scene = m_context.scene();
        const double touching = scene.radius + scene.tolerance;
        if (around.nearestSquared <= touching * touching) return true;
        const Vec3 way = glm::max(glm::abs(free.position - ball.position), glm::abs(m_h * free.velocity));
        if (!m_plan.runs(PHYS_STAGE_SUBSTEPS) && isFar(around, way)) return false;
        const double overlapping = scene.radius - scene.tolerance;
        bool overlaps = false;
        visitNear(scene, free.position, scene.radius, [&](const phys_box &box, uint32_t) {
            overlaps = overlaps || squaredDistance(box, free.position) < overlapping * overlapping;
        });
        return overlaps || leansOnAnother({}, ball, free.velocity, [&](const phys_box &box) {
                   // As FloorRun::mayLean.
                   if (!free.supported || m_context.hasRoughWalls()) return true;
                   return m_context.rubsOnFloor() && isSlope(box, ball);
               });
    }

    /// Whether the explicit rule, which moves with the old velocity, would miss a contact: the ball is as near to a box
    /// that isn't among the contacts as it is to one it leans on, and the new velocity leads into it. matters(box):
    /// whether that box counts.
    template<class Matters>
    bool leansOnAnother(const Contacts &contacts, const Ball &ball, const Vec3 &newVelocity, Matters matters) const {
        if constexpr (Scheme::kContactRule != ContactRule::Explicit) return false;
        const Scene &scene = m_context.scene();
        const double overlapping = scene.radius - scene.tolerance;
        const double leaning = scene.radius + m_h * m_h * glm::length(m_context.setting.gravity());
        const Vec3 there = ball.position + m_h * newVelocity;
        bool leans = false;
        visitNear(scene, there, scene.radius, [&](const phys_box &box, uint32_t number) {
            if (squaredDistance(box, there) >= overlapping * overlapping) return;
            if (squaredDistance(box, ball.position) > leaning * leaning) return;
            leans = leans || (matters(box) && !isAmong(contacts, number));
        });
        return leans;
    }

    static bool isAmong(const Contacts &contacts, uint32_t box) {
        return std::any_of(contacts.begin(), contacts.end(),
                           [&](const Contact &contact) { return contact.box == box; });
    }

    void moveBy(const Law<Vec3> &law, double h, Ball &ball) const {
        const Advance<Vec3> next = Scheme::advance(law, ball.velocity, h);
        ball.velocity = next.velocity;
        ball.position += next.displacement;
    }

    /// The displacements from the start at which the ball may be at the end of a substep.
    class Ways {
    public:
        bool isFull() const { return m_count == m_ways.size(); }
        void add(const Vec3 &way) { m_ways[m_count++] = way; }
        std::span<const Vec3> list() const { return {m_ways.data(), m_count}; }

    private:
        std::array<Vec3, 5> m_ways;
        uint32_t m_count = 0;
    };

    /// Finds all contacts of the substep that begins `start` seconds into the step. free: the ball after it without
    /// contacts.
    void runInContact(double start, const Ball &free, Ball &ball) {
        m_context.work.add(Work::kEvent);
        const Ball before = ball;
        Ways ways;
        ways.add(free.position - ball.position);
        // The explicit rule moves with the old velocity, and along normals of pressing contacts with the new one.
        if (Scheme::kContactRule == ContactRule::Explicit) ways.add(m_h * free.velocity);
        Contacts contacts;
        const phys_report reported = m_context.report.soFar();
        meetAll(start, ways, contacts, ball);
        const Vec3 reached = ball.position;
        if (leaveOverlaps(m_context, ball) && payForLift(m_context, ball.position - reached, ball)) return;
        // The ball doesn't fit at the end of its motion, or is too slow to climb out there; at the start it did.
        m_context.report.goBackTo(reported);
        ball = before;
        ball.velocity = Vec3(0.0);
        ball.spin = Vec3(0.0);
    }

    /// Contacts may lead the ball to a place that it wouldn't have reached without them; boxes that it would overlap
    /// there are contacts as well, and those that it leans on only due to them. Between two edges impacts may follow
    /// each other ever faster. Adds the displacements due to them to `ways`.
    void meetAll(double start, Ways &ways, Contacts &contacts, Ball &ball) {
        const Ball before = ball;
        const phys_report reported = m_context.report.soFar();
        meet(start, ways, contacts, ball);
        while (!ways.isFull()) {
            const uint32_t met = contacts.count();
            if (overlapsAnother(contacts, ball))
                ways.add(ball.position - before.position);
            else if (leansOnAnother(contacts, before, ball.velocity, [](const phys_box &) { return true; }))
                ways.add(m_h * ball.velocity);
            else
                return;
            ball = before;
            m_context.report.goBackTo(reported);
            meet(start, ways, contacts, ball);
            if (contacts.count() == met) return;
        }
    }

    /// The contacts that the ball has, or gets along the ways.
    void meet(double start, const Ways &ways, Contacts &contacts, Ball &ball) {
        lookAhead(m_context, ball, ways.list(), m_h, contacts);
        const Ball before = ball;
        SpinOnFloor spin(m_context, contacts, ball);
        hitInThisScheme(contacts, start, ball);
        spin.follow(contacts, ball);
        spin.settle(goOn(contacts, before, ball), ball);
    }

    void hitInThisScheme(Contacts &contacts, double start, Ball &ball) const {
        if constexpr (Scheme::kContactRule != ContactRule::Explicit) {
            hit(m_context, contacts, start, m_h, ball);
        } else {
            const ExplicitLanding landing(m_context, contacts, m_h, ball);
            hit(m_context, contacts, start, m_h, ball);
            landing.leave(ball);
        }
    }

    /// The motion after the impacts; before: the ball before them. Returns whether a top face pressed.
    bool goOn(const Contacts &contacts, const Ball &before, Ball &ball) {
        if (ball.position == before.position) return move(contacts, m_h, ball);
        const phys_report reported = m_context.report.soFar();
        Ball end = ball;
        const bool presses = move(contacts, m_h, end);
        const double left = timeAfterWay(before, ball, end.position);
        if (left < m_h) {
            m_context.report.goBackTo(reported);
            return move(contacts, left, ball);
        }
        ball = end;
        return presses;
    }

    /// The seconds that are left of a substep after impacts, which have put the ball where it is: all, unless that way
    /// and the motion after it, to `end`, would lead farther than the ball can come, as after a fall onto an edge in
    /// front of a floor. Then the way takes its time.
    double timeAfterWay(const Ball &before, const Ball &ball, const Vec3 &end) const {
        constexpr double kMostOfTime = 63.0 / 64.0;
        const double speed = std::max(glm::length(before.velocity), glm::length(ball.velocity));
        const double fastest = speed + m_h * glm::length(m_context.setting.gravity());
        if (glm::distance(before.position, end) <= m_h * fastest) return m_h;
        return m_h - std::min(glm::distance(before.position, ball.position) / fastest, kMostOfTime * m_h);
    }

    /// `left` seconds with all contacts. Returns whether a top face pressed.
    bool move(const Contacts &contacts, double left, Ball &ball) {
        if (left == m_h && rollBetweenWalls(contacts, ball)) return true;
        return holdContacts(contacts, left, ball);
    }

    /// Whether the ball overlaps a box that isn't among the contacts.
    bool overlapsAnother(const Contacts &contacts, const Ball &ball) const {
        const Scene &scene = m_context.scene();
        const double overlapping = scene.radius - scene.tolerance;
        bool overlaps = false;
        visitNear(scene, ball.position, scene.radius, [&](const phys_box &box, uint32_t number) {
            if (squaredDistance(box, ball.position) >= overlapping * overlapping) return;
            overlaps = overlaps || !isAmong(contacts, number);
        });
        return overlaps;
    }

    /// Whether contacts press the ball onto a top face, at this moment.
    bool pressesOnTop(const Contacts &contacts, Ball ball) const {
        constexpr double kMoment = 1e-6; // of the time of a fall by the radius
        const Setting &setting = m_context.setting;
        const double h = kMoment * std::sqrt(m_context.radius() / glm::length(setting.gravity()));
        Reporter silent;
        return hold({setting, silent, m_context.work}, contacts, Scheme::kContactRule, h, ball);
    }

    /// h seconds with all contacts. Returns whether a top face pressed.
    bool holdContacts(const Contacts &contacts, double h, Ball &ball) {
        if (Scheme::kContactRule != ContactRule::SecondOrder)
            return hold(m_context, contacts, Scheme::kContactRule, h, ball);
        Ball start = ball;
        Contacts kept = contacts;
        keepContacts(kept, start);
        const bool arrives = kept.count() > 1 && std::any_of(kept.begin(), kept.end(), [&](const Contact &contact) {
                                 return contact.gap > m_context.scene().tolerance;
                             });
        if (!arrives) {
            const phys_report reported = m_context.report.soFar();
            std::array<bool, Contacts::kMost> presses;
            Ball next = start;
            bool pressesOnTop = holdOrFly(kept, h, next, presses);
            while (dropOpening(ball, presses, kept)) {
                m_context.report.goBackTo(reported);
                next = ball;
                keepContacts(kept, next);
                pressesOnTop = holdOrFly(kept, h, next, presses);
            }
            if (kept.empty() || !overlapsAnother(contacts, kept, next)) {
                ball = next;
                return pressesOnTop;
            }
            m_context.report.goBackTo(reported);
        }
        // While held at one contact the ball comes to another within the substep: the rule that closes gaps handles
        // both.
        return hold(m_context, contacts, ContactRule::Closing, h, ball);
    }

    bool holdOrFly(const Contacts &contacts, double h, Ball &ball, std::span<bool> presses) const {
        if (!contacts.empty()) return hold(m_context, contacts, ContactRule::SecondOrder, h, ball, presses);
        moveBy(flightLaw(m_context.params()), h, ball);
        return false;
    }

    /// Whether the ball overlaps a box that was near, except for those at which it is held.
    bool overlapsAnother(const Contacts &contacts, const Contacts &held, const Ball &ball) const {
        const Scene &scene = m_context.scene();
        const double overlapping = scene.radius - scene.tolerance;
        return std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
            return !isAmong(held, contact.box) &&
                   squaredDistance(scene.boxes[contact.box], ball.position) < overlapping * overlapping;
        });
    }

    /// Drops the contacts that the ball leaves, except those that it leaves slowly. Their speed is removed, unless
    /// normals are so nearly parallel that far more would be removed: two edges of a hairline crack.
    void keepContacts(Contacts &contacts, Ball &ball) const {
        NormalSpan kept;
        double fastest = 0.0;
        const double negligible = negligibleSpeed(motionOf(ball), m_context.radius());
        contacts.drop([&](const Contact &contact) {
            const double speed = glm::dot(ball.velocity, contact.normal);
            const bool isTouched = contact.gap <= m_context.scene().tolerance;
            // Friction at another contact may press the ball where gravity doesn't.
            if (speed > 0.0 && (!isTouched || speed > std::max(contact.restSpeed, negligible))) return true;
            if (!isTouched) return false;
            kept.add(contact.normal);
            fastest = std::max(fastest, std::abs(speed));
            return false;
        });
        const Vec3 across = kept.across(ball.velocity);
        if (glm::distance(across, ball.velocity) <= kMostTaken * fastest) ball.velocity = across;
    }

    /// Drops the contacts that the ball leaves and that nothing presses even without the speed with which it leaves
    /// them: such a speed is no bounce. Returns whether there were any.
    bool dropOpening(const Ball &ball, std::span<const bool> presses, Contacts &contacts) const {
        const double negligible = negligibleSpeed(motionOf(ball), m_context.radius());
        const uint32_t count = contacts.count();
        const bool *pressing = presses.data();
        contacts.drop([&](const Contact &contact) {
            return !*pressing++ && glm::dot(ball.velocity, contact.normal) > negligible;
        });
        return contacts.count() < count;
    }

    StepPlan m_plan;
    StepContext m_context;
    FloorRun<Scheme> m_onFloor;
    double m_h;
    bool m_endedOnFloor = false; ///< the last substep that ran
    bool m_rests = false;
};

} // namespace phys
