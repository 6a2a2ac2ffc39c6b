// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

class QImage;

namespace inspector::ui {

// As a file of PNG has it; empty if the picture is.
QByteArray pngOf(const QImage &picture);

// Writes it whole, as PNG, or leaves what there was. False and one line in `error` (or nullptr) if it can't be written.
bool savePicture(const QImage &picture, const QString &path, QString *error);

} // namespace inspector::ui
