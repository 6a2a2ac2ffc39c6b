// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/picture_file.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <QBuffer>
#include <QImage>

namespace inspector::ui {

/// Encodes in memory, because the PNG encoder prints a message of its own when a file can't be written.
QByteArray pngOf(const QImage &picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    return buffer.open(QIODevice::WriteOnly) && picture.save(&buffer, "PNG") ? bytes : QByteArray();
}

bool savePicture(const QImage &picture, const QString &path, QString *error) {
    const QByteArray png = pngOf(picture);
    if (!png.isEmpty()) return replaceFile(path, png, error);
    if (error) *error = quoted(path) + QStringLiteral(": the picture is empty");
    return false;
}

} // namespace inspector::ui
