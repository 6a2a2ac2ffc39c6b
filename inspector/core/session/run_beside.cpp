// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run_beside.h"

#include <atomic>

namespace inspector {

namespace {

constexpr uint64_t kIntervals = 4000; ///< that the samples divide the steps into
constexpr std::chrono::milliseconds kUnnoticed{300};

} // namespace

struct RunBeside::Repetition {
    uint64_t length = 0;
    std::atomic<uint64_t> steps = 0;
    std::vector<Sample> samples; ///< the thread's until isDone
    std::atomic<bool> isDone = false;
};

void RunBeside::lay(const KeptRun &run, const Past &past) {
    remove();
    m_run = run;
    m_start = std::chrono::steady_clock::now();
    m_repetition = std::make_shared<Repetition>();
    m_repetition->length = past.recording->length();
    const auto work = [repetition = m_repetition, recording = past.recording,
                       until = run.time](const std::stop_token &stop) { repeat(*repetition, recording, until, stop); };
    m_thread = std::jthread(work);
}

void RunBeside::remove() {
    m_thread = {}; // requests a stop and joins
    m_repetition.reset();
    m_run.reset();
}

/// until: s, when the ball left the maze; its fall would squeeze all other values.
void RunBeside::repeat(Repetition &repetition, const std::shared_ptr<const PlayableRecording> &recording, double until,
                       const std::stop_token &stop) {
    const uint64_t stride = repetition.length / kIntervals + 1;
    replay(recording, [&](const Engine &engine) {
        if (repetition.steps++ % stride == 0) repetition.samples.push_back(engine.sample());
        return engine.state().time < until && !stop.stop_requested();
    });
    repetition.isDone = true;
}

std::shared_ptr<const std::vector<Sample>> RunBeside::samples() const {
    if (!m_repetition || !m_repetition->isDone) return m_none;
    return {m_repetition, &m_repetition->samples};
}

std::optional<double> RunBeside::progress() const {
    if (!m_repetition || m_repetition->isDone || m_repetition->length == 0) return std::nullopt;
    if (std::chrono::steady_clock::now() - m_start < kUnnoticed) return std::nullopt;
    return double(m_repetition->steps) / double(m_repetition->length);
}

} // namespace inspector
