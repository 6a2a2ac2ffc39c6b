// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run_history.h"

namespace inspector {

namespace {

constexpr size_t kOldFutureIntervals = 4000; ///< that its points divide the time into

std::shared_ptr<const std::vector<Sample>> kept(std::vector<Sample> samples) {
    return std::make_shared<const std::vector<Sample>>(std::move(samples));
}

} // namespace

bool RunHistory::isOldestCut(const HistoryPlace &kept) const {
    return !m_runs.empty() && m_runs.front().begin < kept.begin;
}

void RunHistory::follow(const Snapshot &now) {
    const auto isGone = [&](const KeptRun &run) { return run.end <= now.history.begin; };
    if (now.run != m_oldFutureRun && !m_oldFuture->empty()) m_oldFuture = kept({});
    std::erase_if(m_runs, isGone);
    if (m_beside.run() && isGone(*m_beside.run())) m_beside.remove();
}

void RunHistory::update(const KeptRun &live) {
    if (m_runs.empty() || m_runs.back().begin != live.begin) return m_runs.push_back(live);
    KeptRun &run = m_runs.back();
    if (run.end != live.end && run.pace.back() != live.pace.back()) run.pace.push_back(live.pace.back());
    run.end = live.end;
    run.last = live.last;
    run.time = live.time;
    run.side = live.side;
}

void RunHistory::keepFuture(uint64_t place, const Snapshot &now, const SampleRing &samples) {
    m_oldFuture = kept({});
    m_oldFutureRun = now.run;
    if (now.history.place != place) return; // not shown yet: the samples may belong to another run
    m_oldFuture = kept(samples.spread(samples.find(now.current.time), samples.last(), kOldFutureIntervals));
}

void RunHistory::continueFrom(uint64_t begin, std::vector<SettingsSpan> before) {
    m_continuation = begin;
    m_before = std::move(before);
}

std::vector<SettingsSpan> RunHistory::withBefore(uint64_t begin, const std::vector<SettingsSpan> &spans) const {
    return begin == m_continuation ? joined(m_before, spans) : spans;
}

} // namespace inspector
