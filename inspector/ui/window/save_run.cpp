// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/save_run.h"

#include "core/program/csv_writer.h"
#include "core/program/outputs.h"
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

std::vector<Setting> settingsOf(const Parameters &parameters) {
    std::vector<Setting> settings;
    for (int i = 0; i < parameters.count(); ++i)
        settings.push_back({QString::fromUtf8(parameters.row(i).id), parameters.value(i)});
    return settings;
}

// With which a command line would begin where the session is now.
Options optionsOf(Session &session) {
    Options options;
    options.registry = session.registry();
    options.level = session.level();
    options.stepper = session.stepperId();
    options.dt = session.dt();
    options.autopilot = session.hasAutopilot();
    options.settings = settingsOf(session.parameters());
    Comparison &comparison = session.comparison();
    if (!comparison.isOn()) return options;
    options.comparison = comparison.ghostChoice();
    if (comparison.hasOwnParameters()) options.comparisonSettings = settingsOf(comparison.parameters());
    return options;
}

bool saveSamples(Session &session, const QString &path, QString *error) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return fail(error, QStringLiteral("%1: %2").arg(path, file.errorString()));
    writeSamples(file, session.simulation().samples(), 0.0, Columns::All);
    if (!file.commit()) return fail(error, QStringLiteral("%1: %2").arg(path, file.errorString()));
    return saveSettingsBeside(session, path, error);
}

} // namespace

bool saveSettingsBeside(Session &session, const QString &csv, QString *error) {
    QSaveFile file(settingsFileOf(csv));
    if (!file.open(QIODevice::WriteOnly))
        return fail(error, QStringLiteral("%1: %2").arg(file.fileName(), file.errorString()));
    file.write(tableSettings(optionsOf(session)));
    file.write(spanOf(session.simulation().samples()).toUtf8() + '\n');
    return file.commit() || fail(error, QStringLiteral("%1: %2").arg(file.fileName(), file.errorString()));
}

QString lostSamples(Session &session, const QString &path) {
    const SampleRing &samples = session.simulation().samples();
    const bool isTable = path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
    return isTable && samples.first() > 0 ? QStringLiteral("%1: %2").arg(path, spanOf(samples)) : QString();
}

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
