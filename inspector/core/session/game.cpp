// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/game.h"

#include <QSettings>

namespace inspector {

namespace {
QString bestTimeKey(int level) { return QStringLiteral("best_times/%1").arg(level + 1, 2, 10, QLatin1Char('0')); }
} // namespace

Game::Game(int levelCount, QSettings &settings, QObject *parent)
    : QObject(parent)
    , m_levelCount(levelCount)
    , m_settings(settings) {}

std::optional<double> Game::bestTime(int level) const {
    bool isNumber = false;
    const double time = m_settings.value(bestTimeKey(level)).toDouble(&isNumber);
    if (!isNumber || !(time > 0.0)) return std::nullopt;
    return time;
}

void Game::confirm() {
    if (m_phase == Phase::Won) {
        emit levelWanted((m_level + 1) % m_levelCount);
    } else if (m_phase == Phase::Prompt) {
        enter(Phase::Playing);
        emit started();
    }
}

void Game::choose(int level) {
    if (level >= 0 && level < m_levelCount) emit levelWanted(level);
}

void Game::prompt(int level) {
    if (level < 0 || level >= m_levelCount) return;
    m_level = level;
    m_time = 0.0;
    m_isRecord = false;
    enter(Phase::Prompt);
}

void Game::goOn(int level) {
    if (level >= 0 && level < m_levelCount) m_level = level;
    m_time = 0.0;
    m_isRecord = false;
    enter(Phase::Playing);
}

void Game::leaveMaze(double time, bool isAssisted) {
    if (m_phase != Phase::Playing) return;
    m_time = time;
    const std::optional<double> best = bestTime(m_level);
    m_isRecord = !isAssisted && (!best || time < *best);
    if (m_isRecord) m_settings.setValue(bestTimeKey(m_level), time);
    enter(Phase::Won);
}

void Game::enter(Phase phase) {
    m_phase = phase;
    emit phaseChanged(phase);
}

} // namespace inspector
