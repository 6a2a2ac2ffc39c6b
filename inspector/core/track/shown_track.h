// SPDX-License-Identifier: GPL-3.0-or-later
// A measured ball overlaid on a run, in the board frame and at the run's times.
#pragma once

#include "core/engine/sample.h"
#include "core/pilot/pilot.h"
#include "core/track/ball_model.h"

#include <optional>

namespace inspector {

class ShownTrack {
public:
    /// The points are shifted to the run's times, beginning at `begin`, s. board: gives the frame, and offset and delay
    /// of the tilts. start: where a ball that rolls along starts; empty: estimated from the first points.
    ShownTrack(const Track &track, const BoardParameters &board, double begin,
               const std::optional<BallStart> &start = {});

    struct Place {
        double x, y;   ///< m
        double vx, vy; ///< m/s, over several points to reduce noise
    };
    double begin() const { return m_points.front().time; } ///< s
    double end() const { return m_points.back().time; }
    const std::vector<TrackPoint> &points() const { return m_points; } ///< in the board frame
    /// Linear between points; nothing before the first, after the last and in gaps.
    std::optional<Place> at(double time) const;

    bool hasTilts() const { return !m_tilts.empty(); }
    /// The mean tilt over these times, s; before the track begins it has its first tilt. Only if it has tilts.
    Tilt tiltBetween(double begin, double end) const;
    /// A rolling ball on the floor where the ball was first seen.
    phys_state start(const phys_scene *scene) const;

    /// Sets the channels of the measured ball.
    void addTo(Sample &sample) const;

private:
    std::vector<TrackPoint> m_points;
    std::vector<TiltChange> m_tilts;
    BallStart m_start;
    double m_longest; ///< s, largest distance of joined points
};

/// The time at which a track begins in a run: its own if that is soon after 0, as in tables of runs; otherwise 0.
double usualBegin(const Track &track);

/// A pilot that applies the tilts of the track. A step during which they change has their mean, so that it ends with
/// the velocity that they give, whenever they change.
class TrackPilot : public Pilot {
public:
    explicit TrackPilot(std::shared_ptr<const ShownTrack> track)
        : m_track(std::move(track)) {}
    Tilt tilt(const phys_state &state, double dt) const override {
        return m_track->tiltBetween(state.time, state.time + dt);
    }
    double period() const override { return 0.0; }

private:
    std::shared_ptr<const ShownTrack> m_track;
};

} // namespace inspector
