// SPDX-License-Identifier: GPL-3.0-or-later
// A recording to be watched: forwards, backwards, from any place. Steps can't be made backwards, so the recording is
// run once from its beginning, its hashes are checked and a keyframe is kept now and then; from there any place is
// near.
#pragma once

#include "core/recording/replay.h"

#include <vector>

namespace inspector {

// No thread, no clock, no widgets. One thread at a time, to which the recording's steppers then belong.
class Player {
public:
    // Steps from one keyframe to the next, and so the most that it takes to go anywhere. 160 bytes each.
    static constexpr uint64_t kKeyframeInterval = 512;

    // At the beginning of a recording that has a segment.
    explicit Player(std::shared_ptr<const PlayableRecording> recording);
    // Of one whose keyframes are known, the first at 0: nothing is left to be checked.
    Player(std::shared_ptr<const PlayableRecording> recording, std::vector<Keyframe> keyframes);

    const PlayableRecording &recording() const { return *m_recording; }

    // ---- once through: checks hashes and lays keyframes ----

    // One step further; false if that is done.
    bool check();
    uint64_t checked() const { return m_isKnown ? m_recording->length() : m_check.position(); } // steps
    bool isChecked() const { return m_isChecked; }                                              // all that can be
    const std::optional<Difference> &difference() const { return m_check.difference(); }
    // The last position: the recording's length, or before a step that fails although it didn't.
    uint64_t end() const { return m_isChecked ? checked() : m_recording->length(); }

    // ---- shown ----

    const Engine &engine() const { return m_shown.engine(); }
    uint64_t position() const { return m_shown.position(); }
    size_t segment() const { return m_shown.segment(); } // of the last step
    // True if the next step begins a run; shows the state that it begins with.
    bool enterRun();
    // The next step; false at the end.
    bool next();
    // Shows position 0 .. checked(); the engine has made the step that leads there. Returns how many steps it took, at
    // most kKeyframeInterval.
    uint64_t seek(uint64_t position);

private:
    std::shared_ptr<const PlayableRecording> m_recording;
    Replay m_check;
    Replay m_shown;
    std::vector<Keyframe> m_keyframes; // rising
    bool m_isKnown = false;            // without a check
    bool m_isChecked = false;
};

} // namespace inspector
