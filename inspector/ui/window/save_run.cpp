// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/save_run.h"

#include "core/program/csv_writer.h"
#include "core/program/outputs.h"
#include "core/session/row_settings.h"
#include "core/session/session.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "gl/view/maze_view.h"
#include "ui/parts/picture_file.h"
#include "ui/parts/settings_keys.h"

#include <QFileInfo>
#include <QImage>

#include <optional>

namespace inspector::ui {

namespace {

bool saveTable(Session &session, const QString &path, QString *error) {
    return saveSamples(path, session.simulation().samples(), 0.0, Columns::All, error) &&
           saveSettingsBeside(session, path, 0.0, error);
}

/// The time, s, from which on the run shown is kept; nothing if all of it is.
std::optional<double> keptSince(Session &session) {
    const RunPlace run = session.runPlace();
    if (!run.isCut) return std::nullopt;
    const std::optional<Past> first = session.simulation().past(nullptr, run.begin, run.begin + 1);
    if (!first) return std::nullopt;
    return first->keyframes.front().state.time;
}

QStringList remarksOnRecording(Session &session) {
    QStringList remarks;
    if (const std::optional<double> since = keptSince(session))
        remarks += QStringLiteral("steps from %1 s; earlier ones aren't kept").arg(*since);
    if (const std::optional<MazeSource> maze = session.changedMaze())
        remarks += QStringLiteral("%1 has changed since this run and is needed as it was to replay it")
                       .arg(quoted(maze->path));
    return remarks;
}

} // namespace

bool saveSettingsBeside(Session &session, const QString &csv, double since, QString *error) {
    return replaceFile(settingsFileOf(csv), rowSettings(session, since), error);
}

bool writeTableOfRun(Session &session, const Options &options, QString *error) {
    session.simulation().pause(); // so that rows and settings are of the same steps
    session.lookAtLastSteps();
    TableShape shape = tableShape(options);
    const QByteArray settings = rowSettings(session, 0.0);
    const SampleRing &samples = session.simulation().samples();
    if (hasValues(samples, Channel::Distance, 0.0)) shape.columns = Columns::BallAndGhost; // switched on in the window
    return writeTable(options.csv, samples, shape, settings, error);
}

QString remarkOnSaved(Session &session, const QString &path) {
    const auto isOfKind = [&path](const char *suffix) {
        return path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
    };
    QStringList remarks;
    if (isOfKind(".rec")) remarks = remarksOnRecording(session);
    const SampleRing &samples = session.simulation().samples();
    if (isOfKind(".csv") && isPartial(samples)) remarks += spanOf(samples);
    return remarks.isEmpty() ? QString() : QStringLiteral("%1: %2").arg(path, remarks.join(QStringLiteral("; ")));
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
