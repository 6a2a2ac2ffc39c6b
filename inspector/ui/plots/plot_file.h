// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>

class QCustomPlot;

namespace inspector::ui {

constexpr double kPictureScale = 2.0; ///< pixels per screen pixel, for print

/// Writes a plot of this size, in screen pixels, as .png or .pdf by the name's suffix; whole or not at all. Returns
/// false, with one line in `error`, on failure.
bool savePlot(QCustomPlot &plot, const QSize &size, const QString &path, QString *error);

} // namespace inspector::ui
