// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/grab.h"

#include <QCoreApplication>
#include <QImageWriter>
#include <QPixmap>
#include <QWidget>

namespace inspector::ui {

bool grabToFile(QWidget &widget, const QString &path, QString *error) {
    QImageWriter writer(path);
    if (writer.write(widget.grab().toImage())) return true;
    if (error)
        *error =
            QCoreApplication::translate("Grab", "%1: the picture can't be written: %2").arg(path, writer.errorString());
    return false;
}

} // namespace inspector::ui
