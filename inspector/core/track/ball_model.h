// SPDX-License-Identifier: GPL-3.0-or-later
// A ball as it would have been measured: stepper "exact" under a track's tilts, on a board of which some numbers are
// looked for.
#pragma once

#include "core/events/bounce.h"
#include "core/setup/handles.h"
#include "core/track/track.h"

namespace inspector {

// What all of a track has in common.
struct BoardParameters {
    phys_params params; // model and coefficients
    double gravity;     // m/s^2
    Tilt tiltOffset;    // rad, that the board has beyond the tilts of the track
    double delay = 0.0; // s, by which the ball feels a tilt later than the track says
    TrackFrame frame;
};

// At the first point of a segment, on the board: m, m/s. The ball rolls.
struct BallStart {
    double x, y, vx, vy;
};

// On the scene's floor; where noise has it in a wall, beside that.
phys_state rollingState(const phys_scene *scene, const BallStart &start);

struct TrackBounce {
    double time;  // s
    double speed; // along the normal, before, m/s, > 0
    Surface surface;
};

class BallModel {
public:
    // The track outlives the model. Null stepper: see isReady().
    BallModel(const Registry &registry, const Scene &scene, const Track &track, QString *error);
    bool isReady() const { return m_stepper != nullptr; }
    const Track &track() const { return m_track; }
    double radius() const { return phys_scene_radius(m_scene.get()); }

    // Where points first .. last (both included) would be measured, in the tracker's frame; `bounces` (or
    // nullptr) gets what it bounces off. If "exact" refuses, the ball stays where it is from there on, and false.
    bool run(const BoardParameters &board, const BallStart &start, size_t first, size_t last,
             std::vector<TrackPoint> &measured, std::vector<TrackBounce> *bounces = nullptr) const;

private:
    const Track &m_track;
    Scene m_scene;
    Stepper m_stepper;
    std::vector<TiltChange> m_tilts; // at least one
};

} // namespace inspector
