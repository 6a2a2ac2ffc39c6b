// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QSize>
#include <QString>

#include <vector>

class QCustomPlot;

namespace inspector::ui {

constexpr QSize kLeastPlotSize(640, 240); ///< screen pixels in a picture, however small the dock: room for all labels

/// A plot of a picture, in screen pixels.
struct PlacedPlot {
    QCustomPlot &plot;
    QRect place;
};

/// Writes a picture of this size, in screen pixels, as .png or .pdf by the name's suffix; whole or not at all. Returns
/// false, with one line in `error`, on failure.
bool savePlots(const std::vector<PlacedPlot> &plots, const QSize &size, const QString &path, QString *error);
/// The same of one plot.
bool savePlot(QCustomPlot &plot, const QSize &size, const QString &path, QString *error);

} // namespace inspector::ui
