// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/track_segment.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

constexpr size_t kSmooth = 10; ///< points used to estimate a start

/// Least-squares parabola through some points from `first` on: value and slope at the first, and the residual.
struct Parabola {
    double value, slope, residual;
};

Parabola parabola(const Track &track, double TrackPoint::*coordinate, size_t first, size_t count) {
    // Normal equations of value + slope t + bend t^2, solved by Gaussian elimination without pivoting: they are
    // positive definite.
    double m[3][4]{};
    const double origin = track.points[first].time;
    for (size_t i = first; i < first + count; ++i) {
        const double t = track.points[i].time - origin;
        const double powers[3]{1.0, t, t * t};
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) m[r][c] += powers[r] * powers[c];
            m[r][3] += powers[r] * (track.points[i].*coordinate);
        }
    }
    for (int k = 0; k < 3; ++k)
        for (int r = k + 1; r < 3; ++r) {
            const double factor = m[r][k] / m[k][k];
            for (int c = k; c < 4; ++c) m[r][c] -= factor * m[k][c];
        }
    const double bend = m[2][3] / m[2][2];
    const double slope = (m[1][3] - m[1][2] * bend) / m[1][1];
    const double value = (m[0][3] - m[0][1] * slope - m[0][2] * bend) / m[0][0];
    double squares = 0.0;
    for (size_t i = first; i < first + count; ++i) {
        const double t = track.points[i].time - origin;
        const double rest = track.points[i].*coordinate - (value + (slope + bend * t) * t);
        squares += rest * rest;
    }
    return {value, slope, squares};
}

size_t smoothCount(const Track &track, size_t first) { return std::min(kSmooth, track.points.size() - first); }

double roughness(const Track &track, size_t first) {
    const size_t before = std::min<size_t>(first, 2); // not right after a bounce, either
    const size_t count = smoothCount(track, first) + before;
    return parabola(track, &TrackPoint::x, first - before, count).residual +
           parabola(track, &TrackPoint::y, first - before, count).residual;
}

} // namespace

BallStart startAt(const Track &track, const TrackFrame &frame, size_t first) {
    const size_t count = smoothCount(track, first);
    const Parabola x = parabola(track, &TrackPoint::x, first, count);
    const Parabola y = parabola(track, &TrackPoint::y, first, count);
    BallStart start{};
    frame.toBoard(x.value, y.value, start.x, start.y);
    TrackFrame turned = frame; // a velocity isn't translated
    turned.x = turned.y = 0.0;
    turned.toBoard(x.slope, y.slope, start.vx, start.vy);
    return start;
}

size_t smoothestAfter(const Track &track, size_t point, double reach) {
    size_t best = point;
    double least = roughness(track, point);
    for (size_t i = point + 1; i + kSmooth < track.points.size(); ++i) {
        if (track.points[i].time > track.points[point].time + reach) break;
        const double rough = roughness(track, i);
        if (rough < least) best = i;
        least = std::min(least, rough);
    }
    return best;
}

} // namespace inspector
