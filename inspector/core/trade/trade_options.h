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
    QString schedule = QStringLiteral("autopilot"); // or random:SEED or a file
    std::vector<double> stepSizes = usualStepSizes();
    Length under;                  // the error to keep
    std::optional<double> seconds; // for so long; the whole comparison without
    std::optional<double> within;  // ns: instead, the most accurate of steps this cheap
    QString plot;                  // file; empty: none
};

inline constexpr double kTradeDuration = 20.0; // s, simulated, unless asked otherwise

// 1mm, 0.5um, 0.001m or 0.1R: greater than 0.
std::optional<Length> parseLength(const QString &text);

// Step sizes separated by commas, 1e-6 to 10 s each: 0.01, 5ms or 1/60. A + before the first adds them to the usual
// ones. Empty if one of them is wrong.
std::vector<double> parseStepSizes(const QString &text);

// What the words name; nothing in `switches` and one line in `error` if that can't be had.
TiltSchedule makeSchedule(const QString &words, const Registry &registry, const Scene &scene, const Inputs &inputs,
                          double duration, QString *error);

} // namespace inspector
