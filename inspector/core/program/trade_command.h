// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the trade of a level on the command line: table and recommendation go to one stream, progress and problems
// to another.
#pragma once

#include "core/program/options.h"
#include "core/trade/trade_chart.h"

#include <QTextStream>

#include <functional>

namespace inspector {

struct TradeStreams {
    QTextStream &out;
    QTextStream &messages;
    QTextStream *progress; ///< a terminal, or nullptr
};

/// Draws a chart into a file other than SVG; returns false, with one line in `error`, if it can't.
using TradePictureWriter = std::function<bool(const ChartDescription &, const QString &path, QString *error)>;

/// A setting and the reason, in one line: the result of --trade, which the window shows, too.
struct Recommendation {
    std::optional<TradePoint> point; ///< empty if no setting qualifies
    QString line;
    double seconds = 0.0; ///< over which it holds
};
Recommendation recommend(const TradeResult &result, uint32_t model, const TradeOptions &wish, double radius);
/// The cheapest good-enough setting; the plan must have unknowns.
Recommendation recommendForUnknowns(const TradePlan &plan, const TradeResult &result);

/// If no schedule lasts as long as a setting must be good enough; else empty.
QString shortSchedulesText(const TradePlan &plan);

/// Why cheaper settings with small errors in the table aren't the answer, if any were passed over; name: the
/// cheapest's.
QString passedOverText(const GoodEnough &answer, const QString &name);

/// The settings that made a trade's table, one per line: those of the options that concern it, and the plan's.
QByteArray tradeSettings(const Options &options, const TradePlan &plan);

/// Returns the exit status: 0; 1 if no setting meets the request or a file can't be written; 2 if something can't be
/// opened or measured.
int runTrade(const Options &options, const TradeStreams &streams, const TradePictureWriter &writePicture);

} // namespace inspector
