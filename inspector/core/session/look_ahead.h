// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/snapshot.h"
#include "core/simulation/way_ahead.h"
#include "core/trade/unknowns.h"

namespace inspector {

/// The predicted path of the ball from the moment shown if nothing changes; empty unless shown.
class LookAhead {
public:
    explicit LookAhead(const Registry &registry);

    void show(bool isOn);
    /// Also shows, while paused, the paths on other possible boards.
    void showOthers(bool isOn);
    /// What is unknown about the board; initially as for a hand-built board.
    const Unknowns &unknowns() const { return m_unknowns; }
    void setUnknowns(const Unknowns &unknowns);

    /// Asks once per moment; the answer arrives a little later.
    void follow(const Snapshot &now, const Scene &scene);
    /// Computes it synchronously, for a picture; otherwise it lags a little.
    void computeAtOnce(const Snapshot &now, const Scene &scene);
    const WayAhead &way() const { return m_way; }
    uint64_t updates() const { return m_updates; } ///< changes with every update

private:
    void askAnew();
    std::vector<OtherBoard> otherBoards(const Snapshot &now) const;

    Registry m_registry;
    WayFinder m_wayFinder;
    bool m_isShown = false;
    bool m_showsOthers = false;
    Unknowns m_unknowns;
    uint64_t m_askedFor = 0; ///< identifies the moment asked for, with or without others
    WayAhead m_way;
    uint64_t m_updates = 0;
};

} // namespace inspector
