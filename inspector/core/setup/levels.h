// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace inspector {

struct Level {
    QString name; // 01
    QString path; // of its text file
    QString mesh; // of its .obj beside it; empty if there is none
};

// The text file as a level, whether it is one of the list or not.
Level levelOfFile(const QString &path);

// The levels of a folder: its text files that are mazes, in order of name, 2 before 10.
std::vector<Level> levelsIn(const QString &folder);

// Where the levels are: the environment variable PHYSICS_LEVELS, else the share folder of an installation, else the
// source tree. Empty if nowhere.
QString levelsFolder();

// What a person calls a level: its number, or the path of a file. The number is its name where all names of the list
// are numbers (010 is 10), else its place in the list, from 1. Nothing and one line in `error` (or nullptr) if the list
// has no such number.
std::optional<Level> findLevel(const std::vector<Level> &levels, const QString &text, QString *error);

} // namespace inspector
