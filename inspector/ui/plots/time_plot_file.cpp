// SPDX-License-Identifier: GPL-3.0-or-later
// How the plot becomes a file.
#include "ui/plots/time_plot.h"

#include <QFile>
#include <QFileInfo>
#include <QPdfWriter>
#include <QSaveFile>

namespace inspector::ui {

namespace {

constexpr double kPictureScale = 2.0; // pixels per pixel of the screen, for print

bool fail(QString *error, const QString &line) {
    if (error) *error = line;
    return false;
}

} // namespace

bool TimePlot::save(const QString &path, QString *error) {
    refresh();
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("csv")) return saveTable(path, error);
    if (suffix != QLatin1String("png") && suffix != QLatin1String("pdf"))
        return fail(error, tr("%1: expected a name that ends in .csv, .png or .pdf").arg(path));
    const bool isSaved = suffix == QLatin1String("png") ? savePng(path, 0, 0, kPictureScale) : savePdf(path);
    return isSaved || fail(error, tr("%1: the plot can't be written").arg(path));
}

bool TimePlot::saveTable(const QString &path, QString *error) const {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return fail(error, QStringLiteral("%1: %2").arg(path, file.errorString()));
    writeSamples(file, m_samples, m_time->clearedAt(), columns());
    return file.commit() || fail(error, QStringLiteral("%1: %2").arg(path, file.errorString()));
}

} // namespace inspector::ui
