// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace inspector::ui {

/// Notifies when the content of a maze's file has changed, whether an editor writes it in place or replaces it.
class MazeWatcher : public QObject {
    Q_OBJECT

public:
    explicit MazeWatcher(QObject *parent = nullptr);

    /// Watches the file from its current content on; empty: watches nothing.
    void watch(const QString &path);

signals:
    void changed(const QString &path);
    void lost(const QString &path); ///< it was deleted or can't be read any more
    void found();                   ///< after lost()

private:
    void look();
    void addPaths();
    QByteArray digest() const; ///< empty if it can't be read just now

    QFileSystemWatcher m_watcher;
    QTimer m_settling; ///< debounces writes in several parts
    QString m_path;
    QByteArray m_known;
    bool m_isLost = false;
};

} // namespace inspector::ui
