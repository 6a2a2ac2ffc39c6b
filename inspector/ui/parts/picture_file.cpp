// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/picture_file.h"

#include "core/setup/files.h"

#include <QImage>

namespace inspector::ui {

bool savePicture(const QImage &picture, const QString &path, QString *error) {
    return replaceFile(
        path, [&](QIODevice &file) { return picture.save(&file, "PNG"); }, error);
}

} // namespace inspector::ui
