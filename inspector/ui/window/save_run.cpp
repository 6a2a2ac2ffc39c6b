// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/save_run.h"

#include "core/program/csv_writer.h"
#include "core/session/session.h"
#include "gl/view/maze_view.h"
#include "ui/parts/settings_keys.h"

#include <QFileInfo>
#include <QImage>
#include <QSaveFile>

namespace inspector::ui {

namespace {

bool fail(QString *error, const QString &line) {
    if (error) *error = line;
    return false;
}

bool saveSamples(Session &session, const QString &path, QString *error) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return fail(error, QStringLiteral("%1: %2").arg(path, file.errorString()));
    file.write(csvHeader(Columns::All));
    const SampleRing &samples = session.simulation().samples();
    Sample sample;
    for (uint64_t number = samples.first(); number < samples.last(); ++number)
        if (samples.read(number, sample)) file.write(csvRow(sample, Columns::All));
    return file.commit() || fail(error, QStringLiteral("%1: %2").arg(path, file.errorString()));
}

} // namespace

bool saveRun(Session &session, gl::MazeView &view, const QString &path, QString *error) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("rec")) return session.saveRun(path, error);
    if (suffix == QLatin1String("csv")) return saveSamples(session, path, error);
    if (suffix != QLatin1String("png"))
        return fail(error, QStringLiteral("%1: expected a name that ends in .rec, .csv or .png").arg(path));
    const int scale = session.settings().value(settings_keys::kPictureScale, 1).toInt();
    return view.picture(scale).save(path) || fail(error, QStringLiteral("%1: the picture can't be written").arg(path));
}

} // namespace inspector::ui
