// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pilot/autopilot.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

constexpr double kGravity = 9.81; ///< m/s^2; under another gravity the pilot drives more boldly or more carefully
constexpr double kRolling =
    5.0 / 7.0; ///< share of gravity along the slope that accelerates a rolling ball, model.md 2.1
constexpr double kBrakingShare = 0.35;     ///< share of the acceleration at full tilt that the speed plan counts on
constexpr double kSlowest = 0.05;          ///< m/s: fast enough to get going against rolling friction
constexpr double kFastest = 0.45;          ///< m/s
constexpr double kReaction = 0.12;         ///< s, time constant with which the velocity approaches the target
constexpr double kComfortableMargin = 0.4; ///< radii between a straight way and the walls

} // namespace

std::shared_ptr<const Autopilot> Autopilot::create(const phys_scene *scene, QString *error) {
    std::shared_ptr<const Autopilot> pilot(new Autopilot(scene));
    if (!pilot->m_space.isMarked()) {
        if (error) *error = QStringLiteral("autopilot: the boxes overlap too often for a way to be looked for");
        return nullptr;
    }
    phys_state start;
    phys_scene_start(scene, &start);
    if (pilot->m_wayOut.exists(pilot->m_space.nearestFree({start.position.x, start.position.y}))) return pilot;
    if (error && !pilot->m_space.isFine())
        *error =
            QStringLiteral("autopilot: the maze is too large for ways as narrow as its ball; found none that is wider "
                           "than %1 m")
                .arg(pilot->m_space.spacing(), 0, 'g', 2);
    else if (error)
        *error = QStringLiteral("autopilot: no way leads out of the maze from its start (%1, %2) m")
                     .arg(start.position.x)
                     .arg(start.position.y);
    return nullptr;
}

Autopilot::Autopilot(const phys_scene *scene)
    : m_space(scene)
    , m_wayOut(m_space) {}

/// The farthest cell of the path that can be reached in a straight line. Next to a wall or in a corner, none may be
/// reachable with a comfortable margin; the ball's own clearance is used then.
Autopilot::Aim Autopilot::aim(Point from) const {
    FreeSpace::Cell cell = m_space.nearestFree(from);
    if (cell == FreeSpace::kNowhere) return {from, true};
    const double margin = std::min(kComfortableMargin * m_space.radius(), 0.5 * m_space.clearance(cell));
    const Point start = m_space.isFree(m_space.cellAt(from)) ? from : m_space.centre(cell);
    FreeSpace::Cell best = cell;
    while ((cell = m_wayOut.next(cell)) != FreeSpace::kNowhere) {
        if (!m_space.isClear(start, m_space.centre(cell), margin)) break;
        best = cell;
    }
    return {m_space.centre(best), m_space.isOutside(best)};
}

Tilt Autopilot::tilt(const phys_state &state, double) const {
    const Point here{state.position.x, state.position.y};
    const Aim target = aim(here);
    const double dx = target.point.x - here.x;
    const double dy = target.point.y - here.y;
    const double distance = phys::elementary::hypot(dx, dy);

    // The speed from which the ball can still stop at the target; outside of the maze it needn't stop.
    const double limit = radians(kPlayTilt);
    const double braking =
        kBrakingShare * kRolling * kGravity * (phys::elementary::sin(limit) / phys::elementary::cos(limit));
    const double stoppable = target.isOutside ? kFastest : std::sqrt(2.0 * braking * distance);
    const double speed = std::clamp(stoppable, kSlowest, kFastest);
    const double share = distance > 0.0 ? speed / distance : 0.0;

    const auto slope = [&](double wanted, double is) {
        const double acceleration = (wanted - is) / kReaction;
        return std::clamp(phys::elementary::atan2(acceleration, kRolling * kGravity), -limit, limit);
    };
    return {slope(dx * share, state.velocity.x), slope(dy * share, state.velocity.y)};
}

} // namespace inspector
