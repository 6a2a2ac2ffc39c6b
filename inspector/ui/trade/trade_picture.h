// SPDX-License-Identifier: GPL-3.0-or-later
// Separate from the chart's widget, so that code which only writes pictures needs no header of QCustomPlot.
#pragma once

#include "core/trade/trade_chart.h"

namespace inspector::ui {

/// Writes the chart alone, as .pdf or .png. Needs an application that can draw, but no screen. Returns false, with one
/// line in `error`, if the file can't be written.
bool writeTradePicture(const ChartDescription &chart, const QString &path, QString *error);

} // namespace inspector::ui
