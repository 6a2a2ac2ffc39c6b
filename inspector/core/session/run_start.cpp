// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run_start.h"

#include "core/simulation/departure.h"

namespace inspector {

namespace {

std::optional<phys_state> mazeStart(const Scene &scene) {
    phys_state start;
    return phys_scene_start(scene.get(), &start) == PHYS_OK ? std::optional(start) : std::nullopt;
}

bool isSame(const phys_vec3 &a, const phys_vec3 &b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

} // namespace

QString RunStart::fault(const Scene &scene) const {
    const std::optional<phys_state> start = m_own ? std::nullopt : mazeStart(scene);
    return start ? startFault(scene.get(), start->position) : QString();
}

void RunStart::openLevel() {
    m_own.reset();
    begin();
}

void RunStart::begin() { m_isFromElsewhere = false; }

void RunStart::leave() { m_isFromElsewhere = true; }

void RunStart::takeOver() {
    leave();
    m_isPlaced = false;
}

void RunStart::place() {
    leave();
    m_isPlaced = true;
}

bool RunStart::isBallPut(const Snapshot &now, const Scene &scene) const {
    const bool hasMoved = now.running || now.history.end > now.history.run;
    if (!m_isPlaced || hasMoved) return false;
    const std::optional<phys_state> start = m_own ? m_own : mazeStart(scene);
    const phys_state &ball = now.current;
    return start && (!isSame(ball.position, start->position) || !isSame(ball.velocity, start->velocity) ||
                     !isSame(ball.spin, start->spin));
}

} // namespace inspector
