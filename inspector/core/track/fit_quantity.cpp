// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/fit_quantity.h"

#include <QStringList>

#include <algorithm>
#include <span>

namespace inspector {

namespace {

constexpr double kDegree = 0.017453292519943295;

const phys_param_row *rowOf(const char *id) {
    uint32_t count = 0;
    const phys_param_row *rows = phys_param_rows(&count);
    for (const phys_param_row &row : std::span(rows, count))
        if (QLatin1String(row.id) == QLatin1String(id)) return &row;
    return nullptr;
}

/// A coefficient from the library's rows, within the range of its slider.
FitQuantity coefficient(const char *id, double most, double increment, double priorDeviation,
                        std::vector<double> initialGuesses, bool isRigidOnly, double phys_params::*member) {
    const phys_param_row *row = rowOf(id);
    return {QString::fromUtf8(id),
            QString::fromUtf8(row->label),
            QString::fromUtf8(row->unit),
            1.0,
            row->low,
            std::min(row->high, most),
            increment,
            priorDeviation,
            std::move(initialGuesses),
            isRigidOnly,
            [member](BoardParameters &board) -> double & { return board.params.*member; }};
}

} // namespace

std::vector<FitQuantity> fitQuantities() {
    // If no energy were lost, a ball that leans on a wall would never stop bouncing.
    constexpr double kMostRestitution = 0.99;
    constexpr double kMostFriction = 1.0;
    const auto tilt = [](const char *id, const char *label, double Tilt::*axis) {
        return FitQuantity{QString::fromUtf8(id),
                           QString::fromUtf8(label),
                           QStringLiteral("deg"),
                           kDegree,
                           -10.0 * kDegree,
                           10.0 * kDegree,
                           1e-7,
                           3.0 * kDegree,
                           {},
                           false,
                           [axis](BoardParameters &board) -> double & { return board.tiltOffset.*axis; }};
    };
    const auto frame = [](const char *id, const char *label, const char *unit, double perUnit, double lower,
                          double upper, double priorDeviation, double TrackFrame::*member) {
        return FitQuantity{QString::fromUtf8(id),
                           QString::fromUtf8(label),
                           QString::fromUtf8(unit),
                           perUnit,
                           lower,
                           upper,
                           1e-7,
                           priorDeviation,
                           {},
                           false,
                           [member](BoardParameters &board) -> double & { return board.frame.*member; }};
    };
    return {
        coefficient("rolling_friction", kMostFriction, 1e-6, 0.02, {}, false, &phys_params::rolling_friction),
        coefficient("restitution_wall", kMostRestitution, 1e-5, 0.4, {}, false, &phys_params::restitution_wall),
        coefficient("restitution_floor", kMostRestitution, 1e-5, 0.4, {}, false, &phys_params::restitution_floor),
        coefficient("sliding_friction", kMostFriction, 1e-5, 0.4, {}, true, &phys_params::sliding_friction),
        coefficient("wall_friction", kMostFriction, 1e-5, 0.4, {}, true, &phys_params::wall_friction),
        {QStringLiteral("gravity"),
         QStringLiteral("Gravity"),
         QStringLiteral("m/s^2"),
         1.0,
         1.0,
         30.0,
         1e-5,
         1.0,
         {},
         false,
         [](BoardParameters &board) -> double & { return board.gravity; }},
        tilt("tilt_x", "Tilt x offset", &Tilt::x),
        tilt("tilt_y", "Tilt y offset", &Tilt::y),
        {QStringLiteral("delay"),
         QStringLiteral("Delay of the tilt"),
         QStringLiteral("ms"),
         1e-3,
         -0.5,
         0.5,
         1e-6,
         0.2,
         {0.0, 0.1},
         false,
         [](BoardParameters &board) -> double & { return board.delay; }},
        frame("frame_x", "Frame x", "mm", 1e-3, -1.0, 1.0, 0.05, &TrackFrame::x),
        frame("frame_y", "Frame y", "mm", 1e-3, -1.0, 1.0, 0.05, &TrackFrame::y),
        frame("frame_angle", "Frame angle", "deg", kDegree, -4.0, 4.0, 0.2, &TrackFrame::angle),
        frame("frame_scale", "Frame scale", "", 1.0, 0.1, 10.0, 0.1, &TrackFrame::scale),
    };
}

const QString &usualFitQuantities() {
    static const QString words =
        QStringLiteral("rolling_friction,restitution_wall,sliding_friction,wall_friction,tilt,delay");
    return words;
}

std::optional<std::vector<FitQuantity>> parseFitQuantities(const QString &words, QString *error) {
    const std::vector<FitQuantity> all = fitQuantities();
    std::vector<bool> isWanted(all.size(), false);
    for (const QString &word : words.split(QLatin1Char(','))) {
        const QString id = word.trimmed().replace(QLatin1Char('-'), QLatin1Char('_'));
        bool isKnown = false;
        for (size_t i = 0; i < all.size(); ++i) {
            const bool isGroup = (id == QLatin1String("tilt") || id == QLatin1String("frame")) &&
                                 all[i].id.startsWith(id + QLatin1Char('_'));
            if (all[i].id != id && !isGroup) continue;
            if (isWanted[i]) {
                *error = QStringLiteral("'%1' is named twice").arg(all[i].id);
                return std::nullopt;
            }
            isWanted[i] = true;
            isKnown = true;
        }
        if (isKnown) continue;
        QStringList ids;
        for (const FitQuantity &one : all) ids += one.id;
        *error = QStringLiteral("expected some of %1, tilt, frame; found '%2'")
                     .arg(ids.join(QStringLiteral(", ")), id.left(60));
        return std::nullopt;
    }
    std::vector<FitQuantity> result;
    for (size_t i = 0; i < all.size(); ++i)
        if (isWanted[i]) result.push_back(all[i]);
    return result;
}

} // namespace inspector
