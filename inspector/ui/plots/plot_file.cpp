// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_file.h"

#include "core/setup/files.h"
#include "ui/files/picture_file.h"

#include <QFileInfo>
#include <QImage>
#include <QPdfWriter>
#include <qcustomplot.h>

namespace inspector::ui {

namespace {

constexpr double kPictureScale = 2.0; ///< pixels per screen pixel, for print

QImage pictureOf(const std::vector<PlacedPlot> &plots, const QSize &size) {
    QImage picture(size * kPictureScale, QImage::Format_RGB32);
    picture.fill(plots.front().plot.palette().color(QPalette::Base));
    QPainter painter(&picture);
    for (const auto &[plot, place] : plots)
        painter.drawPixmap(place.topLeft() * kPictureScale,
                           plot.toPixmap(place.width(), place.height(), kPictureScale));
    return picture;
}

/// QCustomPlot::savePdf() doesn't report write errors.
bool drawPdf(const std::vector<PlacedPlot> &plots, const QSize &size, QIODevice &file) {
    QPdfWriter pdf(&file);
    pdf.setResolution(plots.front().plot.logicalDpiY()); // at which texts have the size that they have on the screen
    pdf.setPageLayout({QPageSize(QSizeF(size), QPageSize::Point), QPageLayout::Portrait, {}});
    QCPPainter painter;
    if (!painter.begin(&pdf)) return false;
    painter.setMode(QCPPainter::pmVectorized);
    painter.setWindow(QRect(QPoint(), size));
    for (const auto &[plot, place] : plots) {
        painter.save();
        painter.translate(place.topLeft());
        plot.toPainter(&painter, place.width(), place.height());
        painter.restore();
    }
    return painter.end();
}

} // namespace

bool savePlots(const std::vector<PlacedPlot> &plots, const QSize &size, const QString &path, QString *error) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("png")) return savePicture(pictureOf(plots, size), path, error);
    if (suffix == QLatin1String("pdf"))
        return replaceFile(
            path, [&](QIODevice &file) { return drawPdf(plots, size, file); }, error);
    *error = QObject::tr("%1: expected a name that ends in .csv, .png or .pdf").arg(path);
    return false;
}

bool savePlot(QCustomPlot &plot, const QSize &size, const QString &path, QString *error) {
    return savePlots({{plot, QRect(QPoint(), size)}}, size, path, error);
}

} // namespace inspector::ui
