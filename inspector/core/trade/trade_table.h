// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a trade as columns: for the program's table, its CSV and the window's, all from one list.
#pragma once

#include "core/trade/trade.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace inspector {

struct TradeColumn {
    const char *id;    // in CSV, with the unit of a person: position_largest [R]
    const char *label; // for people, short: max error
    const char *unit;  // for people; "" without
    const char *help;
    double scale; // from `value` to the unit
    // In SI or radii; nothing if there is no such figure.
    std::optional<double> (*value)(const TradePoint &point);
    bool isTiming; // differs from run to run; all others don't
};

// Steppers' id, step size and model come before these, the note after them.
const std::vector<TradeColumn> &tradeColumns();

// A figure in its column's unit, to three digits; "–" without one.
QString figureText(const TradeColumn &column, const TradePoint &point);

// What was measured and how far it means something: lines for people.
QStringList tradeSummary(const TradePlan &plan, const TradeResult &result);

// For people, in columns.
QString tradeText(const TradeResult &result);

// The header, a row per point: the shortest numbers that read back exactly.
QByteArray tradeCsv(const TradeResult &result);
QByteArray tradeCsvHeader();

} // namespace inspector
