// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/program/run_settings.h"
#include "core/setup/inputs.h"
#include "core/setup/levels.h"
#include "core/simulation/departure.h"
#include "core/simulation/sample_ring.h"
#include "core/simulation/snapshot.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace inspector {

/// A run in the history, from a start, a restart or the moment at which it was taken over.
struct KeptRun {
    uint64_t begin = 0; ///< place, as in Past
    uint64_t end = 0;
    Level level;
    uint64_t maze = 0;                               ///< hash of its file's bytes
    std::vector<std::pair<QByteArray, double>> pace; ///< id of the stepper and dt, s, in their order
    Inputs first = initialInputs();                  ///< of its first step
    Inputs last = initialInputs();                   ///< of its last step so far
    double time = 0.0;                               ///< s, until the ball left the maze; else at its end
    BoardSide side = BoardSide::Within;              ///< where it left
};

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

    /// A run that is compared with others: its steps, with fewer samples. Until it isn't kept any more.
    struct Beside {
        KeptRun run;
        std::shared_ptr<const std::vector<Sample>> samples;
    };
    const std::optional<Beside> &beside() const { return m_beside; }
    void layBeside(const std::optional<Beside> &run) { m_beside = run; }

    /// The run that will begin there continues another one, whose steps were made by these.
    void continueFrom(uint64_t begin, std::vector<SettingsSpan> before);
    /// What made the steps of the run that begins there, after those of the run that it continues.
    std::vector<SettingsSpan> withBefore(uint64_t begin, const std::vector<SettingsSpan> &spans) const;

private:
    std::vector<KeptRun> m_runs;
    std::shared_ptr<const std::vector<Sample>> m_oldFuture = std::make_shared<std::vector<Sample>>();
    std::optional<Beside> m_beside;
    uint64_t m_oldFutureRun = 0; ///< run number in snapshots: discarded with the next run
    uint64_t m_continuation = 0; ///< begin of the last run that continues another one
    std::vector<SettingsSpan> m_before;
};

} // namespace inspector
