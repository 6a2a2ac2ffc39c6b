// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/maze_watcher.h"

#include "core/setup/files.h"

#include <QCryptographicHash>
#include <QFileInfo>

#include <chrono>
#include <utility>

namespace inspector::ui {

namespace {
constexpr std::chrono::milliseconds kSettleTime{150};
}

MazeWatcher::MazeWatcher(QObject *parent)
    : QObject(parent) {
    m_settling.setSingleShot(true);
    m_settling.setInterval(kSettleTime);
    const auto wait = [this] { m_settling.start(); };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, wait);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, wait);
    connect(&m_settling, &QTimer::timeout, this, &MazeWatcher::look);
}

void MazeWatcher::watch(const QString &path) {
    m_settling.stop();
    const QStringList before = m_watcher.files() + m_watcher.directories();
    if (!before.isEmpty()) m_watcher.removePaths(before);
    m_path = path;
    m_known = digest();
    m_isLost = m_known.isEmpty() && !path.isEmpty();
    addPaths();
}

/// A file that was replaced is no longer watched, but its folder is.
void MazeWatcher::addPaths() {
    if (m_path.isEmpty()) return;
    const QFileInfo file(m_path);
    m_watcher.addPath(file.absolutePath());
    if (file.exists()) m_watcher.addPath(m_path);
}

QByteArray MazeWatcher::digest() const {
    const std::optional<QByteArray> bytes = readFile(m_path, kLargestMaze, nullptr);
    return bytes ? QCryptographicHash::hash(*bytes, QCryptographicHash::Sha1) : QByteArray();
}

void MazeWatcher::look() {
    addPaths();
    const QByteArray now = digest();
    const bool isLost = now.isEmpty() && !m_path.isEmpty();
    if (std::exchange(m_isLost, isLost) != isLost) isLost ? emit lost(m_path) : emit found();
    if (now.isEmpty() || now == m_known) return;
    m_known = now;
    emit changed(m_path);
}

} // namespace inspector::ui
