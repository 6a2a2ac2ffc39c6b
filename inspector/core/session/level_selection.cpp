// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/level_selection.h"

#include "core/pilot/exits.h"
#include "core/setup/files.h"

#include <algorithm>
#include <utility>

namespace inspector {

namespace {

/// As its file is now.
MazeSource sourceOf(const Level &level) {
    return {level.path, hashOf(readFile(level.path, kLargestMaze, nullptr).value_or(QByteArray()))};
}

/// Identifies a maze by its file's bytes: another file of the same number has another best time.
QString mazeOf(const Level &level) { return QString::fromLatin1(hashText(sourceOf(level).hash)); }

} // namespace

LevelSelection::LevelSelection(const std::vector<Level> &listed, const Level &open, const Scene &scene)
    : m_listed(listed)
    , m_open(open)
    , m_scene(scene)
    , m_maze(sourceOf(open)) {}

QStringList LevelSelection::mazes() const {
    QStringList mazes;
    for (const Level &level : m_listed) mazes += mazeOf(level);
    return mazes.isEmpty() ? QStringList{QStringLiteral("none")} : mazes;
}

int LevelSelection::index() const {
    const auto found = std::ranges::find(m_listed, m_open.path, &Level::path);
    return found == m_listed.end() ? -1 : int(found - m_listed.begin());
}

QString LevelSelection::otherMaze() const { return isOpenListed() ? QString() : mazeOf(m_open); }

const std::optional<std::vector<phys_box>> &LevelSelection::exits() const {
    if (std::exchange(m_exitsOf, m_scene) != m_scene) m_exits = exitsOf(m_scene.get());
    return m_exits;
}

void LevelSelection::open(const Level &level, const Scene &scene) {
    show(level, scene);
    m_maze = sourceOf(level);
    m_isMazeOlder = false;
}

void LevelSelection::show(const Level &level, const Scene &scene) {
    m_open = level;
    m_scene = scene;
}

void LevelSelection::goOnIn(uint64_t maze) {
    m_maze = {m_open.path, maze};
    m_isMazeOlder = m_maze != sourceOf(m_open);
}

} // namespace inspector
