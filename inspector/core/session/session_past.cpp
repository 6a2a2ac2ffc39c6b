// SPDX-License-Identifier: GPL-3.0-or-later
// The session's past: the history of what was played, shown and taken over.
#include "core/recording/replay.h"
#include "core/session/session.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <QThread>

#include <algorithm>
#include <utility>

namespace inspector {

RunPlace Session::runPlace() {
    const Snapshot &now = m_simulation->latest();
    const HistoryPlace &kept = now.history;
    const auto placeIn = [&](uint64_t begin, uint64_t end, uint64_t place) {
        return RunPlace{begin, end, place, begin <= kept.begin && m_history.isOldestCut(kept)};
    };
    if (!m_past) return placeIn(std::max(kept.run, kept.begin), kept.end, kept.end);
    const Playback &playback = m_past->playback;
    const uint64_t place = playback.showsSought(now) ? kept.place : m_past->past.begin + playback.sought();
    return placeIn(m_past->past.beginOfRun(place), m_past->past.endOfRun(place), place);
}

/// Whether this is the end of the live run, which may have no step yet.
bool Session::isAtPresent(const RunPlace &run) const {
    const HistoryPlace kept = m_simulation->latest().history;
    return run.place == m_past->past.end() && run.begin == std::max(kept.run, kept.begin);
}

/// Shows the past, paused at the present.
bool Session::lookBack() {
    if (m_past) return true;
    if (m_replay) return false;
    QString error;
    m_simulation->pause(); // so that the history doesn't change
    std::optional<Past> past = m_simulation->past(&error);
    if (!past) return report(error);
    if (past->recording->length() == 0) return false;
    const Playback playback(*m_simulation, past->recording, m_simulation->lookBack(*past), past->end() - past->begin);
    m_past.emplace(LookingBack{*std::move(past), playback, level(), scene(), steppingWithAll()});
    passTrack();
    emit pastChanged(true);
    return true;
}

void Session::lookAt(uint64_t place) {
    if (!lookBack()) return;
    const Past &past = m_past->past;
    m_past->playback.seek(std::clamp(place, past.begin, past.end()) - past.begin);
}

bool Session::showsWhatIsSought() const {
    const Snapshot &now = m_simulation->latest();
    if (m_replay) return m_replay->playback.showsSought(now);
    return !m_past || m_past->playback.showsSought(now);
}

void Session::lookAtTime(double time) {
    if (m_replay) {
        const PlayableRecording &recording = m_replay->playback.recording();
        return m_replay->playback.seek(recording.positionAt(time, m_simulation->latest().replay.position));
    }
    const RunPlace run = runPlace();
    if (run.begin == run.end || !lookBack()) return; // without a step it is shown by the present alone
    lookAt(m_past->past.placeAt(time, runPlace().place));
}

std::optional<double> Session::lookAtNearest(const std::vector<double> &times, Direction direction) {
    const RunPlace run = runPlace();
    if (m_replay || run.begin == run.end) return std::nullopt;
    const std::optional<Past> past = m_past ? m_past->past : m_simulation->past(nullptr);
    if (!past) return std::nullopt;
    std::optional<double> found;
    for (const double time : times) {
        const uint64_t place = past->placeAt(time, run.place);
        if (direction == Direction::Back && place < run.place) found = time;
        if (direction == Direction::On && place > run.place && !found) found = time;
    }
    if (found) lookAtTime(*found);
    return found;
}

void Session::returnToPresent() {
    if (!m_past) return;
    const LookingBack present = *std::move(m_past);
    m_past.reset();
    m_simulation->returnToPresent();
    show(present.stepping);
    if (scene() != present.scene) {
        m_levels.show(present.level, present.scene);
        emit levelOpened();
    }
    emit pastChanged(false);
}

void Session::lookAtLastSteps() {
    const RunPlace run = runPlace();
    if (run.begin != run.end) return;
    lookAt(run.end);
    awaitMoment();
}

void Session::awaitMoment() {
    while (m_past && !showsWhatIsSought()) QThread::msleep(1);
    followReplay(m_simulation->latest());
}

void Session::takeOver() {
    if (!m_past) return;
    const uint64_t place = runPlace().place;
    const uint64_t position = place - m_past->past.begin;
    const bool isOtherLevel = scene() != m_past->scene;
    m_history.keepFuture(place, m_simulation->latest(), m_simulation->samples());
    m_history.continueFrom(m_past->past.end() + 1, settingsSpans(runPlace().begin, place));
    const std::shared_ptr<const PlayableRecording> recording = m_past->past.recording;
    const std::optional<size_t> segment = m_past->playback.segment(); // none if nothing of the past was shown yet
    if (segment)
        m_tilt.takeOver(settingsOf(recording->segment(*segment).conditions, registry()), m_past->stepping.settings);
    if (segment) noticeOlderMaze(*recording, *segment);
    m_past.reset();
    m_start.takeOver();
    m_tilt.releaseKeys();
    m_simulation->goOnFrom(position, origin());
    if (m_hasAutopilot) fly(nullptr);
    if (std::exchange(m_followsTrack, false)) emit trackChanged(); // goOnFrom() ended it
    m_simulation->setInputs(m_parameters.inputs());                // the visible values count
    if (isOtherLevel || m_game.phase() != Game::Phase::Prompt) m_game.goOn(m_levels.index(), m_levels.otherMaze());
    m_comparison->meetAgain();
    emit pastChanged(false);
    emit takenOver();
}

std::vector<SettingsSpan> Session::settingsSpans() {
    if (!m_replay) return settingsSpans(runPlace().begin, runPlace().end);
    const uint64_t position = m_simulation->latest().replay.position;
    const PlayableRecording &recording = m_replay->playback.recording();
    return spansOf(recording, recording.runAt(position).begin, position);
}

/// Of the steps [begin, end) of the run that begins there, and of those that it continues.
std::vector<SettingsSpan> Session::settingsSpans(uint64_t begin, uint64_t end) {
    const std::optional<Past> past = m_simulation->past(nullptr, begin, end);
    std::vector<SettingsSpan> spans;
    if (past) spans = spansOf(*past->recording, 0, past->recording->length());
    return m_history.withBefore(begin, spans);
}

void Session::watchRuns(const Snapshot &now) {
    m_history.follow(now);
    const HistoryPlace &kept = now.history;
    if (m_replay || m_past || now.replay.number != 0 || kept.end == kept.run) return;
    const std::optional<Departure> left = departure(now);
    const double time = left ? left->time : now.current.time;
    const BoardSide side = left ? left->side : BoardSide::Within;
    m_history.update({kept.run,
                      kept.end,
                      level(),
                      m_levels.maze().hash,
                      {{m_stepperId, now.dt}},
                      now.inputs,
                      now.inputs,
                      time,
                      side});
}

void Session::layBeside(std::optional<uint64_t> begin) {
    m_history.beside().remove();
    const auto run = std::ranges::find(m_history.runs(), begin, &KeptRun::begin);
    if (run == m_history.runs().end()) return;
    QString error;
    const uint64_t end = std::min(run->end, run->begin + RunBeside::kMostSteps);
    const std::optional<Past> past = m_simulation->past(&error, run->begin, end);
    if (!past) return void(report(error));
    m_history.beside().lay(*run, *past);
}

std::shared_ptr<const std::vector<Sample>> Session::samplesBeside() const {
    const std::optional<KeptRun> &run = m_history.beside().run();
    return run && run->level.path == level().path ? m_history.beside().samples() : m_history.oldFuture();
}

std::optional<MazeSource> Session::changedMaze() {
    const RunPlace run = runPlace();
    const std::optional<Past> first = m_simulation->past(nullptr, run.begin, run.begin + 1);
    if (!first || first->recording->length() == 0) return std::nullopt;
    const MazeSource &maze = first->recording->segment(0).conditions.maze;
    const std::optional<QByteArray> now = readFile(maze.path, kLargestMaze, nullptr);
    return now && hashOf(*now) == maze.hash ? std::nullopt : std::optional(maze);
}

bool Session::saveRun(const QString &path, QString *error) {
    if (m_replay) {
        if (error) *error = tr("%1: the run shown is a recording already").arg(quoted(path));
        return false;
    }
    const RunPlace run = runPlace();
    if (run.begin == run.end) {
        if (error) *error = tr("%1: no steps made yet; earlier runs are in Runs").arg(quoted(path));
        return false;
    }
    const std::optional<Past> kept = m_simulation->past(error, run.begin, run.end);
    if (!kept) return false;
    return replaceFile(path, recordingText(kept->recording->recording(), registry()), error);
}

} // namespace inspector
