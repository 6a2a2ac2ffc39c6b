// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing where a segment of a track begins, and estimating its start from its first points.
#pragma once

#include "core/track/ball_model.h"

#include <vector>

namespace inspector {

/// Consecutive points that one computed ball follows from its own start.
struct TrackSegment {
    size_t first, last; ///< points, inclusive
    BallStart start;
    std::vector<double> increments; ///< finite-difference increments, as the last fit adjusted them; empty: defaults
};

/// Position and velocity at a point, from a parabola through it and the following ones.
BallStart startAt(const Track &track, const TrackFrame &frame, size_t first);

/// The point within the next `reach` s at which the motion is smoothest; at least a few points before the end.
size_t smoothestAfter(const Track &track, size_t point, double reach);

} // namespace inspector
