// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/program/run_settings.h"
#include "core/session/kept_run.h"
#include "core/session/run_beside.h"
#include "core/simulation/sample_ring.h"
#include "core/simulation/snapshot.h"

#include <memory>
#include <vector>

namespace inspector {

/// What is known about the runs in the history, beyond their steps.
class RunHistory {
public:
    /// Oldest first; the last is the live one if that has a step.
    const std::vector<KeptRun> &runs() const { return m_runs; }
    bool isOldestCut(const HistoryPlace &kept) const; ///< not all of its steps are kept any more
    /// Drops what isn't kept any more.
    void follow(const Snapshot &now);
    /// live: the live run as it is now; `pace` and inputs only those of its last step.
    void update(const KeptRun &live);

    /// What followed the moment that was last taken over, with fewer samples; until the next run. Never null.
    const std::shared_ptr<const std::vector<Sample>> &oldFuture() const { return m_oldFuture; }
    /// place: the one that is taken over.
    void keepFuture(uint64_t place, const Snapshot &now, const SampleRing &samples);

    /// A run that is compared with others, as long as it is kept.
    RunBeside &beside() { return m_beside; }
    const RunBeside &beside() const { return m_beside; }

    /// The run that will begin there continues another one, whose steps were made by these.
    void continueFrom(uint64_t begin, std::vector<SettingsSpan> before);
    /// What made the steps of the run that begins there, after those of the run that it continues.
    std::vector<SettingsSpan> withBefore(uint64_t begin, const std::vector<SettingsSpan> &spans) const;

private:
    std::vector<KeptRun> m_runs;
    std::shared_ptr<const std::vector<Sample>> m_oldFuture = std::make_shared<std::vector<Sample>>();
    RunBeside m_beside;
    uint64_t m_oldFutureRun = 0; ///< run number in snapshots: discarded with the next run
    uint64_t m_continuation = 0; ///< begin of the last run that continues another one
    std::vector<SettingsSpan> m_before;
};

} // namespace inspector
