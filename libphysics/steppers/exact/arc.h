// SPDX-License-Identifier: MIT
// The quarter circle that the centre of a ball describes round a vertical edge: where it ends, and what is in the way.
#pragma once

#include "board.h"

namespace phys {

struct EdgeArc {
    Vec2 corner;
    Vec2 normal;  ///< unit, from the edge to the centre at the start
    Vec2 tangent; ///< unit, in the direction of motion
    double radius;
    double height; ///< z of the centre

    Vec2 normalAt(double angle) const;
    Vec2 tangentAt(double angle) const;
    Vec3 centreAt(double angle) const;
};

/// The end of the quarter circle: the face next to the edge.
struct QuarterEnd {
    double angle;
    Vec2 normal, tangent; ///< exact axes
};
QuarterEnd quarterEnd(const EdgeArc &arc);

/// Angle at which the ball first touches another solid while moving towards it; kNever if it doesn't before `end`.
double firstTouchOnArc(const Board &board, const EdgeArc &arc, double end);

/// Angle at which the centre leaves the floor's rectangle; kNever if it doesn't before `end`.
double firstExitOnArc(const phys_box &floor, const EdgeArc &arc, double end, double tolerance);

} // namespace phys
