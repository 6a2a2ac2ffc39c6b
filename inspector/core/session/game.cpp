// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/game.h"

#include "core/setup/stored_values.h"

#include <QSettings>

namespace inspector {

Game::Game(const QStringList &mazes, QSettings &settings, QObject *parent)
    : QObject(parent)
    , m_mazes(mazes)
    , m_settings(settings) {}

QString Game::bestTimeKey(int level) const { return QStringLiteral("best_times/") + m_mazes.value(level); }

std::optional<double> Game::bestTime(int level) const { return storedTime(m_settings, bestTimeKey(level)); }

void Game::confirm() {
    if (m_phase == Phase::Won) {
        emit levelWanted((m_level + 1) % levelCount());
    } else if (m_phase == Phase::Prompt) {
        enter(Phase::Playing);
        emit started();
    }
}

void Game::choose(int level) {
    if (level >= 0 && level < levelCount()) emit levelWanted(level);
}

void Game::prompt(int level) {
    if (level < 0 || level >= levelCount()) return;
    m_level = level;
    m_time = 0.0;
    m_isRecord = false;
    enter(Phase::Prompt);
}

void Game::goOn(int level) {
    if (level >= 0 && level < levelCount()) m_level = level;
    m_time = 0.0;
    m_isRecord = false;
    enter(Phase::Playing);
}

void Game::leaveMaze(double time, bool isAssisted) {
    if (m_phase != Phase::Playing) return;
    m_time = time;
    m_settings.sync(); // another window may have had a better one
    const std::optional<double> best = bestTime(m_level);
    m_isRecord = !isAssisted && (!best || time < *best);
    if (m_isRecord) m_settings.setValue(bestTimeKey(m_level), time);
    m_settings.sync();
    enter(Phase::Won);
}

void Game::enter(Phase phase) {
    m_phase = phase;
    emit phaseChanged(phase);
}

} // namespace inspector
