// SPDX-License-Identifier: GPL-3.0-or-later
// Repeats the steps of a recording and compares the hash of every state.
#pragma once

#include "core/engine/engine.h"
#include "core/recording/playable_recording.h"
#include "core/setup/parameters.h"

#include <functional>
#include <memory>
#include <optional>

namespace inspector {

/// The first step whose result isn't the recorded one.
struct Difference {
    uint64_t number = 0; ///< of the step in the recording, from 1
    uint64_t step = 0;   ///< since the last start or restart, as displayed
    double time = 0.0;   ///< s, at its beginning
    QString expected;    ///< a hash, or the message of a failure
    QString found;
};

/// A snapshot to which a replay can return.
struct Keyframe {
    uint64_t position = 0;
    size_t segment = 0; ///< of the previous step
    phys_state state{};
    EnergySums sums;
};

/// Repeats a recording's steps one by one.
class Replay {
public:
    /// Starts at the recording's beginning.
    explicit Replay(std::shared_ptr<const PlayableRecording> recording);

    /// Applies the conditions of the next step and, if it begins a run, its initial state. False at the end.
    bool prepare();
    /// Makes the next step. False at the end, and where a step fails that succeeded in the recording: then `difference`
    /// is set.
    bool step();
    uint64_t position() const { return m_position; } ///< steps made
    size_t segment() const { return m_segment; }     ///< of the last step
    /// The engine after the last step; exists if the recording has a segment.
    const Engine &engine() const { return *m_engine; }
    const std::optional<Difference> &difference() const { return m_difference; } ///< the first one found

    Keyframe keyframe() const { return {m_position, m_segment, m_engine->state(), m_engine->sums()}; }
    void moveTo(const Keyframe &place); ///< a keyframe of this recording

private:
    void enter(size_t segment);
    void takeConditions(size_t segment);
    void failAsRecorded();
    void compare(const phys_state &before, const QString &expected, const QString &found);

    std::shared_ptr<const PlayableRecording> m_recording;
    std::unique_ptr<Engine> m_engine;
    size_t m_segment = 0;
    uint64_t m_position = 0;
    bool m_isStuck = false; ///< the next step fails here but not in the recording
    std::optional<Difference> m_difference;
};

struct ReplayOutcome {
    uint64_t steps = 0; ///< steps made
    std::optional<Difference> difference;
};

/// Replays from beginning to end; passes each step to `visit`, which ends the replay by returning false.
ReplayOutcome replay(const std::shared_ptr<const PlayableRecording> &recording,
                     const std::function<bool(const Engine &)> &visit);

/// The settings with which the user would get these conditions.
std::vector<Setting> settingsOf(const Conditions &conditions, const Registry &registry);

/// "same: 812 steps", or the first difference and, in the same line, which versions differ.
QString verdict(const PlayableRecording &recording, const ReplayOutcome &outcome);

} // namespace inspector
