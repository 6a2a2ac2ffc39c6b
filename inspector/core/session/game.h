// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of the game: prompt, clock, win, next level. Has no window and no simulation: it receives calls and sends
// signals.
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
        Prompt, ///< waiting; Enter starts the level
        Playing,
        Won,  ///< the time is shown; Enter opens the next level, if there is one
        Lost, ///< likewise; Enter starts the level again
    };

    /// mazes: a unique text for each level's maze, at least one; best times are stored under it. settings: stores best
    /// times; must outlive the game.
    Game(const QStringList &mazes, QSettings &settings, QObject *parent = nullptr);

    Phase phase() const { return m_phase; }
    int level() const { return m_level; }        ///< from 0
    double time() const { return m_time; }       ///< s, that the level took; 0 before its end
    bool isRecord() const { return m_isRecord; } ///< whether that is a new best time
    bool isStored() const { return m_isStored; } ///< whether the settings keep it
    std::optional<double> bestTime(int level) const;
    std::optional<double> bestTime() const; ///< of the open maze

    /// After a win, from 0: the first follows the last, one that can't be opened is passed over; none follows a maze
    /// that isn't in the list.
    std::optional<int> nextLevel() const;

    /// Enter: starts the level, also after it was lost; after a win opens the next one, or the same again if there is
    /// none.
    void confirm();
    /// Requests a level of the list; other numbers are ignored.
    void choose(int level);
    /// Called when a level was opened; shows its prompt. -1: the maze `other`, which isn't in the list and has best
    /// times of its own, was opened; the position in the list is kept.
    void prompt(int level, const QString &other = {});
    /// The same for a level that is already being played.
    void goOn(int level, const QString &other = {});
    /// Shows the open maze's prompt again.
    void again();
    /// The ball left the maze `time` s after the start. Ignored unless playing; assisted runs set no best time.
    void leaveMaze(double time, bool isAssisted);
    /// The same for a ball that left it otherwise than by a way out.
    void lose(double time);

signals:
    void phaseChanged(Game::Phase phase);
    void levelWanted(int level); ///< open it, then call prompt(level)
    void againWanted();          ///< put the ball back to the start, then call again()
    void started();              ///< start the simulation from the beginning

private:
    int levelCount() const { return int(m_mazes.size()); }
    bool isInList(int level) const { return level >= 0 && level < levelCount(); }
    void open(int level, const QString &other);
    void enter(Phase phase);

    QStringList m_mazes;
    QSettings &m_settings;
    Phase m_phase = Phase::Prompt;
    int m_level = 0;
    bool m_isListed = true; ///< the open maze is that level
    int m_refused = 0;      ///< levels after it that couldn't be opened
    QString m_maze;         ///< of the open level
    double m_time = 0.0;
    bool m_isRecord = false;
    bool m_isStored = false;
};

} // namespace inspector
