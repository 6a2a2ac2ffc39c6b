// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/player.h"

#include <algorithm>

namespace inspector {

namespace {

bool isBefore(const Keyframe &keyframe, uint64_t position) { return keyframe.position < position; }

} // namespace

Player::Player(std::shared_ptr<const PlayableRecording> recording)
    : m_recording(std::move(recording))
    , m_check(m_recording)
    , m_shown(m_recording)
    , m_keyframes{m_check.keyframe()} {}

Player::Player(std::shared_ptr<const PlayableRecording> recording, std::vector<Keyframe> keyframes)
    : m_recording(std::move(recording))
    , m_check(m_recording)
    , m_shown(m_recording)
    , m_keyframes(std::move(keyframes))
    , m_isKnown(true)
    , m_isChecked(true) {}

bool Player::check() {
    if (m_isChecked) return false;
    m_isChecked = !m_check.step();
    if (!m_isChecked && m_check.position() % kKeyframeInterval == 0) m_keyframes.push_back(m_check.keyframe());
    return !m_isChecked;
}

bool Player::enterRun() { return m_recording->runAt(position() + 1).begin == position() && m_shown.prepare(); }

bool Player::next() {
    if (position() == checked() && !check()) return false;
    return m_shown.step();
}

/// From the previous keyframe, or from the current position if that is nearer. At least one step is made, so that the
/// previous state is known.
uint64_t Player::seek(uint64_t position) {
    position = std::min(position, checked());
    const bool isAfterAStep = position == 0 || m_recording->begin(m_shown.segment()) < position;
    if (position == m_shown.position() && isAfterAStep) return 0;
    const auto after = std::lower_bound(m_keyframes.begin() + 1, m_keyframes.end(), position, isBefore);
    const Keyframe &keyframe = *(after - 1);
    const bool isAhead = m_shown.position() < position && m_shown.position() > keyframe.position;
    if (!isAhead) m_shown.moveTo(keyframe);
    uint64_t steps = 0;
    for (; m_shown.position() < position && m_shown.step(); ++steps) {
    }
    return steps;
}

void Player::seekBegin(uint64_t position) {
    m_shown.moveTo(*std::lower_bound(m_keyframes.begin(), m_keyframes.end(), position, isBefore));
}

} // namespace inspector
