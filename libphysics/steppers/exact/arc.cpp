// SPDX-License-Identifier: MIT
#include "arc.h"

#include "base/elementary.h"
#include "shared/closed_form.h"
#include "sweep.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// Conservative advancement by the angle, as in model.md 5.2: the centre's second derivative by it is at most R.
/// `look` tells the gap and its derivative at an angle. Returns where the gap closes while it shrinks.
struct Look {
    double gap, rate;
    bool closes; ///< it is zero within the tolerance, and shrinks
};

/// More would be an arc that runs along something within the tolerance.
constexpr int kMostPasses = 1'000;

/// Given up after many passes it returns how far the arc is known to be free: the way goes on from there.
template<class Function>
double advance(Function look, double radius, double tolerance, double end) {
    bool polished = false;
    double angle = 0.0;
    for (int pass = 0; angle <= end; ++pass) {
        if (pass == kMostPasses) return angle;
        const Look now = look(angle);
        double step = firstFall(std::max(0.0, now.gap), now.rate, -radius);
        if (now.closes) {
            if (polished || angle + step == angle) return angle;
            polished = true;
        } else {
            polished = false;
            if (now.gap <= tolerance) step = std::max(step, firstFall(tolerance, std::max(0.0, now.rate), -radius));
        }
        angle = std::max(angle + step, std::nextafter(angle, kNever));
    }
    return kNever;
}

} // namespace

Vec2 EdgeArc::normalAt(double angle) const {
    return elementary::cos(angle) * normal + elementary::sin(angle) * tangent;
}
Vec2 EdgeArc::tangentAt(double angle) const {
    return elementary::cos(angle) * tangent - elementary::sin(angle) * normal;
}
Vec3 EdgeArc::centreAt(double angle) const { return {corner + radius * normalAt(angle), height}; }

QuarterEnd quarterEnd(const EdgeArc &arc) {
    const Vec2 &n = arc.normal, &t = arc.tangent;
    // The component of the normal that shrinks to zero, and the one that is left.
    const int shrinks = n.x != 0.0 && n.x * t.x <= 0.0 ? 0 : 1;
    const int stays = 1 - shrinks;
    Vec2 normal(0.0), tangent(0.0);
    normal[stays] = std::copysign(1.0, n[stays] != 0.0 ? n[stays] : t[stays]);
    tangent[shrinks] = -std::copysign(1.0, n[shrinks]);
    return {elementary::atan2(std::abs(n[shrinks]), std::abs(t[shrinks])), normal, tangent};
}

double firstTouchOnArc(const Board &board, const EdgeArc &arc, double end) {
    const Vec2 reach(arc.radius);
    double first = kNever;
    for (const uint32_t solid : board.near(arc.corner - reach, arc.corner + reach)) {
        const phys_box &box = board.scene().solids[solid];
        // Boxes that share the corner are touched there all the way.
        const Vec3 start = nearest(box, arc.centreAt(0.0)).point;
        if (glm::length(inPlane(start) - arc.corner) <= 2.0 * board.tolerance()) continue;
        const auto look = [&](double angle) -> Look {
            const Nearest close = nearest(box, arc.centreAt(angle));
            const Vec3 direction(arc.tangentAt(angle), 0.0);
            const double gap = close.distance - arc.radius;
            const bool closes = gap <= board.tolerance() && approaches(board, close.normal, close.feature, direction);
            return {gap, arc.radius * glm::dot(close.normal, direction), closes};
        };
        first = std::min(first, advance(look, arc.radius, board.tolerance(), std::min(end, first)));
    }
    return first;
}

double firstExitOnArc(const phys_box &floor, const EdgeArc &arc, double end, double tolerance) {
    double first = kNever;
    for (int axis = 0; axis < 2; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const Vec3 border = side < 0.0 ? toVec(floor.min) : toVec(floor.max);
            const auto look = [&](double angle) -> Look {
                const double gap = side * (border[axis] - arc.centreAt(angle)[axis]);
                const double rate = -side * arc.radius * arc.tangentAt(angle)[axis];
                return {gap, rate, gap <= tolerance && rate < 0.0};
            };
            first = std::min(first, advance(look, arc.radius, tolerance, std::min(end, first)));
        }
    }
    return first;
}

} // namespace phys
