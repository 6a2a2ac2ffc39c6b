// SPDX-License-Identifier: GPL-3.0-or-later
// Plays the history of the live ball like a recording, except that samples and events remain those of the whole run
// shown, and that seeks are by places, counted from the oldest one.
#pragma once

#include "core/simulation/replay_run.h"

#include <algorithm>

namespace inspector {

class PastRun : public ReplayRun {
public:
    /// Starts at the end of the past. shownRun: the place where the run begins that samples and events belong to.
    PastRun(Presentation &presentation, const LiveRun &live, const Past &past, uint64_t shownRun, uint64_t number);

    void addTo(Snapshot &snapshot) const override;
    void prepareToGoOn() override {}
    void step(Clock::time_point due) override; ///< stops at the end of the run shown
    void goTo(uint64_t offset) override;
    void forgetFuture() override;

    uint64_t shownRun() const { return m_shownRun; } ///< kNoRun while another is being repeated
    /// Restores samples and events of the live run.
    void showLiveRun();

protected:
    bool showAt(uint64_t offset) override;

private:
    static constexpr uint64_t kNoRun = UINT64_MAX;
    /// A run that is being repeated for plots and trails, beside a ghost like the present one.
    struct Refill {
        uint64_t run; ///< the place where it begins
        uint64_t end;
        bool isLive; ///< the run of the live ball
        std::optional<GhostEngine> ghost{};
        uint64_t ghostSteps = 0;
    };
    uint64_t place() const { return m_past.placeOf(m_player.position(), m_player.segment()); }
    void show(uint64_t place);
    /// The place where the run begins of which there are samples, if it is shown or repeated.
    uint64_t firstKept(uint64_t run) const { return std::max(run, m_past.begin); }
    void beginRefill(uint64_t run);
    bool refill(uint64_t run);
    bool addStep();
    uint64_t follow(GhostEngine &ghost, Sample &sample) const;
    std::optional<Ghost> ghost() const;

    Past m_past;
    uint64_t m_shownRun;
    std::optional<Refill> m_refill{};
    std::optional<phys_state> m_met; ///< of its last ghost
};

} // namespace inspector
