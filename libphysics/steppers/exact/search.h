// SPDX-License-Identifier: MIT
// What a moving ball meets next: the one search of all phases, over all boxes near the path. model.md 8.2.
#pragma once

#include "contact/contact.h"
#include "contact/near.h"
#include "contact/work.h"
#include "phases/phase.h"
#include "phases/uniform.h"
#include "scene/nearest.h"
#include "shared/first_zero.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace phys {

/// Normals of one flat contact differ by at most rounding; features slightly apart, such as those of a narrow crack,
/// are different contacts.
inline double sameNormal(const Scene &scene) { return 4.0 * (kRounding + scene.tolerance / scene.radius); }

/// Where the face on a side of a box is along an axis, m.
inline double planeOf(const phys_box &box, int axis, int sign) {
    return sign > 0 ? (&box.max.x)[axis] : (&box.min.x)[axis];
}

/// Of a face's normal.
inline int axisOf(const Contact &face) { return face.sides[0] != 0 ? 0 : face.sides[1] != 0 ? 1 : 2; }

/// Whether a normal is that of a face.
inline bool isOfFace(const Vec3 &n) { return std::abs(n.x) == 1.0 || std::abs(n.y) == 1.0 || std::abs(n.z) == 1.0; }

/// The start of a phase, and what lasts during it.
struct Outlook {
    const Scene &scene;
    Vec3 position;
    Motion motion;
    const Contacts &contacts; ///< all that are touched
    Work &work;
    uint32_t lasting = 0; ///< bits of those that stay closed

    const phys_box &box(uint32_t number) const { return scene.boxes[number]; }

    /// Whether the ball can't meet a box while the lasting contacts last: the box is one of them, lies behind the face
    /// of one, or is separated from one by a face that the ball touches.
    bool isKept(uint32_t number, const phys_box &box) const;

    /// Whether a box lies behind a face that the ball touches, whether that contact lasts or not.
    bool isBehindTouchedFace(const phys_box &box) const;

    /// Whether a face prevents motion along an axis.
    bool isBarred(int axis) const;

    /// Whether a contact has this normal.
    bool isTouched(const Vec3 &normal) const;

private:
    bool isBehind(const Contact &face, const phys_box &box) const;
};

/// A box relative to the ball at its start; a touched box is put exactly at the radius.
struct Target {
    phys_box box;
    bool isTouched = false;    ///< and not approached
    bool isBehindFace = false; ///< behind the face of another touched box
    double tolerance = 0.0;
    double slight =
        0.0; ///< angle between a velocity and an edge's tangent below which the ball passes within the tolerance
    Vec3 normal{0.0};  ///< at the start, if touched
    double rate = 0.0; ///< n.v at the start, if touched

    Target(const Outlook &around, const phys_box &from);

    /// For a centre that has moved by `way`. From a touched feature the gap is computed from the displacement alone,
    /// without a difference of large numbers.
    double gap(const Vec3 &way, double radius, Vec3 &n) const;

    /// Whether the ball only grazes an edge or corner that it meets or, if it touched it at the start, returns to:
    /// model.md 5.4.
    bool grazes(double gap, double approach, const Vec3 &n, const Vec3 &velocity) const {
        if (approach >= 0.0 || gap > tolerance || gap < -tolerance) return false;
        const Vec3 across(n.x != 0.0 ? velocity.x : 0.0, n.y != 0.0 ? velocity.y : 0.0, n.z != 0.0 ? velocity.z : 0.0);
        return !isOfFace(n) && approach >= -slight * glm::length(across); // along an edge it passes nothing
    }
};

/// The speed along the axis that is nearest to a normal, in its direction.
inline double alongLargest(const Vec3 &n, const Vec3 &velocity) {
    const Vec3 size = glm::abs(n);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return n[axis] > 0.0 ? velocity[axis] : -velocity[axis];
}

template<class Phase>
Look gapAt(const Target &target, const Phase &phase, const Outlook &around, double t, double until) {
    around.work.add(phase.lookWork());
    const double radius = around.scene.radius;
    const Way now = phase.at(t);
    Vec3 n;
    const double gap = target.gap(now.way, radius, n);
    const double rate = glm::dot(n, now.velocity);
    const double gone = std::max(glm::length(now.way), t * glm::length(around.motion.velocity));
    const bool returns = !target.isTouched || gone > 0.25 * radius;
    const bool grazes = returns && target.grazes(gap, rate, n, now.velocity);
    // As fast as it meets the face behind the edge: a graze that fell would take all looks of a search.
    const double falls = grazes ? std::max(rate, std::min(0.0, alongLargest(n, now.velocity))) : rate;
    return {grazes ? target.tolerance : gap, falls, phase.least(n, rate, t, until)};
}

/// The time from which the gap to a touched box that doesn't press is certainly open. Its first terms in time are zero,
/// so that the search can't begin at the start. model.md 8.2.
template<class Phase>
double openingTime(const Target &target, const Phase &phase, const Outlook &around, double until) {
    const double R = around.scene.radius, speed = glm::length(around.motion.velocity);
    if (target.rate > negligibleSpeed(around.motion, R)) return 0.0;
    // A box lies behind the plane of its nearest point: if only rounding leads through this plane, there is no contact.
    const double least = phase.least(target.normal, target.rate, 0.0, until);
    const double deepest = until * (std::min(target.rate, 0.0) + 0.5 * until * std::min(least, 0.0));
    if (deepest < 0.0 && deepest >= -around.scene.tolerance) return until;
    double t = until;
    if (speed > 0.0) t = std::min(t, R / speed);
    const double a = phase.mostAcceleration();
    if (a > 0.0) t = std::min(t, std::sqrt(R / a));
    t *= 0x1p-5;
    if (target.isBehindFace) return t;
    double shorter = t;
    for (int i = 0; i < 24 && target.rate >= 0.0; ++i, shorter *= 0.5) {
        const Look now = gapAt(target, phase, around, shorter, until);
        if (now.rate > 0.0 && now.value >= -around.scene.tolerance) return shorter;
    }
    // The gap opens by rounding only, which may be all of the speed: at most as long as the displacement into the box
    // is negligible.
    if (target.rate < 0.0 && speed > 0.0) t = std::min(t, 8.0 * sameNormal(around.scene) * R / speed);
    for (int i = 0; i < 60 && gapAt(target, phase, around, t, until).value < -around.scene.tolerance; ++i) t *= 0.5;
    return t;
}

/// A face relative to a ball that is beside it, with the same gaps as Target.
struct FaceTarget {
    int axis;
    double face; ///< m: its coordinate
    Vec3 normal{0.0};
    bool isTouched; ///< and not approached

    FaceTarget(const Vec3 &position, const phys_box &box, int across, int side, bool touched)
        : axis(across)
        , face(planeOf(box, across, side) - position[across])
        , isTouched(touched) {
        normal[axis] = side;
    }

    double gap(const Vec3 &way, double radius, Vec3 &n) const {
        n = normal;
        return isTouched ? glm::dot(normal, way) : std::abs(way[axis] - face) - radius;
    }
};

/// The search for a face of a box, in a phase whose velocity along any direction changes its sign at most once
/// (model.md 3.5): the rest of the box lies behind the face's plane.
template<class Goal, class Phase>
class PlaneSearch {
public:
    PlaneSearch(const Goal &target, const Outlook &around, const Phase &phase)
        : m_target(target)
        , m_around(around)
        , m_phase(phase)
        , m_gap(target.gap(Vec3(0.0), around.scene.radius, m_normal))
        , m_rate(glm::dot(m_normal, around.motion.velocity))
        , m_turnsOnce(phase.turnsOnce() || phase.leastAcceleration(-m_normal, -m_rate) > 0.0) {}

    /// When the ball comes to the face from a time on; kNever if it certainly doesn't until then; NAN if it isn't
    /// known.
    double find(double from, double until) const {
        if (!isAhead()) return NAN;
        if (isFar(until)) return kNever;
        const double t = run(until);
        return t != kNever && t >= from ? t : NAN;
    }

    /// The zero near t, if it is at a face: like phys::settled, with the curvature.
    double settled(double t) const {
        Vec3 normal;
        const double start = fewDigits(t), s = start + stepFrom(start, normal);
        return isOfFace(normal) && std::abs(s - t) <= 0x1p-40 * t ? s : t;
    }

private:
    /// Whether the nearest feature of the box is a face that may be met from now on.
    bool isAhead() const {
        const bool isPressed = m_target.isTouched && m_rate <= negligibleSpeed(m_around.motion, m_around.scene.radius);
        return isOfFace(m_normal) && m_gap >= 0.0 && !isPressed;
    }

    /// Whether the ball certainly doesn't come to the plane.
    bool isFar(double until) const {
        return firstFall(m_gap, m_rate, m_phase.leastAcceleration(m_normal, m_rate)) > until;
    }

    /// When it comes there, by Newton's method with the curvature: at the first zero at which the distance falls, as
    /// the phase turns once. Each step begins at a number of few digits, so that the path of the search leaves no trace
    /// in the last ones. kNever if another feature of the box is nearer then, or the method fails.
    double run(double until) const {
        const double first =
            firstFall(m_gap, m_rate, glm::dot(m_normal, m_phase.accelerationAt(0.0, m_around.motion.velocity)));
        double t = first;
        bool wasNear = false;
        for (int i = 0; i < 5 && t > 0.0 && t < until && isSimple(t); ++i) {
            Vec3 normal;
            const double start = fewDigits(t);
            t = start + stepFrom(start, normal);
            if (normal != m_normal) return kNever;
            const bool isNear = std::abs(t - start) <= 0x1p-19 * t; // the method is of third order
            if (isNear && (wasNear || fewDigits(t) == start)) return t < until && isSimple(t) ? t : kNever;
            wasNear = isNear;
        }
        return std::isnan(t) ? grazing(first) : kNever;
    }

    /// Whether the ball turns at most once, or certainly moves towards the face until t.
    bool isSimple(double t) const { return m_turnsOnce || m_rate + t * m_phase.mostAcceleration() < 0.0; }

    /// Where the ball only just reaches the plane, Newton's method may step across and see it leave. Under a constant
    /// acceleration it isn't needed: t is the zero.
    double grazing(double t) const {
        if constexpr (!std::is_same_v<Phase, Uniform>) return kNever;
        Vec3 normal;
        m_target.gap(m_phase.at(t).way, m_around.scene.radius, normal);
        return normal == m_normal ? t : kNever;
    }

    /// From t towards the zero at the nearest feature; NaN if the ball doesn't approach it then.
    double stepFrom(double t, Vec3 &n) const {
        m_around.work.add(m_phase.lookWork());
        const Way now = m_phase.at(t);
        const double gap = m_target.gap(now.way, m_around.scene.radius, n), speed = -glm::dot(n, now.velocity);
        if (!(speed > 0.0)) return NAN;
        const double newton = gap / speed, bend = glm::dot(n, m_phase.accelerationAt(t, now.velocity));
        return newton * (1.0 + 0.5 * newton * bend / speed);
    }

    const Goal &m_target;
    const Outlook &m_around;
    const Phase &m_phase;
    Vec3 m_normal;
    double m_gap, m_rate; ///< at the start: m, m/s
    bool m_turnsOnce;     ///< along the normal
};

/// First time in [from, until] at which the ball touches a target and moves towards it, in any phase.
template<class Phase>
double anyTouchTime(const Target &target, const Outlook &around, const Phase &phase, double from, double until) {
    const auto look = [&](double t, double end) { return gapAt(target, phase, around, t, end); };
    if (target.isTouched && from == 0.0) from = openingTime(target, phase, around, until);
    return firstZero(look, from, until, 0.25 * around.scene.tolerance);
}

/// The same for a box.
template<class Phase>
double touchTime(const Outlook &around, const phys_box &box, const Phase &phase, double from, double until) {
    const Target target(around, box);
    if constexpr (requires { phase.turnsOnce(); }) {
        const PlaneSearch plane(target, around, phase);
        double t = plane.find(from, until);
        if (!std::isnan(t)) return t;
        t = anyTouchTime(target, around, phase, from, until);
        return t == kNever ? t : plane.settled(t);
    }
    return anyTouchTime(target, around, phase, from, until);
}

/// A part of a ball's path.
struct Stretch {
    Vec3 start, end; ///< of the centre
    double off;      ///< m: largest distance of the ball's path from the straight line between them
    double reach;    ///< m: largest distance from the start
    bool isLong;     ///< compared with the ball: most boxes within its length are far from it

    /// Whether a box is certainly far from the path.
    bool passes(const phys_box &box) const;
};

/// Calls visit(box, number) for the boxes that the ball may meet, and possibly for others.
template<class Visit>
void visitAlong(const Scene &scene, const Stretch &stretch, Work &work, Visit visit) {
    const auto look = [&](const phys_box &box, uint32_t number) {
        work.add(Work::kBox);
        if (squaredDistance(box, stretch.start) > stretch.reach * stretch.reach) return;
        if (!stretch.isLong || !stretch.passes(box)) visit(box, number);
    };
    if (!stretch.isLong || !scene.hasManyBoxes) return visitNear(scene, stretch.start, stretch.reach, look);
    scene.visitBoxes(glm::min(stretch.start, stretch.end) - stretch.off,
                     glm::max(stretch.start, stretch.end) + stretch.off, [&](uint32_t i) { look(scene.boxes[i], i); });
}

/// A lower bound of the time that a ball of this speed and acceleration takes for a distance.
inline double leastTime(double way, double speed, double acceleration) {
    if (!(acceleration > 0.0 || speed > 0.0)) return kNever;
    return 2.0 * way / (speed + std::sqrt(speed * speed + 2.0 * acceleration * way));
}

/// Radii: the distance whose surroundings are searched first.
inline constexpr double kFirstWindow = 0.48;

/// Searches parts of a path, one after the other, until search(start, from, end, length) returns a time. Parts grow:
/// most paths end near, and only near boxes need to be tested. length: of the first part, m.
template<class Phase, class Search>
double searchParts(const Work &work, const Phase &phase, double from, double until, double length, Search search) {
    double found = kNever;
    for (; from < until && found == kNever && !work.isTooMuch(); length *= 2.0) {
        const Way start = phase.at(from);
        const double time = leastTime(length, glm::length(start.velocity), phase.mostAcceleration());
        const double end = from + time < until ? from + time : until;
        found = search(start, from, end, length);
        if (end == from) break;
        from = end;
    }
    return found;
}

/// The earliest of the times find(box, number, begin, end) over the boxes along parts of a path; kNever if there is
/// none. length: of the part that is searched first, m.
template<class Phase, class Find>
double firstAlong(const Outlook &around, const Phase &phase, double from, double until, double length, Find find) {
    const Scene &scene = around.scene;
    const double a = phase.mostAcceleration(), ball = scene.radius * (1.0 + 1e-9) + scene.tolerance;
    const auto search = [&](const Way &start, double begin, double end, double longest) {
        const double time = end - begin;
        const double way = std::min(longest, time * (glm::length(start.velocity) + 0.5 * a * time));
        Stretch stretch{around.position + start.way, around.position, ball, ball + way, way > 2.0 * scene.radius};
        if (stretch.isLong) {
            stretch.end += phase.at(end).way;
            stretch.off += 0.125 * a * time * time;
        }
        double best = kNever;
        visitAlong(scene, stretch, around.work, [&](const phys_box &box, uint32_t number) {
            if (!around.work.isTooMuch()) best = std::min(best, find(box, number, begin, end));
        });
        return best;
    };
    return searchParts(around.work, phase, from, until, length, search);
}

/// First time in [from, until] at which the ball touches a box and moves towards it.
template<class Phase>
double firstTouch(const Outlook &around, const Phase &phase, double from, double until, double length) {
    const auto find = [&](const phys_box &box, uint32_t number, double begin, double end) {
        if (around.isKept(number, box)) return kNever;
        around.work.add(Work::kSearch);
        return touchTime(around, box, phase, begin, end);
    };
    return firstAlong(around, phase, from, until, length, find);
}

/// When the feature of a lasting contact ends: the centre crosses a border of its region.
struct Border {
    double after = kNever;
    int axis = 0;
    double coordinate = 0.0;
    double inward = 1.0; ///< the direction along the axis to the inside of the region
    phys_box box{};      ///< whose feature it is
};

/// The box that continues a face beyond a border that the centre has reached at p; false if there is none.
bool carriesOn(const Outlook &around, const Contact &face, const Vec3 &p, const Border &at, phys_box &box);

/// When the centre leaves the region of a feature across one of its borders.
template<class Phase>
double borderTime(const Outlook &around, const Phase &phase, const Border &border, double from, double until) {
    const int axis = border.axis;
    const double start = border.inward * (around.position[axis] - border.coordinate);
    Vec3 n(0.0);
    n[axis] = border.inward;
    const double negligible = negligibleSpeed(around.motion, around.scene.radius);
    const auto depth = [&](double t, double end) {
        around.work.add(phase.lookWork());
        const Way now = phase.at(t);
        const double rate = border.inward * now.velocity[axis], deep = start + border.inward * now.way[axis];
        // A contact of a ball that creeps over the border would be found on the same side again, model.md 13.1.
        const bool creeps = rate >= -negligible && std::abs(deep) <= around.scene.tolerance;
        return Look{creeps ? around.scene.tolerance : deep, rate, phase.least(n, rate, t, end)};
    };
    return firstZero(depth, from, until, 0.25 * around.scene.tolerance);
}

template<class Phase>
Border firstBorder(const Outlook &around, const Contact &contact, const phys_box &box, const Phase &phase, double from,
                   double until) {
    Border first;
    const double way = until * (glm::length(around.motion.velocity) + 0.5 * phase.mostAcceleration() * until);
    for (int axis = 0; axis < 3; ++axis) {
        const int side = contact.sides[axis];
        for (const double sign : {-1.0, 1.0}) {
            // Over the box: its two ends. Beside it: the nearer end, from outside.
            if (side != 0 && side != (sign > 0.0 ? 1 : -1)) continue;
            Border border{kNever, axis, planeOf(box, axis, sign > 0.0 ? 1 : -1), side == 0 ? -sign : sign, box};
            if (border.inward * (around.position[axis] - border.coordinate) > way || around.isBarred(axis)) continue;
            border.after = borderTime(around, phase, border, from, until);
            if (border.after < first.after) first = border;
        }
    }
    return first;
}

/// When the feature of a lasting contact ends. A face that another box continues doesn't.
template<class Phase>
void cutAtBorder(const Outlook &around, const Contact &contact, const Phase &phase, double until, Border &first) {
    phys_box box = around.box(contact.box);
    Border border = firstBorder(around, contact, box, phase, 0.0, until);
    for (int tile = 0; contact.isFace() && border.after < first.after && tile < 1000; ++tile) {
        Vec3 p = around.position + phase.at(border.after).way;
        p[border.axis] = border.coordinate;
        if (!carriesOn(around, contact, p, border, box)) break;
        border = firstBorder(around, contact, box, phase, border.after, until);
    }
    if (border.after < first.after) first = border;
}

/// How far a point is from the rectangle that a box is from above, below 0 inside, and the direction away from it.
double distanceFromAbove(const phys_box &box, const Vec3 &point, Vec3 &away);

/// When the ball gets over a floor in whose upper plane it moves: it touches the floor from then on, but never
/// approaches it. model.md 8.2.
template<class Phase>
void cutAtLevelFloor(const Outlook &around, const Phase &phase, double until, double length, Border &first) {
    const double R = around.scene.radius, tolerance = around.scene.tolerance;
    const auto isLevel = [&](const phys_box &box, const Vec3 &centre) {
        return std::abs(box.max.z + R - centre.z) <= tolerance;
    };
    const auto find = [&](const phys_box &box, uint32_t, double begin, double end) {
        if (!isLevel(box, around.position)) return kNever;
        around.work.add(Work::kSearch);
        const auto look = [&](double t, double bounded) {
            around.work.add(phase.lookWork());
            const Way now = phase.at(t);
            Vec3 away;
            const double distance = distanceFromAbove(box, around.position + now.way, away);
            const double rate = glm::dot(away, now.velocity);
            return Look{distance, rate, phase.least(away, rate, t, bounded)};
        };
        const Look start = look(begin, end);
        const bool isOver = start.value < -tolerance || (start.value <= tolerance && start.rate <= 0.0);
        if (isOver) return kNever; // a falling distance to the nearest side is no arrival there
        const double t = firstZero(look, begin, end, 0.25 * tolerance);
        if (!(t < first.after)) return kNever;
        const Vec3 centre = around.position + phase.at(t).way;
        if (!isLevel(box, centre)) return kNever;
        Vec3 away;
        distanceFromAbove(box, centre, away);
        const int axis = std::abs(away.x) >= std::abs(away.y) ? 0 : 1;
        first = {t, axis, planeOf(box, axis, away[axis] > 0.0 ? 1 : -1), -away[axis], box};
        return t;
    };
    firstAlong(around, phase, 0.0, std::min(until, first.after), length, find);
}

} // namespace phys
