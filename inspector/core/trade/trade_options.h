// SPDX-License-Identifier: GPL-3.0-or-later
// Options of a trade measurement, and their parsers.
#pragma once

#include "core/trade/trade.h"

namespace inspector {

/// A length in metres or in ball radii.
struct Length {
    double value = 0.001;
    bool isInRadii = false;
    double inRadii(double radius) const { return isInRadii ? value : value / radius; }
};

struct TradeOptions {
    QString schedule = QStringLiteral("both"); ///< see makeSchedules()
    std::vector<double> stepSizes = usualStepSizes();
    Length under;                  ///< the tolerance
    std::optional<double> seconds; ///< over which the tolerance must hold; empty: the whole comparison
    std::optional<double> within;  ///< ns: instead of a tolerance, the most accurate step this cheap
    Unknowns unknowns;             ///< of the board
    double share = 0.25;           ///< share of the uncertainty that an error may reach
    bool withOrientation = false;
    QString plot; ///< file; empty: none
};

inline constexpr double kTradeDuration = 20.0; ///< s, simulated; default
inline constexpr double kTradeHorizon = 1.0;   ///< s, default horizon of the answer for the unknowns

/// Parses 1mm, 0.5um, 0.001m or 0.1R; must be greater than 0.
std::optional<Length> parseLength(const QString &text);

/// Parses step sizes separated by commas, 1e-6 to 10 s each: 0.01, 5ms or 1/60. A leading + adds them to the default
/// ones. Empty if one of them is wrong.
std::vector<double> parseStepSizes(const QString &text);

/// Makes the plan's schedules, and sets its number of validations, from words: "autopilot" (meets few walls), "busy"
/// (random tilts with many impacts), "both" of these (only the second if there is no path out), "random:SEED", or a
/// file. The plan's other members must be set before. Returns false, with one line in `error`, if that isn't possible.
bool makeSchedules(const QString &words, double duration, TradePlan &plan, QString *error);

} // namespace inspector
