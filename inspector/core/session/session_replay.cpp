// SPDX-License-Identifier: GPL-3.0-or-later
// The session's replay: the simulation plays a recording, and the user's values follow the moment shown.
#include "core/session/session.h"

#include <algorithm>
#include <utility>

namespace inspector {

bool Session::openRecording(const QString &path) {
    QString error;
    return startReplay(path, &error) || report(error);
}

bool Session::startReplay(const QString &path, QString *error) {
    const auto recording = inspector::openRecording(path, registry(), m_levels.listed(), error);
    if (!recording) return false;
    if (recording->length() == 0) {
        if (error) *error = tr("%1: expected steps, found none").arg(path);
        return false;
    }
    returnToPresent();
    if (!m_replay) {
        setAutopilot(false);
        followTrack(false);
    }
    const Level levelBefore = m_replay ? m_replay->levelBefore : level();
    const Stepping before = m_replay ? m_replay->before : steppingWithAll();
    const Playback playback(*m_simulation, recording, m_simulation->startReplay(recording));
    m_replay.emplace(Replaying{playback, levelBefore, before});
    passTrack();
    showPrompt(); // the game played before is over
    emit replayChanged(true);
    follow(m_replay->playback, 0); // so that a comparison begins with the recording
    m_simulation->run();
    return true;
}

void Session::closeRecording() {
    if (m_replay) openLevel(Level(m_replay->levelBefore)); // a copy, because the replay is destroyed
}

/// The live simulation has kept all of its state.
void Session::leaveReplay() {
    const Stepping before = m_replay->before;
    m_replay.reset();
    m_simulation->endReplay();
    show(before);
    emit replayChanged(false);
}

void Session::goOnFromHere() {
    const Snapshot now = m_simulation->latest(); // so that conditions and position belong together
    followReplay(now);
    if (!m_replay || !m_replay->playback.place(now)) return; // nothing shown yet
    const PlayableRecording &recording = m_replay->playback.recording();
    const uint64_t position = now.replay.position;
    const bool hasSteps = now.history.end > now.history.run;
    m_history.continueFrom(now.history.end + (hasSteps ? 1 : 0),
                           spansOf(recording, recording.runAt(position).begin, position));
    m_tilt.takeOver(settingsOf(recording.segment(now.replay.segment).conditions, registry()),
                    m_replay->before.settings);
    noticeOlderMaze(recording, now.replay.segment);
    m_replay.reset();
    m_start.takeOver();
    m_tilt.releaseKeys();
    m_simulation->goOnFrom(position, origin());
    m_game.goOn(m_levels.index(), m_levels.otherMaze());
    emit replayChanged(false);
}

void Session::followReplay(const Snapshot &now) {
    watchRuns(now);
    m_lookAhead.follow(now, scene());
    if (m_replay && now.replay.number == m_replay->playback.number()) follow(m_replay->playback, now.replay.segment);
    if (!m_past || now.replay.number != m_past->playback.number()) return;
    follow(m_past->playback, now.replay.segment);
    if (!now.running && m_past->playback.showsSought(now) && isAtPresent(runPlace())) returnToPresent();
}

void Session::follow(Playback &playback, size_t index) {
    if (!playback.follow(index)) return;
    const PlayableRecording &recording = playback.recording();
    const Conditions &conditions = recording.segment(index).conditions;
    show({conditions.stepper.id, conditions.dt, settingsOf(conditions, registry())});
    if (scene() == recording.scene(index)) return;
    m_levels.show(recording.level(index), recording.scene(index));
    emit levelOpened();
}

Stepping Session::steppingWithAll() const { return {m_stepperId, m_dt, settingsOf(m_parameters)}; }

/// Updates the display; the simulation has the values already. Values outside of a row's range are shown at its end.
void Session::show(const Stepping &stepping) {
    phys_stepper_info info;
    const bool isOther = stepping.stepper != m_stepperId;
    if (isOther && phys_registry_find(registry().get(), stepping.stepper.constData(), &info, nullptr) == PHYS_OK) {
        m_stepperId = stepping.stepper;
        m_parameters.setStepper(info);
        emit stepperChanged();
    }
    const bool wasFollowing = std::exchange(m_isFollowing, true);
    std::vector<Setting> settings = stepping.settings;
    for (Setting &setting : settings) {
        const phys_param_row &row = m_parameters.row(m_parameters.indexOf(setting.id));
        setting.value = std::clamp(setting.value, row.min, row.max);
    }
    m_parameters.set(settings);
    m_isFollowing = wasFollowing;
    if (m_dt == stepping.dt) return;
    m_dt = stepping.dt;
    emit paceChanged();
}

void Session::noteDifference(uint64_t replay, const Difference &difference) {
    if (!m_replay || m_replay->playback.number() != replay) return;
    m_replay->playback.noteDifference(difference);
    emit replayDiffers(m_replay->playback.difference());
}

} // namespace inspector
