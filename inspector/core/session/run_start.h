// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/handles.h"
#include "core/simulation/snapshot.h"

#include <QString>

#include <optional>

namespace inspector {

/// Where restarts put the ball, and whether the live run began there.
class RunStart {
public:
    void set(const std::optional<phys_state> &own) { m_own = own; } ///< empty: the maze's
    bool isOwn() const { return m_own.has_value(); }
    /// What is wrong with the maze's start if that is in use, in a few words; empty if nothing is.
    QString fault(const Scene &scene) const;

    void openLevel(); ///< the run begins at the maze's start
    void begin();     ///< it begins at the start in use
    void leave();     ///< it begins elsewhere
    void takeOver();  ///< it goes on from a moment of a replay or of the past
    void place();     ///< it begins where the ball was put by hand
    bool isFromElsewhere() const { return m_isFromElsewhere; }
    /// Whether the ball was moved away from its start by hand and hasn't moved since: a game would begin there.
    bool isBallPut(const Snapshot &now, const Scene &scene) const;

private:
    std::optional<phys_state> m_own;
    bool m_isFromElsewhere = false;
    bool m_isPlaced = false; ///< by hand, since the last run was taken over
};

} // namespace inspector
