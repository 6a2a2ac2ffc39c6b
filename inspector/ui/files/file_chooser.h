// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>

class QSettings;
class QWidget;

namespace inspector::ui {

enum class FileUse { Read, Write };

struct FileQuestion {
    QString title;
    QString filter; ///< in QFileDialog's form
    QString name;   ///< the suggested name
    FileUse use;
};

/// Asks for a file, starting in the last used folder; doesn't block. Says so instead of using a name for saving that
/// has none of the endings in the filter, or where something else would replace a recording.
void chooseFile(QWidget &window, QSettings &settings, const FileQuestion &question,
                const std::function<void(const QString &path)> &use);

} // namespace inspector::ui
