// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/levels.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace inspector {

Level levelOfFile(const QString &path) {
    const QFileInfo text(path);
    const QFileInfo mesh(text.dir().filePath(text.completeBaseName() + QStringLiteral(".obj")));
    return {text.completeBaseName(), path, mesh.exists() ? mesh.filePath() : QString()};
}

std::vector<Level> levelsIn(const QString &folder) {
    if (folder.isEmpty()) return {}; // QDir would take it for the current one
    const QDir directory(folder);
    std::vector<Level> levels;
    for (const QString &name : directory.entryList({QStringLiteral("*.txt")}, QDir::Files, QDir::Name))
        levels.push_back(levelOfFile(directory.filePath(name)));
    return levels;
}

QString levelsFolder() {
    const QString own = qEnvironmentVariable("PHYSICS_LEVELS");
    if (!own.isEmpty()) return own;
    const QString installed = QCoreApplication::applicationDirPath() + QStringLiteral("/../share/physics/levels");
    for (const QString &folder : {installed, QStringLiteral(INSPECTOR_SOURCE_LEVELS)})
        if (QFileInfo(folder).isDir()) return QDir::cleanPath(folder);
    return {};
}

std::optional<Level> findLevel(const std::vector<Level> &levels, const QString &text, QString *error) {
    bool isNumber = false;
    const int number = text.toInt(&isNumber);
    if (!isNumber) return levelOfFile(text);
    if (number >= 1 && size_t(number) <= levels.size()) return levels[size_t(number) - 1];
    if (error)
        *error = levels.empty() ? QStringLiteral("no levels found in the folder '%1' (PHYSICS_LEVELS names another)")
                                      .arg(levelsFolder())
                                : QStringLiteral("expected 1 to %1, found %2").arg(levels.size()).arg(number);
    return std::nullopt;
}

} // namespace inspector
