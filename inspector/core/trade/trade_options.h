// SPDX-License-Identifier: GPL-3.0-or-later
// What a person may say about a measurement of the trade, in words.
#pragma once

#include "core/trade/trade.h"

namespace inspector {

// A length in metres or in radii of the ball.
struct Length {
    double value = 0.001;
    bool isInRadii = false;
    double inRadii(double radius) const { return isInRadii ? value : value / radius; }
};

struct TradeOptions {
    QString schedule = QStringLiteral("both"); // see makeSchedules()
    std::vector<double> stepSizes = usualStepSizes();
    Length under;                  // the error to keep
    std::optional<double> seconds; // for so long; the whole comparison without
    std::optional<double> within;  // ns: instead, the most accurate of steps this cheap
    Unknowns unknowns;             // of the board
    double share = 0.25;           // of what isn't known, that an error may be
    bool withOrientation = false;
    QString plot; // file; empty: none
};

inline constexpr double kTradeDuration = 20.0; // s, simulated, unless asked otherwise
inline constexpr double kTradeHorizon = 1.0;   // s that the answer for the unknowns looks ahead, unless asked otherwise

// 1mm, 0.5um, 0.001m or 0.1R: greater than 0.
std::optional<Length> parseLength(const QString &text);

// Step sizes separated by commas, 1e-6 to 10 s each: 0.01, 5ms or 1/60. A + before the first adds them to the usual
// ones. Empty if one of them is wrong.
std::vector<double> parseStepSizes(const QString &text);

// What the words name, into the plan's schedules, with so many validations as its answer needs: "autopilot" (which
// meets hardly a wall), "busy" (random tilts that lead to many), "both" of these (without a way out the second alone),
// "random:SEED", or a file. The plan's other members come first. False and one line in `error` if it can't be had.
bool makeSchedules(const QString &words, double duration, TradePlan &plan, QString *error);

} // namespace inspector
