// SPDX-License-Identifier: GPL-3.0-or-later
// Plays any level: it heads for the farthest point of the path to the exit that the ball can reach in a straight line,
// no faster than the ball can brake, and tilts the board no more than a player can.
#pragma once

#include "core/pilot/pilot.h"
#include "core/pilot/way_out.h"

#include <QString>

#include <memory>

namespace inspector {

class Autopilot : public Pilot {
public:
    /// Null, with one line in `error` (may be nullptr), if no path leads out from the scene's start. The scene isn't
    /// used later.
    static std::shared_ptr<const Autopilot> create(const phys_scene *scene, QString *error);

    /// A pure function of the state. Any thread.
    Tilt tilt(const phys_state &state, double dt) const override;

private:
    explicit Autopilot(const phys_scene *scene);
    struct Aim {
        Point point;
        bool isOutside;
    };
    Aim aim(Point from) const;

    FreeSpace m_space;
    WayOut m_wayOut;
};

} // namespace inspector
