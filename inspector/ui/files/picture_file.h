// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

class QImage;

namespace inspector::ui {

/// The picture as PNG bytes; empty if the picture is.
QByteArray pngOf(const QImage &picture);

/// Writes the picture as PNG, whole or not at all. Returns false, with one line in `error` (may be nullptr), if it
/// can't be written.
bool savePicture(const QImage &picture, const QString &path, QString *error);

} // namespace inspector::ui
