// SPDX-License-Identifier: GPL-3.0-or-later
// A measured ball: its positions over time, and how its board was tilted.
#pragma once

#include "core/setup/inputs.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace inspector {

struct TrackPoint {
    double time; ///< s, ascending
    double x, y; ///< m, in the tracker's own frame
};

/// A tilt that holds from its time until the next change.
struct TiltChange {
    double time; ///< s
    Tilt tilt;   ///< rad
};

struct Track {
    QString name; ///< of its file
    std::vector<TrackPoint> points;
    std::vector<TiltChange> tilts; ///< times ascending; empty: not measured
    QStringList remarks;           ///< rows left out and why, and gaps; a line each

    double begin() const { return points.front().time; }
    double end() const { return points.back().time; }
    double period() const; ///< s, median time between points
};

/// Transforms the tracker's frame into the board's: scale, rotation, translation.
struct TrackFrame {
    double scale = 1.0;
    double angle = 0.0; ///< rad
    double x = 0.0;     ///< m
    double y = 0.0;

    /// m, in the board frame
    void toBoard(double trackX, double trackY, double &boardX, double &boardY) const;
    void toTrack(double boardX, double boardY, double &trackX, double &trackY) const;
};

/// Number of points outside of the board, which the ball leaves only at an exit.
size_t pointsBeside(const Track &track, const TrackFrame &frame, const phys_scene *scene);

/// Standard deviation of the tracker's noise in each coordinate, m: from third differences, which vanish for smooth
/// motion, ignoring those around bounces. 0 for fewer than 4 points.
double noiseOf(const Track &track);

} // namespace inspector
