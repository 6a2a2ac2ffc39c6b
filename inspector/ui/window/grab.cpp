// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/grab.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "ui/files/picture_file.h"

#include <QCoreApplication>
#include <QImage>
#include <QPixmap>
#include <QWidget>

namespace inspector::ui {

bool grabToFile(QWidget &widget, const QString &path, QString *error) {
    const std::unique_ptr<OutputFile> file = OutputFile::open(path, Existing::Replace, {}, error);
    if (!file) return false;
    const QByteArray png = pngOf(widget.grab().toImage());
    file->write(png);
    if (file->finish() && !png.isEmpty()) return true;
    const QString reason = file->problem();
    if (error)
        *error =
            QCoreApplication::translate("Grab", "the picture can't be written: %1")
                .arg(reason.isEmpty() ? quoted(path) + QStringLiteral(": ") + QStringLiteral("it is empty") : reason);
    return false;
}

} // namespace inspector::ui
