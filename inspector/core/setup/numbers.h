// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people write them: 0.01, 1e-3, 0,9, 1/60, 5 ms, 90 deg. The one place that reads them, for the command
// line and for every box of the window; the same in every locale.
#pragma once

#include <QString>

#include <limits>
#include <optional>
#include <vector>

namespace inspector {

// Which numbers a place takes.
struct NumberRange {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    QString unit = {}; // of min, max, the result, and of a number that is written without a unit
};

struct NumberReading {
    std::optional<double> value; // finite, min .. max
    QString problem;             // without a value: "expected a number from 0 to 1 m/s, found 'fast'"
};

// A decimal number or the quotient of two, with a decimal point or comma, then a unit or none. Units of one kind are
// converted: ns us ms s min; um mm cm m; deg rad; mm/s cm/s m/s. A range without a unit takes none. What can be meant
// in two ways (1,000) is refused.
NumberReading readNumber(const QString &text, const NumberRange &range);

// The same for a whole number.
NumberReading readWholeNumber(const QString &text, const NumberRange &range);

// A duration, in seconds like min and max. unit: of a number without one; but 1/60 is a sixtieth of a second
// everywhere.
NumberReading readDuration(const QString &text, double min, double max, const QString &unit = QStringLiteral("s"));

// The shortest text that readDuration() reads as this number of seconds: "5 ms", "1/60 s".
QString durationText(double seconds);

// Step sizes that are offered and measured unless others are asked for, s; from the largest to the smallest.
const std::vector<double> &usualStepSizes();

} // namespace inspector
