// SPDX-License-Identifier: GPL-3.0-or-later
// Plays any level: aims at the farthest point of the way out that the ball can reach in a straight line, no faster
// than it can brake, and tilts the board by no more than a person can.
#pragma once

#include "core/pilot/pilot.h"
#include "core/pilot/way_out.h"

#include <QString>

#include <memory>
#include <vector>

namespace inspector {

class Autopilot : public Pilot {
public:
    // Null and one line in `error` (or nullptr) if no way leads out from the scene's start. Needs the scene only now.
    static std::shared_ptr<const Autopilot> create(const phys_scene *scene, QString *error);

    // The same for the same state. Any thread.
    Tilt tilt(const phys_state &state) const override;

    // The way from a point, for drawing; from cell to cell. m
    std::vector<Point> way(Point from) const;

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
