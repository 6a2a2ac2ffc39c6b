// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/grab.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <QCoreApplication>
#include <QImageWriter>
#include <QPixmap>
#include <QWidget>

namespace inspector::ui {

bool grabToFile(QWidget &widget, const QString &path, QString *error) {
    const std::unique_ptr<OutputFile> file = OutputFile::open(path, Existing::Replace, {}, error);
    if (!file) return false;
    QImageWriter writer(file.get(), path.section(QLatin1Char('.'), -1).toLower().toLatin1());
    const bool isWritten = writer.write(widget.grab().toImage());
    if (file->finish() && isWritten) return true;
    const QString reason = file->problem();
    if (error)
        *error = QCoreApplication::translate("Grab", "the picture can't be written: %1")
                     .arg(reason.isEmpty() ? quoted(path) + QStringLiteral(": ") + writer.errorString() : reason);
    return false;
}

} // namespace inspector::ui
