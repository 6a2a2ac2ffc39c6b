// SPDX-License-Identifier: GPL-3.0-or-later
// Reports of a fit, as text and as tables.
#pragma once

#include "core/setup/parameters.h"
#include "core/track/track_fit.h"

#include <QByteArray>
#include <QStringList>

namespace inspector {

/// 0.00213 ± 0.00004, in display units, or "not determined: no wall is hit".
QString numbersText(const FittedValue &value);
/// The same with its unit.
QString valueText(const FittedValue &value);

/// States which model explains the track and, if none does, where the residuals are.
QString verdictText(const TrackFit &fit);

/// Describes a track, its skipped rows, and how much of it lies outside of the board: lines for display.
QStringList trackReport(const Track &track, const TrackFrame &frame, const phys_scene *scene);
/// The same with verdict, correlations, bounces and residuals; without the values, for use next to a table of them.
QStringList fitSummary(const FitPlan &plan, const TrackFit &fit);
/// The summary with the values and their intervals.
QStringList fitReport(const FitPlan &plan, const TrackFit &fit);

/// The model and those parameters that the track determines; nothing if no model explains it.
std::vector<Setting> fittedSettings(const TrackFit &fit);
/// The same as command-line options, then as a comment what else was found; "none" if no model explains the track.
QString fitOptions(const TrackFit &fit);

/// One row per point: time, measured and computed position, residuals; with a header line.
QByteArray fitCsv(const ModelFit &fit);

} // namespace inspector
