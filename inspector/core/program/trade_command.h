// SPDX-License-Identifier: GPL-3.0-or-later
// The trade of a level on the command line: table and recommendation to one stream, progress and problems to another.
#pragma once

#include "core/program/options.h"
#include "core/trade/trade_chart.h"

#include <QTextStream>

#include <functional>

namespace inspector {

struct TradeStreams {
    QTextStream &out;
    QTextStream &messages;
    QTextStream *progress; // a terminal, or nullptr
};

// Draws a result's chart into a file other than SVG; one line in the error if it can't.
using TradePictureWriter = std::function<bool(const ChartDescription &, const QString &path, QString *error)>;

// A setting and why, in one line: what --trade ends with and the window shows.
struct Recommendation {
    std::optional<TradePoint> point; // nothing if no setting does
    QString line;
    double seconds = 0.0; // for which it holds
};
Recommendation recommend(const TradeResult &result, uint32_t model, const TradeOptions &wish, double radius);
// The cheapest that is good enough for what is known; the plan has unknowns.
Recommendation recommendForUnknowns(const TradePlan &plan, const TradeResult &result);

// The program's exit status: 0; 1 if no setting does what was asked or a file can't be written; 2 if something asked
// for can't be opened or measured.
int runTrade(const Options &options, const TradeStreams &streams, const TradePictureWriter &writePicture);

} // namespace inspector
