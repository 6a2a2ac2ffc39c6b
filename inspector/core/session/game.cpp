// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/game.h"

#include "core/setup/stored_values.h"

#include <QSettings>

namespace inspector {

namespace {

QString bestTimeKey(const QString &maze) { return QStringLiteral("best_times/") + maze; }

} // namespace

Game::Game(const QStringList &mazes, QSettings &settings, QObject *parent)
    : QObject(parent)
    , m_mazes(mazes)
    , m_settings(settings)
    , m_maze(mazes.value(0)) {}

std::optional<double> Game::bestTime(int level) const {
    return storedTime(m_settings, bestTimeKey(m_mazes.value(level)));
}

std::optional<double> Game::bestTime() const { return storedTime(m_settings, bestTimeKey(m_maze)); }

void Game::confirm() {
    if (m_phase == Phase::Won) {
        const std::optional<int> next = nextLevel();
        next ? emit levelWanted(*next) : emit againWanted();
        if (m_phase == Phase::Won) ++m_refused;
    } else if (m_phase != Phase::Playing) {
        enter(Phase::Playing);
        emit started();
    }
}

std::optional<int> Game::nextLevel() const {
    return m_isListed ? std::optional((m_level + 1 + m_refused) % levelCount()) : std::nullopt;
}

void Game::choose(int level) {
    if (isInList(level)) emit levelWanted(level);
}

void Game::prompt(int level, const QString &other) {
    if (!isInList(level) && other.isEmpty()) return;
    open(level, other);
    enter(Phase::Prompt);
}

void Game::goOn(int level, const QString &other) {
    open(level, other);
    enter(Phase::Playing);
}

void Game::again() {
    m_time = 0.0;
    m_isRecord = false;
    enter(Phase::Prompt);
}

void Game::open(int level, const QString &other) {
    m_refused = 0;
    m_isListed = isInList(level);
    if (m_isListed) m_level = level;
    m_maze = m_isListed ? m_mazes[level] : other;
    m_time = 0.0;
    m_isRecord = false;
}

void Game::leaveMaze(double time, bool isAssisted) {
    if (m_phase != Phase::Playing) return;
    m_time = time;
    m_settings.sync(); // another window may have stored a better one
    const std::optional<double> best = bestTime();
    m_isRecord = !isAssisted && !m_maze.isEmpty() && (!best || time < *best);
    if (m_isRecord) m_settings.setValue(bestTimeKey(m_maze), time);
    m_settings.sync();
    m_isStored = m_isRecord && m_settings.status() != QSettings::AccessError;
    enter(Phase::Won);
}

void Game::lose(double time) {
    if (m_phase != Phase::Playing) return;
    m_time = time;
    enter(Phase::Lost);
}

void Game::enter(Phase phase) {
    m_phase = phase;
    emit phaseChanged(phase);
}

} // namespace inspector
