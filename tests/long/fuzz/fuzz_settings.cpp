// SPDX-License-Identifier: MIT
// Any bytes as a settings file: a best time is a time, a choice is one of the existing ones, and a win is stored.
#include "core/session/game.h"
#include "core/setup/settings_file.h"
#include "core/setup/stored_values.h"
#include "input.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

#include <cmath>

using namespace inspector;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const QTemporaryDir folder;
    const QString path = folder.filePath("settings.ini");
    QFile file(path);
    fuzz::demand(file.open(QIODevice::WriteOnly) &&
                 file.write(reinterpret_cast<const char *>(data), qint64(size)) >= 0);
    file.close();

    QSettings settings(path, settingsFormat());
    for (const char *key : {"window/quality", "window/theme", "window/geometry"}) {
        const std::optional<int> choice = storedChoice(settings, QString::fromLatin1(key), 3);
        fuzz::demand(!choice || (*choice >= 0 && *choice < 3));
    }
    Game game({QStringLiteral("a"), QStringLiteral("b")}, settings);
    const std::optional<double> before = game.bestTime(0);
    fuzz::demand(!before || (std::isfinite(*before) && *before > 0.0));
    game.confirm();
    game.leaveMaze(1.0, false);
    fuzz::demand(game.bestTime(0).value_or(2.0) <= 1.0);
    return 0;
}
