// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace inspector::ui {

// Tells when the bytes of a maze's file have become others, however an editor writes them: in place, or as a new file
// with the name of the old one.
class MazeWatcher : public QObject {
    Q_OBJECT

public:
    explicit MazeWatcher(QObject *parent = nullptr);

    // As it is now; empty: nothing is watched.
    void watch(const QString &path);

signals:
    void changed(const QString &path);

private:
    void look();
    void addPaths();
    QByteArray digest() const; // empty: it can't be read just now

    QFileSystemWatcher m_watcher;
    QTimer m_settling; // an editor may write it in pieces
    QString m_path;
    QByteArray m_known;
};

} // namespace inspector::ui
