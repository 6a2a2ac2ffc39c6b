// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/shader_library.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace inspector::gl {

namespace {

struct Recipe {
    const char *vertex;
    std::array<const char *, 2> fragments; ///< linked together; the second may be null
};

/// In the order of Program.
constexpr std::array<Recipe, 6> kRecipes{{{"maze.vert", {"maze.frag", "lighting.frag"}},
                                          {"ball.vert", {"ball.frag", "lighting.frag"}},
                                          {"backdrop.vert", {"backdrop.frag", nullptr}},
                                          {"depth.vert", {"depth.frag", nullptr}},
                                          {"stroke.vert", {"stroke.frag", nullptr}},
                                          {"smooth.vert", {"smooth.frag", nullptr}}}};

QString pathOf(const QString &directory, const char *name) {
    QString overridePath = directory + QLatin1Char('/') + QLatin1String(name);
    if (!directory.isEmpty() && (fileExists(overridePath) || isFolder(overridePath))) return overridePath;
    return QLatin1String(":/shaders/") + QLatin1String(name);
}

/// Software renderers execute both branches on a uniform, so the quality is a constant in the source.
QByteArray withQuality(QByteArray source, Quality quality) {
    const qsizetype lineEnd = source.indexOf('\n') + 1; // after #version, which must be the first line
    const QByteArray define = "#define QUALITY " + QByteArray::number(static_cast<int>(quality)) + "\n#line 2\n";
    return source.insert(lineEnd, define);
}

/// Embedded files are read by Qt, files of a directory like any external file.
std::optional<QByteArray> sourceOf(const QString &path, QString *log) {
    constexpr qint64 kLargest = kMegabyte;
    if (!path.startsWith(QLatin1Char(':'))) return readFile(path, kLargest, log);
    QFile file(path);
    if (file.open(QIODevice::ReadOnly)) return file.readAll();
    *log = QStringLiteral("%1: %2").arg(path, file.errorString());
    return std::nullopt;
}

bool addShader(QOpenGLShaderProgram &program, QOpenGLShader::ShaderType type, const QString &path, Quality quality,
               QString *log) {
    const std::optional<QByteArray> source = sourceOf(path, log);
    if (!source) return false;
    if (program.addShaderFromSourceCode(type, withQuality(*source, quality))) return true;
    *log = QStringLiteral("%1: %2").arg(oneLine(path), program.log().trimmed());
    return false;
}

std::unique_ptr<QOpenGLShaderProgram> buildProgram(const Recipe &recipe, const QString &directory, Quality quality,
                                                   QString *log) {
    auto program = std::make_unique<QOpenGLShaderProgram>();
    if (!addShader(*program, QOpenGLShader::Vertex, pathOf(directory, recipe.vertex), quality, log)) return nullptr;
    for (const char *name : recipe.fragments) {
        if (name && !addShader(*program, QOpenGLShader::Fragment, pathOf(directory, name), quality, log))
            return nullptr;
    }
    if (program->link()) return program;
    *log = QStringLiteral("%1 with %2: %3")
               .arg(QLatin1String(recipe.vertex), QLatin1String(recipe.fragments[0]), program->log().trimmed());
    return nullptr;
}

} // namespace

ShaderLibrary::ShaderLibrary() {
    const auto noteChange = [this] {
        m_isStale = true;
        watch(); // editors replace files, which ends the watch on the old one
        emit changed();
    };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, noteChange);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, noteChange);
}

void ShaderLibrary::setDirectory(const QString &path) {
    m_directory = path;
    m_isStale = true;
    if (!m_watcher.files().isEmpty()) m_watcher.removePaths(m_watcher.files());
    if (!m_watcher.directories().isEmpty()) m_watcher.removePaths(m_watcher.directories());
    if (!path.isEmpty() && !isFolder(path))
        emit failed(QStringLiteral("%1: expected a directory with shaders, found none").arg(path));
    watch();
}

void ShaderLibrary::watch() {
    if (m_directory.isEmpty()) return;
    // If the directory is missing, watch its nearest existing parent for it.
    QString there = QDir::cleanPath(QFileInfo(m_directory).absoluteFilePath());
    while (!isFolder(there) && there.contains(QLatin1Char('/')))
        there = there.left(there.lastIndexOf(QLatin1Char('/')));
    if (!isFolder(m_directory)) {
        m_watcher.addPath(there.isEmpty() ? QStringLiteral("/") : there);
        return;
    }
    QStringList paths{m_directory};
    for (const QFileInfo &file : QDir(m_directory).entryInfoList({"*.vert", "*.frag"}, QDir::Files))
        paths.append(file.filePath());
    m_watcher.addPaths(paths); // already watched paths are unaffected
}

bool ShaderLibrary::update(Quality quality) {
    if (!m_isStale && quality == m_quality) return true;
    m_isStale = false;
    m_quality = quality;
    QString log;
    Set programs = build(m_directory, quality, &log);
    if (!programs[0]) {
        emit failed(log);
        if (m_programs[0]) return true;
        programs = build({}, quality, &log); // nothing drawn yet: start with the embedded ones
        if (!programs[0]) return m_isStale = true, false;
    }
    m_programs = std::move(programs);
    ++m_generation;
    emit rebuilt();
    return true;
}

ShaderLibrary::Set ShaderLibrary::build(const QString &directory, Quality quality, QString *log) const {
    Set programs;
    for (std::size_t i = 0; i < kCount; ++i) {
        programs[i] = buildProgram(kRecipes[i], directory, quality, log);
        if (!programs[i]) return {};
    }
    return programs;
}

QOpenGLShaderProgram &ShaderLibrary::use(Program program) {
    QOpenGLShaderProgram &chosen = *m_programs[static_cast<std::size_t>(program)];
    chosen.bind();
    return chosen;
}

} // namespace inspector::gl
