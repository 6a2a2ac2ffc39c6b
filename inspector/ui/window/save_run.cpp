// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/save_run.h"

#include "core/program/csv_writer.h"
#include "core/program/outputs.h"
#include "core/session/row_settings.h"
#include "core/session/session.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "gl/view/maze_view.h"
#include "ui/files/picture_file.h"
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

/// Where the recording of the run shown begins, unless it has all steps that its plots and table have.
QStringList remarksOnBegin(Session &session) {
    const RunPlace run = session.runPlace();
    const std::optional<Past> first = session.simulation().past(nullptr, run.begin, run.begin + 1);
    if (!first) return {};
    const double begin = first->keyframes.front().state.time;
    if (run.isCut) return {QStringLiteral("steps from %1 s; earlier ones aren't kept").arg(begin)};
    const SampleRing &samples = session.simulation().samples();
    Sample sample;
    if (!samples.read(samples.first(), sample) || sample.time > begin) return {};
    return {QStringLiteral("begins at %1 s, where the run was taken over; its table (.csv) has what came before, too")
                .arg(begin)};
}

QStringList remarksOnRecording(Session &session) {
    QStringList remarks = remarksOnBegin(session);
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
    if (isOfKind(".csv") && samples.hasLostSamples()) remarks += spanOf(samples);
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
