// SPDX-License-Identifier: MIT
#include "hold.h"

#include "sweep.h"

#include <cmath>

namespace phys {

namespace {

/// The axis that a normal lies along, exactly; -1 if it lies along neither x nor y.
int axisOf(const Vec3 &normal) { return std::abs(normal.x) == 1.0 ? 0 : std::abs(normal.y) == 1.0 ? 1 : -1; }

Plane planeOf(const Board &board, const Touch &touch, int axis) {
    const phys_box &box = board.scene().solids[touch.solid];
    const double sign = touch.normal[axis];
    const double low = axis == 0 ? box.min.x : box.min.y;
    const double high = axis == 0 ? box.max.x : box.max.y;
    return {axis, sign, sign > 0.0 ? high : low};
}

/// Whether a ball in the air is about to pass the lower or upper end of what it touches.
bool passesEnd(const Board &board, const Touch &touch, const Vec3 &p, const Vec3 &direction) {
    if (direction.z == 0.0) return false;
    const Heights heights = board.heights(p, touch.normal);
    return direction.z < 0.0 ? p.z - heights.low <= board.tolerance() : heights.high - p.z <= board.tolerance();
}

/// The contact as seen by a ball that moves along `direction`: at the end of a face it is already the edge's.
Hold holdBy(const Board &board, const Touch &touch, const Vec3 &p, const Vec3 &direction) {
    Hold hold;
    hold.touch = touch;
    hold.direction = direction;
    if (touch.normal.z != 0.0 || passesEnd(board, touch, p, direction)) {
        hold.kind = Hold::Kind::beyond;
        if (touch.normal.z == 0.0) hold.touch.feature = PHYS_FEATURE_EDGE; // the end's, which is level
        return hold;
    }
    const int axis = axisOf(touch.normal);
    if (axis < 0) {
        hold.kind = Hold::Kind::edge;
        hold.corner = inPlane(touch.point);
        return hold;
    }
    hold.kind = Hold::Kind::face;
    hold.plane = planeOf(board, touch, axis);
    const int along = 1 - axis;
    if (direction[along] == 0.0) return hold;
    const double limit = p[along] + std::copysign(board.radius(), direction[along]);
    const double end = board.faceEnd(hold.plane, p, direction[along], limit);
    if (std::abs(end - p[along]) > board.tolerance()) return hold;
    hold.kind = Hold::Kind::edge;
    hold.corner[axis] = hold.plane.coordinate;
    hold.corner[along] = end;
    return hold;
}

/// model.md 6.2 and 5.2: on an edge the ball stays while its centrifugal acceleration is below the pressing one; in
/// between the sign of the difference's slope decides.
bool staysOnEdge(const Board &board, const Hold &hold, const Vec3 &v, const Drive &drive) {
    const double R = board.radius();
    const Vec2 level = inPlane(v); // a fall isn't round the edge
    const double speedSquared = glm::dot(level, level);
    const double A = glm::length(drive.A);
    const double lift = speedSquared + R * glm::dot(drive.A, hold.touch.normal);
    const double zero = (16.0 * kRounding + 4.0 * board.tolerance() / R) * (speedSquared + R * A);
    if (std::abs(lift) > zero) return lift < 0.0;
    return 3.0 * glm::dot(inPlane(drive.A), level) < 2.0 * drive.B * std::sqrt(speedSquared);
}

bool stays(const Board &board, const Hold &hold, const Vec3 &v, const Drive &drive) {
    const double along = glm::dot(drive.A, hold.touch.normal);
    if (hold.kind == Hold::Kind::face) return along <= 0.0;
    if (hold.kind == Hold::Kind::beyond) return pressing(board, hold.touch, v, drive) > 0.0;
    return staysOnEdge(board, hold, v, drive);
}

bool parallel(const Board &board, const Vec3 &a, const Vec3 &b) {
    return glm::length(glm::cross(a, b)) <= board.sameNormal();
}

Vec3 unit(const Vec3 &v) {
    const double size = length({length(inPlane(v)), v.z});
    return size > 0.0 ? v / size : Vec3(0.0);
}

} // namespace

Hold holdAt(const Board &board, const Touch &touch, const Vec3 &p) { return holdBy(board, touch, p, Vec3(0.0)); }

double pressing(const Board &board, const Touch &touch, const Vec3 &v, const Drive &drive) {
    const Vec3 round = velocityRound(touch.normal, touch.feature, v);
    return -(glm::dot(drive.A, touch.normal) + glm::dot(round, round) / board.radius());
}

Hold holdMoving(const Board &board, const Touches &touches, const Vec3 &p, Vec3 &v, const Drive &drive) {
    if (touches.count == 0) return {};
    const Vec3 direction = unit(v);
    Hold best;
    double deepest = 0.0;
    for (const Touch &touch : touches) {
        if (approaches(board, -touch.normal, touch.feature, v)) continue; // moves away
        const Hold hold = holdBy(board, touch, p, direction);
        if (!stays(board, hold, v, drive)) continue;
        if (best.kind != Hold::Kind::none && !parallel(board, best.touch.normal, touch.normal)) {
            // Both forbid to move across them: there is no way left but down.
            const bool areUpright = best.touch.normal.z == 0.0 && touch.normal.z == 0.0;
            v = {0.0, 0.0, areUpright ? v.z : 0.0};
            return holdResting(board, touches, p, drive);
        }
        const double along = glm::dot(drive.A, touch.normal);
        if (best.kind != Hold::Kind::none && along >= deepest) continue;
        deepest = along;
        best = hold;
    }
    if (best.kind != Hold::Kind::face) return best;
    // What the face turns the ball's way onto holds it, too.
    const Drive held{drive.A - deepest * best.touch.normal, drive.B};
    for (const Touch &touch : touches) {
        if (touch.normal.z == 0.0 || approaches(board, -touch.normal, touch.feature, v)) continue;
        if (pressing(board, touch, v, held) > 0.0) return holdBy(board, touch, p, direction);
    }
    return best;
}

// The projection of A onto the cone of the directions that no solid forbids: A itself, A without its part into one
// solid, or nothing. model.md 6.3.
Hold holdResting(const Board &board, const Touches &touches, const Vec3 &p, const Drive &drive) {
    const double size = length({length(inPlane(drive.A)), drive.A.z});
    const auto allowed = [&](const Vec3 &a) {
        for (const Touch &touch : touches) {
            const double rounding =
                touch.feature == PHYS_FEATURE_FACE ? 0.0 : 16.0 * kRounding + 2.0 * board.tolerance() / board.radius();
            if (glm::dot(a, touch.normal) < -rounding * size) return false;
        }
        return true;
    };
    Hold hold;
    if (allowed(drive.A)) {
        hold.direction = unit(drive.A);
        hold.start = size;
        // Along a face that it doesn't press on either, the face guides it: no rounding drives it in.
        for (const Touch &touch : touches) {
            const bool isAlong = touch.feature == PHYS_FEATURE_FACE && glm::dot(drive.A, touch.normal) == 0.0;
            if (!isAlong || size == 0.0) continue;
            const double start = hold.start;
            hold = holdBy(board, touch, p, hold.direction);
            hold.start = start;
            break;
        }
        return hold;
    }
    for (const Touch &touch : touches) {
        const double into = glm::dot(drive.A, touch.normal);
        if (into >= 0.0) continue;
        const Vec3 left = drive.A - into * touch.normal;
        if (!allowed(left)) continue;
        hold = holdBy(board, touch, p, unit(left));
        hold.start = length({length(inPlane(left)), left.z});
        return hold;
    }
    // Named for what carries it, if anything does: between upright walls alone it falls.
    for (const Touch &touch : touches) {
        if (hold.touch.normal.z == 0.0 && glm::dot(drive.A, touch.normal) < 0.0) hold.touch = touch;
    }
    hold.kind = Hold::Kind::wedged;
    return hold;
}

} // namespace phys
