// SPDX-License-Identifier: GPL-3.0-or-later
// A fit in words and numbers, for people and for tables.
#pragma once

#include "core/track/track_fit.h"

#include <QByteArray>
#include <QStringList>

namespace inspector {

// 0.00213 ± 0.00004, in people's units; "not determined: no wall is hit" if so.
QString numbersText(const FittedValue &value);
// The same with its unit.
QString valueText(const FittedValue &value);

// Which model it takes, and where the residuals are if none does.
QString verdictText(const TrackFit &fit);

// What a track is, which of its rows were left out, and how much of it lies beside the board: lines for people.
QStringList trackReport(const Track &track, const TrackFrame &frame, const phys_scene *scene);
// The same, the verdict, correlations, bounces, residuals; for where a table shows the values.
QStringList fitSummary(const FitPlan &plan, const TrackFit &fit);
// That with the values and their intervals.
QStringList fitReport(const FitPlan &plan, const TrackFit &fit);

// The values as options of the command line; those that the track doesn't determine are left out.
QString fitOptions(const ModelFit &fit);

// A row per point: time, measured and computed position, residuals. The header is the first line.
QByteArray fitCsv(const ModelFit &fit);

} // namespace inspector
