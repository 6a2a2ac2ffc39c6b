// SPDX-License-Identifier: GPL-3.0-or-later
// A ball that was measured: where it was seen when, and how its board was tilted.
#pragma once

#include "core/setup/inputs.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace inspector {

struct TrackPoint {
    double time; // s, ascending
    double x, y; // m, in the tracker's own frame
};

// Which holds from its time on, until the next.
struct TiltChange {
    double time; // s
    Tilt tilt;   // rad
};

struct Track {
    QString name; // of its file
    std::vector<TrackPoint> points;
    std::vector<TiltChange> tilts; // times ascending; empty: not measured
    QStringList remarks;           // rows left out and why, gaps: a line each

    double begin() const { return points.front().time; }
    double end() const { return points.back().time; }
    double period() const; // s, between points, the median
};

// From the tracker's frame to the board's: scaled, turned, then moved.
struct TrackFrame {
    double scale = 1.0;
    double angle = 0.0; // rad
    double x = 0.0;     // m
    double y = 0.0;

    // m, on the board
    void toBoard(double trackX, double trackY, double &boardX, double &boardY) const;
    void toTrack(double boardX, double boardY, double &trackX, double &trackY) const;
};

// The standard deviation of what the tracker adds to each coordinate, m: from third differences, which smooth motion
// doesn't have, without those around bounces. 0 for fewer than 4 points.
double noiseOf(const Track &track);

} // namespace inspector
