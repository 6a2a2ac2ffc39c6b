// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the inputs of a recording through the library again and compares the hash of every state.
#pragma once

#include "core/engine/engine.h"
#include "core/recording/playable_recording.h"
#include "core/setup/parameters.h"

#include <functional>
#include <memory>
#include <optional>

namespace inspector {

// The first step whose result isn't the recorded one.
struct Difference {
    uint64_t number = 0; // of the recording's steps, from 1
    uint64_t step = 0;   // since the start or restart, as phys_state.step
    double time = 0.0;   // s, at its beginning
    QString expected;    // a hash, or a failure's line
    QString found;
};

// A place in a recording to which a replay can go back.
struct Keyframe {
    uint64_t position = 0;
    size_t segment = 0; // of the step before
    phys_state state{};
    EnergySums sums;
};

// Makes a recording's steps again, one by one, and compares the hash of every state.
class Replay {
public:
    // At the recording's beginning.
    explicit Replay(std::shared_ptr<const PlayableRecording> recording);

    // Takes the conditions of the next step, and its state if it doesn't go on from the one before. False at the end.
    bool prepare();
    // Makes the next step. False at the end, which is also where a step fails that didn't: `difference` tells it.
    bool step();
    uint64_t position() const { return m_position; } // steps made
    size_t segment() const { return m_segment; }     // of the last step
    // As after the last step; there is one if the recording has a segment.
    const Engine &engine() const { return *m_engine; }
    const std::optional<Difference> &difference() const { return m_difference; } // the first that was met

    Keyframe keyframe() const { return {m_position, m_segment, m_engine->state(), m_engine->sums()}; }
    void moveTo(const Keyframe &place); // of this recording

private:
    void enter(size_t segment);
    void takeConditions(size_t segment);
    void failAsRecorded();
    void compare(const phys_state &before, const QString &expected, const QString &found);

    std::shared_ptr<const PlayableRecording> m_recording;
    std::unique_ptr<Engine> m_engine;
    size_t m_segment = 0;
    uint64_t m_position = 0;
    bool m_isStuck = false; // the next step fails although it didn't
    std::optional<Difference> m_difference;
};

struct ReplayOutcome {
    uint64_t steps = 0; // that ran
    std::optional<Difference> difference;
};

// From beginning to end; shows each step to `visit`, which ends the replay by returning false.
ReplayOutcome replay(const std::shared_ptr<const PlayableRecording> &recording,
                     const std::function<bool(const Engine &)> &visit);

// What a person would set to have these conditions.
std::vector<Setting> settingsOf(const Conditions &conditions, const Registry &registry);

// "same: 812 steps", or what differs first and, in the same line, which versions differ.
QString verdict(const PlayableRecording &recording, const ReplayOutcome &outcome);

} // namespace inspector
