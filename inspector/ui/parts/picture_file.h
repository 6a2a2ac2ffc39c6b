// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QImage;

namespace inspector::ui {

// Writes it whole, as PNG, or leaves what there was. False and one line in `error` (or nullptr) if it can't be written.
bool savePicture(const QImage &picture, const QString &path, QString *error);

} // namespace inspector::ui
