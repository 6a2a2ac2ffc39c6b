// SPDX-License-Identifier: GPL-3.0-or-later
// A measured ball beside a run: on the board, at the run's times.
#pragma once

#include "core/engine/sample.h"
#include "core/pilot/pilot.h"
#include "core/track/ball_model.h"

#include <optional>

namespace inspector {

class ShownTrack {
public:
    // Its points at the run's times from `begin` on, s. board: its frame, and offset and delay of its tilts.
    ShownTrack(const Track &track, const BoardParameters &board, double begin);

    struct Place {
        double x, y;   // m
        double vx, vy; // m/s, over some points: noise is less there
    };
    double begin() const { return m_points.front().time; } // s
    double end() const { return m_points.back().time; }
    const std::vector<TrackPoint> &points() const { return m_points; } // on the board
    // Between points linearly; nothing before the first, after the last and where some are missing.
    std::optional<Place> at(double time) const;

    bool hasTilts() const { return !m_tilts.empty(); }
    Tilt tiltAt(double time) const; // the first before it begins; it has some
    // On the floor of the scene where the ball was first seen, rolling.
    phys_state start(const phys_scene *scene) const;

    // Fills in the channels of the measured ball.
    void addTo(Sample &sample) const;

private:
    std::vector<TrackPoint> m_points;
    std::vector<TiltChange> m_tilts;
    BallStart m_start;
    double m_longest; // s, between points that are joined
};

// A run by itself: its times are a recording's or another program's, and begin soon after 0. Others begin at 0.
double usualBegin(const Track &track);

// Tilts the board as the track's was.
class TrackPilot : public Pilot {
public:
    explicit TrackPilot(std::shared_ptr<const ShownTrack> track)
        : m_track(std::move(track)) {}
    Tilt tilt(const phys_state &state) const override { return m_track->tiltAt(state.time); }
    double period() const override { return 0.0; }

private:
    std::shared_ptr<const ShownTrack> m_track;
};

} // namespace inspector
