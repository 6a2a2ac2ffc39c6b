// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/save_run.h"

#include "core/program/csv_writer.h"
#include "core/program/outputs.h"
#include "core/session/row_settings.h"
#include "core/session/session.h"
#include "core/setup/files.h"
#include "gl/view/maze_view.h"
#include "ui/parts/picture_file.h"
#include "ui/parts/settings_keys.h"

#include <QFileInfo>
#include <QImage>

namespace inspector::ui {

namespace {

bool saveTable(Session &session, const QString &path, QString *error) {
    return saveSamples(path, session.simulation().samples(), 0.0, Columns::All, error) &&
           saveSettingsBeside(session, path, 0.0, error);
}

} // namespace

bool saveSettingsBeside(Session &session, const QString &csv, double since, QString *error) {
    const QString span = spanOf(session.simulation().samples(), since);
    const QByteArray text = rowSettings(session, since) + span.toUtf8() + '\n';
    return replaceFile(settingsFileOf(csv), text, error);
}

QString lostSamples(Session &session, const QString &path) {
    const SampleRing &samples = session.simulation().samples();
    const bool isTable = path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
    return isTable && isPartial(samples) ? QStringLiteral("%1: %2").arg(path, spanOf(samples)) : QString();
}

bool saveRun(Session &session, gl::MazeView &view, const QString &path, QString *error) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("rec")) return session.saveRun(path, error);
    if (suffix == QLatin1String("csv")) return saveTable(session, path, error);
    const int scale = session.settings().value(settings_keys::kPictureScale, 1).toInt();
    if (suffix == QLatin1String("png")) return savePicture(view.picture(scale), path, error);
    *error = QStringLiteral("%1: expected a name that ends in .rec, .csv or .png").arg(path);
    return false;
}

} // namespace inspector::ui
