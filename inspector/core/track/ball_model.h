// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the positions at which the ball would have been measured: stepper "exact" runs under a track's tilts on a
// board some of whose parameters are being fitted.
#pragma once

#include "core/events/bounce.h"
#include "core/setup/handles.h"
#include "core/track/track.h"

namespace inspector {

/// Parameters common to the whole track.
struct BoardParameters {
    phys_params params; ///< model and coefficients
    double gravity;     ///< m/s^2
    Tilt tiltOffset;    ///< rad, added to the tilts of the track
    double delay = 0.0; ///< s, by which a tilt acts later than the track says
    TrackFrame frame;
};

/// Initial position (m) and velocity (m/s) of a segment, in the board frame. The ball rolls.
struct BallStart {
    double x, y, vx, vy;
};

/// A rolling ball on the floor below this place (the start's or a lower one); a place that noise has put into a wall is
/// moved next to it.
phys_state rollingState(const phys_scene *scene, const BallStart &start);

struct TrackBounce {
    double time;  ///< s
    double speed; ///< along the normal, before, m/s, > 0
    Surface surface;
};

class BallModel {
public:
    /// The track must outlive the model. If there is no stepper, see isReady().
    BallModel(const Registry &registry, const Scene &scene, const Track &track, QString *error);
    bool isReady() const { return m_stepper != nullptr; }
    const Track &track() const { return m_track; }
    double radius() const { return phys_scene_radius(m_scene.get()); }

    /// Computes where points first .. last (inclusive) would be measured, in the tracker's frame; `bounces` (may be
    /// nullptr) gets the ball's bounces. If "exact" refuses, the ball stays where it is from there on, and the result
    /// is false.
    bool run(const BoardParameters &board, const BallStart &start, size_t first, size_t last,
             std::vector<TrackPoint> &measured, std::vector<TrackBounce> *bounces = nullptr) const;

private:
    const Track &m_track;
    Scene m_scene;
    Stepper m_stepper;
    std::vector<TiltChange> m_tilts; ///< at least one
};

} // namespace inspector
