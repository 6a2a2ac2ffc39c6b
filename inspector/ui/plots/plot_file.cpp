// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_file.h"

#include "core/setup/files.h"
#include "ui/files/picture_file.h"

#include <QFileInfo>
#include <QPdfWriter>
#include <qcustomplot.h>

namespace inspector::ui {

namespace {

/// QCustomPlot::savePdf() doesn't report write errors.
bool drawPdf(QCustomPlot &plot, const QSize &size, QIODevice &file) {
    QPdfWriter pdf(&file);
    pdf.setPageLayout({QPageSize(QSizeF(size), QPageSize::Point), QPageLayout::Portrait, {}});
    QCPPainter painter;
    if (!painter.begin(&pdf)) return false;
    painter.setMode(QCPPainter::pmVectorized);
    painter.setWindow(QRect(QPoint(), size));
    plot.toPainter(&painter, size.width(), size.height());
    return painter.end();
}

} // namespace

bool savePlot(QCustomPlot &plot, const QSize &size, const QString &path, QString *error) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("png"))
        return savePicture(plot.toPixmap(size.width(), size.height(), kPictureScale).toImage(), path, error);
    if (suffix == QLatin1String("pdf"))
        return replaceFile(
            path, [&](QIODevice &file) { return drawPdf(plot, size, file); }, error);
    *error = QObject::tr("%1: expected a name that ends in .csv, .png or .pdf").arg(path);
    return false;
}

} // namespace inspector::ui
