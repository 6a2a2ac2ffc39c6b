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
    QString filter; // as QFileDialog's
    QString name;   // proposed
    FileUse use;
};

// Asks for a file, starting in the folder of the last one; nothing waits for the answer.
void chooseFile(QWidget &window, QSettings &settings, const FileQuestion &question,
                const std::function<void(const QString &path)> &use);

} // namespace inspector::ui
