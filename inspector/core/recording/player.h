// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a recording forwards, backwards, and from any position. Steps can't be reversed, so the recording is run once
// from its beginning to check its hashes and to store keyframes, from which any position is reached in few steps.
#pragma once

#include "core/recording/replay.h"

#include <vector>

namespace inspector {

/// No thread, no clock, no widgets. One thread at a time, to which the recording's steppers then belong.
class Player {
public:
    /// Steps between keyframes, and so the most that a seek takes. 160 bytes each.
    static constexpr uint64_t kKeyframeInterval = 512;

    /// Starts at the beginning of a recording, which must have a segment.
    explicit Player(std::shared_ptr<const PlayableRecording> recording);
    /// For a recording whose keyframes are known, the first at 0: nothing is left to check.
    Player(std::shared_ptr<const PlayableRecording> recording, std::vector<Keyframe> keyframes);

    const PlayableRecording &recording() const { return *m_recording; }

    // ---- checking: comparing hashes and storing keyframes ----

    /// Checks one step; false when there is nothing left to check.
    bool check();
    uint64_t checked() const { return m_isKnown ? m_recording->length() : m_check.position(); } ///< steps
    bool isChecked() const { return m_isChecked; } ///< whether everything that can be checked has been
    const std::optional<Difference> &difference() const { return m_check.difference(); }
    /// The last position: the recording's length, or before a step that fails here although it succeeded in the
    /// recording.
    uint64_t end() const { return m_isChecked ? checked() : m_recording->length(); }

    // ---- playback ----

    const Engine &engine() const { return m_shown.engine(); }
    uint64_t position() const { return m_shown.position(); }
    size_t segment() const { return m_shown.segment(); } ///< of the last step
    /// Whether the next step begins a run, whose first state is then shown.
    bool enterRun();
    /// The next step; false at the end.
    bool next();
    /// Shows position 0 .. checked() after having made the step that leads there. Returns the number of steps that this
    /// took, at most kKeyframeInterval.
    uint64_t seek(uint64_t position);
    /// Shows the first state of the run that begins there. Its keyframe must have been given.
    void seekBegin(uint64_t position);

private:
    std::shared_ptr<const PlayableRecording> m_recording;
    Replay m_check;
    Replay m_shown;
    std::vector<Keyframe> m_keyframes; ///< ascending
    bool m_isKnown = false;            ///< keyframes were given: nothing to check
    bool m_isChecked = false;
};

} // namespace inspector
