// SPDX-License-Identifier: MIT
// When a phase of swept ends: where the ball reaches another box, or the end of a face or an edge.
#include "swept_step.h"

#include "scene/nearest.h"
#include "shared/first_zero.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// Bisection alone would take 53 steps.
constexpr int kMostRefinements = 80;

} // namespace

/// Whether the bounding box of t seconds of motion contains nothing except the face on which the ball is.
bool SweptStep::isClear(double t) const {
    const Vec3 end = at(t).position;
    const double share = m_isAlone ? shareOfTurn(rollingLaw(m_context.params()), inPlane(m_ball.velocity), t) : 0.5;
    const Vec3 corner = m_ball.position + t * share * m_ball.velocity;
    const double margin = m_context.radius() + 2.0 * m_context.scene().tolerance;
    const Vec3 low = glm::min(corner, glm::min(m_ball.position, end));
    const Vec3 high = glm::max(corner, glm::max(m_ball.position, end));
    bool isClear = true;
    m_context.scene().visitBoxes(low - margin, high + margin, [&](uint32_t i) {
        ++m_boxes;
        const phys_box &box = m_context.scene().boxes[i];
        const bool carries = holds(i) && Scene::isOver(box, low.x, low.y) && Scene::isOver(box, high.x, high.y);
        isClear = isClear && carries;
    });
    return isClear;
}

/// Whether the ball flies, or rolls or slides on one top face, too fast for resistance to stop it.
bool SweptStep::isParabola(Course course, double end) const {
    if (m_contacts.empty()) return true;
    if (course == Course::Held) return false;
    const phys_params &params = m_context.params();
    const Vec2 velocity = inPlane(m_ball.velocity);
    const FloorContact contact = floorContact(params, m_context.radius(), velocity, m_ball.spin);
    if (contact == FloorContact::Slips) return false;
    const Law<Vec2> law = velocityLaw(contact, params);
    if (course == Course::Free) return !nearStop(law, velocity, end);
    return law.B == 0.0 || glm::length(velocity) > 4.0 * (glm::length(law.A) + law.B) * end; // walls may reduce A
}

/// When the ball reaches another box in a phase that is a parabola, or its end; nothing if it may pass an end of a
/// feature with which it is in contact. last: the ball at the end.
std::optional<double> SweptStep::firstTouchOfParabola(double end, const Ball &last) const {
    const Vec3 &start = m_ball.position;
    const Vec3 corner = start + 0.5 * end * m_ball.velocity; // of the triangle around it
    const Vec3 low = glm::min(corner, glm::min(start, last.position));
    const Vec3 high = glm::max(corner, glm::max(start, last.position));
    if (std::max(beyondFeature({low, {}, {}, false}), beyondFeature({high, {}, {}, false})) > 0.0) return std::nullopt;
    const Scene &scene = m_context.scene();
    const double radius = scene.radius;
    const double apart = radius - 0.5 * scene.tolerance;
    const Vec3 acceleration = 4.0 / (end * end) * (0.5 * (last.position - start) - (corner - start));
    double first = end;
    scene.visitBoxes(low - radius, high + radius, [&](uint32_t number) {
        ++m_boxes;
        const phys_box &box = scene.boxes[number];
        const Vec3 beside = glm::max(Vec3(0.0), glm::max(low - toVec(box.max), toVec(box.min) - high));
        if (holds(number) || glm::dot(beside, beside) >= apart * apart) return;
        // A box lies behind the plane of its nearest point; this bounds the gap's second derivative from below.
        const auto look = [&](double t, double) {
            ++m_effort;
            const Nearest close = nearest(box, start + t * m_ball.velocity + 0.5 * t * t * acceleration);
            return Look{close.distance - radius, glm::dot(close.normal, m_ball.velocity + t * acceleration),
                        glm::dot(close.normal, acceleration)};
        };
        // Of two that are reached at once, up to rounding, the search for the second isn't cut off at the first, or
        // their order would show.
        const double until = std::min(end, first * (1.0 + 0x1p-36));
        first = std::min(first, firstZero(look, 0.0, until, 0.25 * scene.tolerance));
    });
    return first;
}

/// Times at which the phase is examined, up to its end: quarters, and where the ball reverses along an axis.
SweptStep::Looks SweptStep::looks(double end, const Ball &last) const {
    Looks looks;
    for (int quarter = 1; quarter <= 3; ++quarter) looks.add(0.25 * quarter * end);
    const Vec3 change = last.velocity - m_ball.velocity;
    for (int axis = 0; axis < 3; ++axis) {
        const double speed = m_ball.velocity[axis];
        if (speed * (speed + change[axis]) < 0.0) looks.add(-speed / change[axis] * end);
    }
    looks.add(end);
    return looks;
}

/// The first event of the phase, or its end.
double SweptStep::firstEvent(double end) const {
    const Ball last = at(end);
    if (isParabola(movedBy(end).course, end)) {
        if (const std::optional<double> touch = firstTouchOfParabola(end, last)) return *touch;
    }
    const Looks looks = this->looks(end, last);
    double before = 0.0;
    double lateBefore = NAN; // computed only when there is an event
    for (uint32_t i = 0; i < looks.count; ++i) {
        const double late = lateness(looks.times[i] == end ? last : at(looks.times[i]));
        if (late > m_context.scene().tolerance) {
            return root(before, i == 0 ? lateness(m_ball) : lateBefore, looks.times[i], late);
        }
        before = looks.times[i];
        lateBefore = late;
    }
    return end;
}

/// Where lateness changes sign: the late end of the bracket, within rounding. Regula falsi that halves an end that
/// doesn't move.
double SweptStep::root(double before, double lateBefore, double after, double lateAfter) const {
    // A ball that leaves a contact may begin on its wrong side by rounding.
    const double base = std::max(0.0, lateness(m_ball));
    lateBefore = std::min(lateBefore - base, 0.0);
    lateAfter -= base;
    const Vec3 &p = m_ball.position;
    const double rounding = kRounding * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    for (int i = 0; i < kMostRefinements && lateAfter > rounding; ++i) {
        const bool usesSecant = lateBefore < 0.0 && i % 3 != 2;
        const double share = usesSecant ? lateBefore / (lateBefore - lateAfter) : 0.5;
        const double t = before + share * (after - before);
        if (!(t > before && t < after)) break;
        const double late = lateness(at(t)) - base;
        if (late > 0.0) {
            after = t;
            lateAfter = late;
            lateBefore *= 0.5;
        } else {
            before = t;
            lateBefore = late;
        }
    }
    return after;
}

/// How far (m) the ball is beyond the phase's first event: above 0, by more than rounding, after an event.
double SweptStep::lateness(const Ball &ball) const { return std::max(overlap(ball), beyondFeature(ball)); }

/// The overlap with a box with which it isn't in contact.
double SweptStep::overlap(const Ball &ball) const {
    const Scene &scene = m_context.scene();
    double nearest = INFINITY;
    visitNear(scene, ball.position, scene.radius, [&](const phys_box &box, uint32_t number) {
        ++m_boxes;
        if (!holds(number)) nearest = std::min(nearest, squaredDistance(box, ball.position));
    });
    return scene.radius - std::sqrt(nearest);
}

/// The distance beyond the end of a face or an edge with which it is in contact.
double SweptStep::beyondFeature(const Ball &ball) const {
    double beyond = -INFINITY;
    for (const Contact &contact : m_contacts) {
        const phys_box &box = m_context.scene().boxes[contact.box];
        for (int axis = 0; axis < 3; ++axis) {
            const double below = (&box.min.x)[axis] - ball.position[axis];
            const double above = ball.position[axis] - (&box.max.x)[axis];
            const double outside = contact.sides[axis] < 0   ? -below
                                   : contact.sides[axis] > 0 ? -above
                                                             : std::max(below, above);
            beyond = std::max(beyond, outside);
        }
    }
    return beyond;
}

} // namespace phys
