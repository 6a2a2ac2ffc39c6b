// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of the game: prompt, clock, won, next level. No window, no simulation: it is told and it tells.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include <optional>

class QSettings;

namespace inspector {

class Game : public QObject {
    Q_OBJECT

public:
    enum class Phase {
        Prompt, // the level is shown, Enter starts it
        Playing,
        Won, // the time is shown, Enter goes on to the next level
    };

    // mazes: a text for each level that tells its maze from all others, at least one; best times are kept under it.
    // settings: where they are kept; outlives the game.
    Game(const QStringList &mazes, QSettings &settings, QObject *parent = nullptr);

    Phase phase() const { return m_phase; }
    int level() const { return m_level; }        // from 0
    double time() const { return m_time; }       // that the level took, s; 0 before it's won
    bool isRecord() const { return m_isRecord; } // whether that was the best ever
    std::optional<double> bestTime(int level) const;
    std::optional<double> bestTime() const; // of the maze that is open

    // Enter: starts the level, or goes on to the next one after a win (the first comes after the last).
    void confirm();
    // Asks for a level of the list; others are ignored.
    void choose(int level);
    // A level is open: its prompt is shown. -1: `other` is, a maze that isn't in the list, which keeps the place in it;
    // it has best times of its own.
    void prompt(int level, const QString &other = {});
    // The same for one that is being played already.
    void goOn(int level, const QString &other = {});
    // The prompt of the maze that is open.
    void again();
    // The ball left the maze, `time` s after the start. Counts only while playing; assisted runs set no record.
    void leaveMaze(double time, bool isAssisted);

signals:
    void phaseChanged(Game::Phase phase);
    void levelWanted(int level); // to be opened, then prompt(level)
    void started();              // the simulation is to run from the start

private:
    int levelCount() const { return int(m_mazes.size()); }
    bool isInList(int level) const { return level >= 0 && level < levelCount(); }
    void open(int level, const QString &other);
    void enter(Phase phase);

    QStringList m_mazes;
    QSettings &m_settings;
    Phase m_phase = Phase::Prompt;
    int m_level = 0;
    QString m_maze; // that is open
    double m_time = 0.0;
    bool m_isRecord = false;
};

} // namespace inspector
