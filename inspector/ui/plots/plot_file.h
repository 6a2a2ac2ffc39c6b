// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>

class QCustomPlot;

namespace inspector::ui {

constexpr double kPictureScale = 2.0; // pixels per pixel of the screen, for print

// Writes a plot of that size, in pixels of the screen, as what the name's ending says, .png or .pdf; whole, or it
// leaves what there was. False and one line in `error` if it can't.
bool savePlot(QCustomPlot &plot, const QSize &size, const QString &path, QString *error);

} // namespace inspector::ui
