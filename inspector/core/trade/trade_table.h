// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a trade as columns: one list for the program's table, its CSV and the window's table.
#pragma once

#include "core/trade/trade.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace inspector {

struct TradeColumn {
    const char *id;    ///< in CSV, with the display unit: position_largest [R]
    const char *label; ///< for display, short: max error
    const char *unit;  ///< for display; "" without
    const char *help;
    double scale; ///< factor from `value` to the display unit
    /// In SI or radii; nothing if the point has no such figure.
    std::optional<double> (*value)(const TradePoint &point);
    const char *span = ""; ///< of time, where columns beside each other differ; %1: the plan's horizon
};

/// Stepper id, step size and model precede these columns; the note follows them.
const std::vector<TradeColumn> &tradeColumns();

/// A figure in its column's unit, to three digits; "–" without one.
QString figureText(const TradeColumn &column, const TradePoint &point);

/// Describes what was measured and to what extent it is meaningful: lines for display.
QStringList tradeSummary(const TradePlan &plan, const TradeResult &result);

/// "in 1 s [%]": the span of time and the unit, which follow the label in a header.
QString spanAndUnit(const TradeColumn &column, const QString &unit, double horizon);

/// A text table for display.
QString tradeText(const TradePlan &plan, const TradeResult &result);

/// A header and a row per point: the shortest numbers that read back exactly.
QByteArray tradeCsv(const std::vector<TradePoint> &points, char separator = ',');
QByteArray tradeCsvHeader(char separator = ',');

} // namespace inspector
