// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/numbers.h"

#include "core/setup/inputs.h"
#include "core/setup/lines.h"
#include "core/setup/tables.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace inspector {

namespace {

/// numerator / denominator in the basic unit of its dimension. Both are exact, so that 9 ms is the double nearest to
/// 0.009.
struct Unit {
    const char *name;
    const char *kind;
    double numerator;
    double denominator;
};

constexpr double kSmallestInMilliseconds = 1e-4; ///< s: 0.1 ms, but 50 µs
constexpr double kPi = 3.141592653589793;
constexpr Unit kUnits[] = {
    {"ns", "s", 1, 1e9},      {"us", "s", 1, 1e6},     {"ms", "s", 1, 1e3},     {"s", "s", 1, 1},
    {"min", "s", 60, 1},      {"um", "m", 1, 1e6},     {"mm", "m", 1, 1e3},     {"cm", "m", 1, 1e2},
    {"", "", 1, 1},           {"%", "", 1, 1e2},       {"m", "m", 1, 1},        {"deg", "deg", 1, 1},
    {"rad", "deg", 180, kPi}, {"mm/s", "m/s", 1, 1e3}, {"cm/s", "m/s", 1, 1e2}, {"m/s", "m/s", 1, 1},
};

const Unit *unitOf(const QString &name) {
    const auto *found = std::find_if(std::begin(kUnits), std::end(kUnits),
                                     [&](const Unit &unit) { return name == QLatin1String(unit.name); });
    return found == std::end(kUnits) ? nullptr : found;
}

/// Normalises the spelling: u for micro, digits for powers.
QString plainUnit(QString unit) {
    unit.replace(QChar(0x00b5), QLatin1Char('u')).replace(QChar(0x03bc), QLatin1Char('u'));
    unit.replace(QChar(0x00b2), QStringLiteral("^2")).replace(QChar(0x00b0), QStringLiteral("deg"));
    return unit;
}

/// A parsed text; the second number follows a slash.
struct Parts {
    QString first, second, unit;
};

std::optional<Parts> partsOf(const QString &text) {
    static const QString number = QStringLiteral("((?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?)");
    static const QRegularExpression whole(QStringLiteral("^([+-]?)") + number + QStringLiteral("(?:\\s*/\\s*") +
                                          number + QStringLiteral(")?(?:\\s*([^\\s0-9.,+/-].*))?$"));
    constexpr qsizetype kLongest = 400; // characters; no number needs more
    const QRegularExpressionMatch match = whole.match(text.left(kLongest + 1));
    if (text.size() > kLongest || !match.hasMatch()) return std::nullopt;
    const QString sign = match.captured(1) == QLatin1String("-") ? QStringLiteral("-") : QString();
    return Parts{sign + match.captured(2), match.captured(3), plainUnit(match.captured(4).trimmed())};
}

/// "1,000" means one where the comma is the decimal mark and a thousand where it groups digits; "0,125" is unambiguous.
bool hasTwoMeanings(const QString &digits) {
    static const QRegularExpression grouped(QStringLiteral("^-?[1-9][0-9]{0,2},[0-9]{3}$"));
    return grouped.match(digits).hasMatch();
}

std::optional<double> doubleOf(QString digits) {
    const QByteArray text = digits.replace(QLatin1Char(','), QLatin1Char('.')).toLatin1();
    double value = 0.0;
    const auto result = std::from_chars(text.constData(), text.constData() + text.size(), value);
    const bool isRead = result.ec == std::errc() && result.ptr == text.constData() + text.size();
    return isRead && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Converts with one multiplication or division: except for rad, both factors are integers.
double converted(double value, const Unit &from, const Unit &to) {
    const double up = from.numerator * to.denominator;
    const double down = from.denominator * to.numerator;
    return up >= down ? value * (up / down) : value / (down / up);
}

/// Degrees of which radians() makes exactly this number again, where there are any; or those of few digits that are
/// equal to it but for rounding.
double degreesOf(double radian) {
    constexpr int kFewDigits = 12;
    const double all = std::numeric_limits<double>::infinity();
    const auto neighbours = [all](double number) {
        return std::array{number, std::nextafter(number, all), std::nextafter(number, -all)};
    };
    const double nearest = degrees(radian);
    const double few = QString::number(nearest, 'g', kFewDigits).toDouble();
    if (std::ranges::count(neighbours(radians(few)), radian)) return few;
    for (const double next : neighbours(nearest))
        if (radians(next) == radian) return next;
    return nearest;
}

/// A number in the wanted unit, or why there is none (may be empty).
struct Amount {
    std::optional<double> value;
    QString why;
};

QString whyNotIn(const QString &wanted) {
    if (wanted.isEmpty()) return QStringLiteral("where no unit belongs");
    const Unit *known = unitOf(wanted);
    if (!known) return QStringLiteral("whose unit isn't ") + printedUnit(wanted);
    QStringList names;
    for (const Unit &unit : kUnits)
        if (*unit.name && qstrcmp(unit.kind, known->kind) == 0) names += QString::fromUtf8(unit.name);
    return QStringLiteral("whose unit isn't one of: ") + names.join(QLatin1Char(' '));
}

Amount inUnit(double value, const QString &unit, const QString &wanted) {
    if (unit == wanted) return {value, {}};
    if (unit == QLatin1String("rad") && wanted == QLatin1String("deg")) return {degreesOf(value), {}};
    const Unit *from = unitOf(unit);
    const Unit *to = unitOf(wanted);
    if (from && to && qstrcmp(from->kind, to->kind) == 0) return {converted(value, *from, *to), {}};
    return {std::nullopt, whyNotIn(wanted)};
}

/// unit: of the result, and of input without one.
Amount amountOf(const Parts &parts, const QString &unit) {
    if (hasTwoMeanings(parts.first) || hasTwoMeanings(parts.second))
        return {std::nullopt, QStringLiteral("which can mean two numbers: write a point, or no comma")};
    const bool isQuotient = !parts.second.isEmpty();
    const std::optional<double> first = doubleOf(parts.first);
    const std::optional<double> second = isQuotient ? doubleOf(parts.second) : std::optional(1.0);
    if (!first || !second) return {std::nullopt, QStringLiteral("which is beyond what a number can hold")};
    if (*second == 0.0) return {std::nullopt, QStringLiteral("which divides by zero")};
    return inUnit(*first / *second, parts.unit.isEmpty() ? unit : parts.unit, unit);
}

bool isNotFinite(QString text) {
    text = text.toLower();
    while (text.startsWith(QLatin1Char('+')) || text.startsWith(QLatin1Char('-'))) text.remove(0, 1);
    return text == QLatin1String("nan") || text == QLatin1String("inf") || text == QLatin1String("infinity");
}

Amount amountOf(QString text, const QString &unit) {
    // A typographic minus, and the kinds of spaces found in copied tables.
    text.replace(QChar(0x2212), QLatin1Char('-'));
    text.replace(QChar(0x00a0), QLatin1Char(' ')).replace(QChar(0x202f), QLatin1Char(' '));
    text = text.trimmed();
    if (isNotFinite(text)) return {std::nullopt, QStringLiteral("which isn't a finite number")};
    const std::optional<Parts> parts = partsOf(text);
    return parts ? amountOf(*parts, unit) : Amount{};
}

QString withUnit(double value, const QString &unit) {
    const QString number = QString::fromLatin1(exactText(value));
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + printedUnit(unit);
}

QString expectedNumber(const NumberRange &range, const QString &what) {
    const bool hasMin = std::isfinite(range.min);
    const bool hasMax = std::isfinite(range.max);
    if (hasMin && hasMax)
        return QStringLiteral("%1 from %2 to %3")
            .arg(what, QString::fromLatin1(exactText(range.min)), withUnit(range.max, range.unit));
    if (hasMin) return QStringLiteral("%1 from %2").arg(what, withUnit(range.min, range.unit));
    if (hasMax) return QStringLiteral("%1 up to %2").arg(what, withUnit(range.max, range.unit));
    return range.unit.isEmpty() ? what : QStringLiteral("%1 in %2").arg(what, printedUnit(range.unit));
}

NumberReading refusal(const QString &expected, const QString &text, const QString &why) {
    const QString line = QStringLiteral("expected %1, found %2").arg(expected, foundText(text));
    return {std::nullopt, why.isEmpty() ? line : line + QStringLiteral(", ") + why};
}

NumberReading within(const NumberRange &range, const Amount &amount, const QString &expected, const QString &text) {
    const bool isThere = amount.value && *amount.value >= range.min && *amount.value <= range.max;
    return isThere ? NumberReading{amount.value, {}} : refusal(expected, text, amount.why);
}

} // namespace

QString printedUnit(const QString &unit) {
    if (unit == QLatin1String("deg")) return QStringLiteral("°");
    if (unit == QLatin1String("us")) return QStringLiteral("µs");
    QString printed = unit;
    return printed.replace(QLatin1String("^2"), QStringLiteral("²")).replace(QLatin1Char('*'), QStringLiteral("·"));
}

NumberReading readNumber(const QString &text, const NumberRange &range) {
    const Amount amount = amountOf(text, range.unit);
    return within(range, amount, expectedNumber(range, QStringLiteral("a number")), text);
}

NumberReading readWholeNumber(const QString &text, const NumberRange &range) {
    const Amount amount = amountOf(text, range.unit);
    const QString expected = expectedNumber(range, QStringLiteral("a whole number"));
    if (text.contains(QLatin1Char('%')))
        return refusal(expected, text, QStringLiteral("which is a share of something"));
    if (amount.value && *amount.value != std::floor(*amount.value)) return refusal(expected, text, {});
    return within(range, amount, expected, text);
}

NumberReading readDuration(const QString &text, double min, double max) {
    const QString seconds = QStringLiteral("s");
    const QString expected = QStringLiteral("a duration from %1 to %2 (as 5 ms or 1/60)")
                                 .arg(withUnit(min, seconds), withUnit(max, seconds));
    return within({min, max, seconds}, amountOf(text, seconds), expected, text);
}

const TimeUnit &timeUnitFor(double seconds) {
    static const TimeUnit units[] = {
        {1.0, QStringLiteral("s")}, {1e3, QStringLiteral("ms")}, {1e6, QStringLiteral("µs")}};
    if (seconds >= 1.0) return units[0];
    return units[seconds >= kSmallestInMilliseconds ? 1 : 2];
}

QString durationText(double seconds) {
    const double rate = std::round(1.0 / seconds);
    const TimeUnit &unit = timeUnitFor(seconds);
    constexpr int kMostDigits = 17; // enough for any double
    constexpr int kFewDigits = 6;   // up to here a decimal is easier to read than a quotient
    const double all = std::numeric_limits<double>::max();
    for (int digits = 1; digits <= kMostDigits; ++digits) {
        if (digits > kFewDigits && 1.0 / rate == seconds) return QStringLiteral("1/%1 s").arg(rate, 0, 'f', 0);
        QString text = QStringLiteral("%1 %2").arg(seconds * unit.perSecond, 0, 'g', digits).arg(unit.name);
        if (text.contains(QLatin1Char('e')) && digits < kFewDigits) continue; // 10 ms, not 1e+01 ms
        if (readDuration(text, -all, all).value == seconds) return text;
    }
    return withUnit(seconds, QStringLiteral("s"));
}

const std::vector<double> &usualStepSizes() {
    static const std::vector<double> sizes{1.0 / 60.0, 0.01, 0.005, 0.002, 0.001, 0.0005, 0.0001};
    return sizes;
}

} // namespace inspector
