// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace inspector {

struct Level {
    QString name; ///< 01
    QString path; ///< of its text file
    QString mesh; ///< of its .obj beside it; empty if there is none
};

/// The text file as a level, whether it is in the list or not.
Level levelOfFile(const QString &path);

/// The levels in a folder: its text files that are mazes, in natural order of their names (2 before 10).
std::vector<Level> levelsIn(const QString &folder);

/// The folder of the levels: the environment variable PHYSICS_LEVELS, else the share folder of an installation, else
/// the source tree's; if neither exists, the installation's.
QString levelsFolder();

/// The number that is the level's name, 10 for 010; nothing for any other name.
std::optional<int> numberOf(const Level &level);

/// Level 1, or the first of the list if none is called so. The list isn't empty.
Level firstLevel(const std::vector<Level> &levels);

/// Finds a level by what the user typed: its number, or the path of a file. If no name in the list is a number, it is
/// the position there, from 1. Returns nothing, with one line in `error` (may be nullptr), if there is no such number.
std::optional<Level> findLevel(const std::vector<Level> &levels, const QString &text, QString *error);

} // namespace inspector
