// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recording/recording.h"
#include "core/setup/handles.h"
#include "core/setup/levels.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace inspector {

/// The levels on offer and the open one, which may be a file that isn't among them.
class LevelSelection {
public:
    LevelSelection(const std::vector<Level> &listed, const Level &open, const Scene &scene);

    const std::vector<Level> &listed() const { return m_listed; }
    QStringList mazes() const; ///< identifies the maze of each, for best times; isn't empty
    const Level &open() const { return m_open; }
    const Scene &scene() const { return m_scene; } ///< of the open level
    int index() const;                             ///< of the open one in the list; -1 for a file that isn't
    bool isOpenListed() const { return index() >= 0; }
    QString otherMaze() const; ///< such a file's maze, as in mazes(); empty for a level of the list
    /// The live ball's, as it was read; its file may have changed since.
    const MazeSource &maze() const { return m_maze; }
    bool isMazeOlder() const { return m_isMazeOlder; } ///< it has
    /// Places on the floor where the ball can leave the maze; nothing if they can't be found. Computed once per level.
    const std::optional<std::vector<phys_box>> &exits() const;

    void open(const Level &level, const Scene &scene); ///< for the live ball, as its file is now
    void show(const Level &level, const Scene &scene); ///< of another moment; the live ball's maze stays
    void goOnIn(uint64_t maze); ///< the live ball is in the open level now, whose file had this hash when it was read

private:
    std::vector<Level> m_listed;
    Level m_open;
    Scene m_scene;
    MazeSource m_maze;
    bool m_isMazeOlder = false;
    mutable Scene m_exitsOf; ///< the scene of m_exits
    mutable std::optional<std::vector<phys_box>> m_exits;
};

} // namespace inspector
