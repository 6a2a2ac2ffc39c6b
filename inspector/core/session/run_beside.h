// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recording/history.h"
#include "core/session/kept_run.h"

#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

namespace inspector {

/// A kept run that is compared with others: its samples, at most some thousand. Its steps are repeated on a thread of
/// their own, as there may be many.
class RunBeside {
public:
    static constexpr uint64_t kMostSteps = 100000; ///< a longer run is repeated up to this one

    /// Replaces the one before. past: the steps of `run`.
    void lay(const KeptRun &run, const Past &past);
    void remove(); ///< also while it is being repeated

    /// None if there is none.
    const std::optional<KeptRun> &run() const { return m_run; }
    /// Ascending times; empty until all steps are repeated. Never null.
    std::shared_ptr<const std::vector<Sample>> samples() const;
    /// The share of the steps that is repeated; none once all are, nor before a user would notice a delay.
    std::optional<double> progress() const;

private:
    struct Repetition;
    static void repeat(Repetition &repetition, const std::shared_ptr<const PlayableRecording> &recording, double until,
                       const std::stop_token &stop);

    std::optional<KeptRun> m_run;
    std::shared_ptr<const std::vector<Sample>> m_none = std::make_shared<std::vector<Sample>>();
    std::shared_ptr<Repetition> m_repetition; ///< shared with the thread
    std::chrono::steady_clock::time_point m_start;
    std::jthread m_thread; ///< last member: it is joined before the others are destroyed
};

} // namespace inspector
