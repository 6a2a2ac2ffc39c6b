// SPDX-License-Identifier: GPL-3.0-or-later
// Reads numbers as people write them: 0.01, 1e-3, 0,9, 1/60, 5 ms, 90 deg. The one parser for the command line and for
// every field of the window; the same in every locale.
#pragma once

#include <QString>

#include <limits>
#include <optional>
#include <vector>

namespace inspector {

/// A unit as people read it, in every text for them: m/s², a degree sign for deg. Files have it as it is typed.
QString printedUnit(const QString &unit);

/// Which numbers are accepted.
struct NumberRange {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    QString unit = {}; ///< of min, max, the result, and of input without a unit
};

struct NumberReading {
    std::optional<double> value; ///< finite, min .. max
    QString problem;             ///< if there is no value: "expected a number from 0 to 1 m/s, found 'fast'"
};

/// A decimal number or a quotient of two, with a decimal point or comma, optionally followed by a unit. Units of one
/// dimension are converted: ns us ms s min; um mm cm m; deg rad; mm/s cm/s m/s. A range without a unit accepts none.
/// Ambiguous input (1,000) is refused.
NumberReading readNumber(const QString &text, const NumberRange &range);

/// The same for a whole number, which is no share of anything: 400% is refused.
NumberReading readWholeNumber(const QString &text, const NumberRange &range);

/// A duration, in seconds like min and max; input without a unit is in seconds.
NumberReading readDuration(const QString &text, double min, double max);

/// A unit of time for texts.
struct TimeUnit {
    double perSecond;
    QString name;
};
/// The unit in which a duration is easy to read: s from 1 s on, ms from 0.1 ms on, µs below.
const TimeUnit &timeUnitFor(double seconds);

/// The shortest text that readDuration() reads as this number of seconds: "5 ms", "1/60 s", "1 µs".
QString durationText(double seconds);

/// The step sizes offered and measured by default, s, from largest to smallest.
const std::vector<double> &usualStepSizes();

} // namespace inspector
