// SPDX-License-Identifier: GPL-3.0-or-later
// Where a segment of a track can begin: a start read off its first points.
#pragma once

#include "core/track/ball_model.h"

#include <vector>

namespace inspector {

// Some points that a computed ball follows from a start of its own.
struct TrackSegment {
    size_t first, last; // points, both included
    BallStart start;
    std::vector<double> increments; // of the difference quotients, as the last fit found them right; empty: usual ones
};

// Position and velocity at a point, from a parabola through it and those that follow.
BallStart startAt(const Track &track, const TrackFrame &frame, size_t first);

// The point within the next `reach` s at which the ball moves most smoothly; at least some points before the end.
size_t smoothestAfter(const Track &track, size_t point, double reach);

} // namespace inspector
