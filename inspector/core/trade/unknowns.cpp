// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/unknowns.h"

#include "core/setup/lines.h"
#include "core/setup/numbers.h"
#include "core/setup/parameters.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <span>

namespace inspector {

namespace {

/// A quantity that can be unknown: how its amount is read, and how it varies a board.
struct UnknownQuantity {
    QString id;
    QString unit;
    double largest; ///< amount, in the unit
    double scale;   ///< factor to Unknown::amount
    bool hasShare;  ///< has a value, so that the amount can be a percentage
    std::function<void(SampledBoard &, const Inputs &, const Unknown &, const std::function<double()> &)> vary;
};

constexpr double kLargestStart = 1000.0; ///< mm

double clamped(double value, const phys_param_row &row) { return std::clamp(value, row.min, row.max); }

double deviation(const Unknown &unknown, double value) {
    return unknown.isShare ? unknown.amount * std::abs(value) : unknown.amount;
}

UnknownQuantity quantityOf(const phys_param_row &row) {
    return {
        QString::fromUtf8(row.id),
        QString::fromUtf8(row.unit),
        row.max - row.min,
        1.0,
        true,
        [&row](SampledBoard &board, const Inputs &inputs, const Unknown &unknown, const std::function<double()> &next) {
            const double value = phys_param_get(&inputs.params, &row);
            phys_param_set(&board.params, &row, clamped(value + deviation(unknown, value) * next(), row), nullptr);
        }};
}

std::vector<UnknownQuantity> makeQuantities() {
    using Next = const std::function<double()> &;
    const std::vector<phys_param_row> &ofBoard = boardRows(); // tilt x, tilt y, gravity
    std::vector<UnknownQuantity> result{
        {"tilt", QStringLiteral("deg"), ofBoard[0].max, 1.0, false,
         [](SampledBoard &board, const Inputs &, const Unknown &unknown, Next next) {
             board.tiltOffset.x += radians(unknown.amount) * next();
             board.tiltOffset.y += radians(unknown.amount) * next();
         }},
        {"tilt_x", QStringLiteral("deg"), ofBoard[0].max, 1.0, false,
         [](SampledBoard &board, const Inputs &, const Unknown &unknown, Next next) {
             board.tiltOffset.x += radians(unknown.amount) * next();
         }},
        {"tilt_y", QStringLiteral("deg"), ofBoard[1].max, 1.0, false,
         [](SampledBoard &board, const Inputs &, const Unknown &unknown, Next next) {
             board.tiltOffset.y += radians(unknown.amount) * next();
         }},
        {"start", QStringLiteral("mm"), kLargestStart, 1e-3, false,
         [](SampledBoard &board, const Inputs &, const Unknown &unknown, Next next) {
             board.startOffset.x += unknown.amount * next();
             board.startOffset.y += unknown.amount * next();
         }},
        {"gravity", QStringLiteral("m/s^2"), ofBoard[2].max, 1.0, true,
         [](SampledBoard &board, const Inputs &inputs, const Unknown &unknown, Next next) {
             board.gravity = std::max(0.0, inputs.gravity + deviation(unknown, inputs.gravity) * next());
         }},
    };
    uint32_t count = 0;
    const phys_param_row *rows = phys_param_rows(&count);
    for (const phys_param_row &row : std::span(rows, count))
        if (!(row.flags & (PHYS_ROW_CHOICE | PHYS_ROW_SWITCH | PHYS_ROW_INPUT))) result.push_back(quantityOf(row));
    return result;
}

const std::vector<UnknownQuantity> &quantities() {
    static const std::vector<UnknownQuantity> all = makeQuantities();
    return all;
}

const UnknownQuantity *find(const QString &id) {
    const auto found = std::find_if(quantities().begin(), quantities().end(),
                                    [&](const UnknownQuantity &one) { return one.id == id; });
    return found == quantities().end() ? nullptr : &*found;
}

QString unknownNames() {
    QStringList names;
    for (const UnknownQuantity &one : quantities()) names += one.id;
    return names.join(QStringLiteral(", "));
}

/// Nothing, with one line in `error`, if it can't be read. A share above 100 % would reach beyond 0.
std::optional<Unknown> parseAmount(const UnknownQuantity &quantity, const QString &text, QString *error) {
    const bool isShare = quantity.hasShare && text.endsWith(QLatin1Char('%'));
    const NumberRange range =
        isShare ? NumberRange{0.0, 100.0, QStringLiteral("%")} : NumberRange{0.0, quantity.largest, quantity.unit};
    const NumberReading amount = readNumber(text, range);
    if (amount.value && *amount.value > 0.0)
        return Unknown{quantity.id, isShare ? 0.01 * *amount.value : quantity.scale * *amount.value, isShare};
    const QString orShare = quantity.hasShare ? QStringLiteral(" or %1=10%").arg(quantity.id) : QString();
    *error = amount.value || text.isEmpty() ? QStringLiteral("expected an amount above 0, as %1=0.1%2%3; found %4")
                                                  .arg(quantity.id, quantity.unit, orShare, foundText(text.left(60)))
                                            : quantity.id + QStringLiteral(": ") + amount.problem;
    return std::nullopt;
}

} // namespace

const QString &usualUnknowns() {
    static const QString words = QStringLiteral("tilt=0.1deg,rolling_friction=50%,restitution_wall=0.04,start=0.1mm");
    return words;
}

std::optional<Unknowns> parseUnknowns(const QString &words, QString *error) {
    Unknowns result;
    if (words == QLatin1String("none")) return result;
    for (const QString &word : words.split(QLatin1Char(','))) {
        const QString id = word.section(QLatin1Char('='), 0, 0).trimmed().replace(QLatin1Char('-'), QLatin1Char('_'));
        const UnknownQuantity *quantity = find(id);
        if (!quantity) {
            *error =
                QStringLiteral("expected one of %1, or none; found %2").arg(unknownNames(), foundText(id.left(60)));
            return std::nullopt;
        }
        const std::optional<Unknown> unknown =
            parseAmount(*quantity, word.section(QLatin1Char('='), 1).trimmed(), error);
        if (!unknown) return std::nullopt;
        const bool isDouble =
            std::any_of(result.begin(), result.end(), [&](const Unknown &before) { return before.id == id; });
        if (isDouble) {
            *error = QStringLiteral("'%1' is named twice").arg(id);
            return std::nullopt;
        }
        result.push_back(*unknown);
    }
    return result;
}

QString unknownsText(const Unknowns &unknowns) {
    if (unknowns.empty()) return QStringLiteral("none");
    QStringList words;
    for (const Unknown &unknown : unknowns) {
        const UnknownQuantity &quantity = *find(unknown.id);
        words +=
            unknown.isShare
                ? QStringLiteral("%1=%2%").arg(unknown.id).arg(unknown.amount * 100.0)
                : QStringLiteral("%1=%2%3").arg(unknown.id).arg(unknown.amount / quantity.scale).arg(quantity.unit);
    }
    return words.join(QLatin1Char(','));
}

std::vector<SampledBoard> sampleBoards(const Unknowns &unknowns, const Inputs &inputs, int count, uint64_t seed) {
    std::mt19937_64 numbers(seed);
    // Uniform in -1 .. 1 from the upper 53 bits; the standard's distributions differ between libraries.
    const auto next = [&] { return double(numbers() >> 11) * 0x1p-52 - 1.0; };
    std::vector<SampledBoard> boards;
    for (int i = 0; i < count; ++i) {
        SampledBoard board{inputs.params, inputs.gravity, {}, {}};
        for (const Unknown &unknown : unknowns) find(unknown.id)->vary(board, inputs, unknown, next);
        // The rigid model can't have more rolling resistance than friction.
        if (board.params.model == PHYS_MODEL_RIGID)
            board.params.rolling_friction = std::min(board.params.rolling_friction, board.params.sliding_friction);
        boards.push_back(board);
    }
    return boards;
}

} // namespace inspector
