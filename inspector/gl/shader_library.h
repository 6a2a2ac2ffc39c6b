// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/frame.h"

#include <array>
#include <memory>

#include <QFileSystemWatcher>
#include <QObject>
#include <QOpenGLShaderProgram>

namespace inspector::gl {

enum class Program { Maze, Ball, Backdrop, Depth, Stroke, Smooth };

/// The programs built from shaders/*.vert and *.frag. The files are embedded in the executable, and each can be
/// overridden by one in a directory that is watched at run time. If a set doesn't compile, this is reported and the
/// last good set stays in use.
class ShaderLibrary : public QObject {
    Q_OBJECT

public:
    ShaderLibrary();

    /// path: empty for embedded files only. Takes effect at the next update().
    void setDirectory(const QString &path);

    /// Call between frames, with the context current: rebuilds if files, directory or quality have changed. Returns
    /// whether there is a usable set of programs.
    bool update(Quality quality);

    /// Changes with every new set of programs.
    uint64_t generation() const { return m_generation; }

    /// Bound and ready for uniforms; only after update() has returned true.
    QOpenGLShaderProgram &use(Program program);

signals:
    void changed();                  ///< a file of the directory has changed: redraw
    void rebuilt();                  ///< a new set is in use
    void failed(const QString &log); ///< the last good set stays in use

private:
    static constexpr std::size_t kCount = 6;
    using Set = std::array<std::unique_ptr<QOpenGLShaderProgram>, kCount>;

    void watch();
    Set build(const QString &directory, Quality quality, QString *log) const;

    QString m_directory;
    QFileSystemWatcher m_watcher;
    Set m_programs;
    uint64_t m_generation = 0;
    Quality m_quality = Quality::Medium;
    bool m_isStale = true;
};

} // namespace inspector::gl
