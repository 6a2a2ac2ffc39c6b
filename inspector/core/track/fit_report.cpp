// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/fit_report.h"

#include "core/setup/tables.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

constexpr double kMilli = 1e3;  ///< mm/m
constexpr double kStrong = 0.8; ///< stronger correlations are reported

QString unitText(const QString &unit) { return unit.isEmpty() ? QString() : QLatin1Char(' ') + unit; }

/// Rounded to two significant digits of the interval.
QString rounded(double value, double interval) {
    if (!(interval > 0.0) || !std::isfinite(interval)) return QString::number(value, 'g', 4);
    const int digits = std::clamp(1 - int(std::floor(std::log10(interval))), 0, 9);
    return QString::number(value, 'f', digits);
}

QString nameOf(uint32_t model) { return modelName(model) + QStringLiteral(" model"); }

QString residualText(const ModelFit &fit) {
    return QStringLiteral("residuals %1 mm within %2 s after a bounce, %3 mm elsewhere")
        .arg(fit.rmsNearBounces * kMilli, 0, 'g', 2)
        .arg(ModelFit::kNear)
        .arg(fit.rmsElsewhere * kMilli, 0, 'g', 2);
}

QString breaksText(const ModelFit &fit) {
    if (fit.segments.empty()) return QStringLiteral("nowhere like the track");
    if (fit.breaks == 0 && fit.segments.size() == 1) return QStringLiteral("the whole track at once");
    if (fit.breaks == 0)
        return QStringLiteral("in %1 segments, in which computed and measured ball never part")
            .arg(fit.segments.size());
    return QStringLiteral("computed and measured ball part %1 times").arg(fit.breaks);
}

/// Where a model doesn't explain the track: at bounces or between them.
QString whereText(const ModelFit &fit, double noise) {
    QString text = residualText(fit);
    if (!fit.bouncesOff(Surface::Wall))
        return text + QStringLiteral("; no wall is hit: what the ball does on the floor is missing");
    const QString parted =
        QStringLiteral("; %1 of %2 times they part at a wall").arg(fit.breaksAtWalls).arg(fit.breaks);
    if (fit.rmsNearBounces > 2.0 * fit.rmsElsewhere || 3 * fit.breaksAtWalls >= 2 * fit.breaks)
        return text + parted +
               QStringLiteral("; what happens at walls is missing (spin, speed-dependent restitution, soft walls)");
    if (fit.rmsElsewhere > 2.0 * noise || fit.breaks > 0)
        return text + parted +
               QStringLiteral("; what happens on the floor is missing (other resistance, uneven board, wrong tilts)");
    return text;
}

int matchedCount(const ModelFit &fit) {
    return int(std::count_if(fit.bounces.begin(), fit.bounces.end(),
                             [](const FittedBounce &bounce) { return bounce.isMatched; }));
}

QStringList valueLines(const ModelFit &fit) {
    qsizetype width = 0;
    for (const FittedValue &value : fit.values) width = std::max(width, value.quantity.id.size());
    QStringList lines;
    for (const FittedValue &value : fit.values)
        lines += QStringLiteral("  %1  %2").arg(value.quantity.id.leftJustified(int(width)), valueText(value));
    return lines;
}

QStringList correlationLines(const ModelFit &fit) {
    QStringList lines;
    for (size_t i = 0; i < fit.values.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (std::abs(fit.correlations[i][j]) > kStrong)
                lines += QStringLiteral("  %1 and %2 are hard to tell apart: correlation %3")
                             .arg(fit.values[j].quantity.id, fit.values[i].quantity.id)
                             .arg(fit.correlations[i][j], 0, 'f', 2);
    return lines;
}

/// Whether too many points lie outside of the board, which the ball leaves only at an exit.
bool isBeside(const Track &track, const TrackFrame &frame, const phys_scene *scene, QString *line) {
    constexpr double kShare = 0.1; // of the points
    phys_box bounds;
    phys_scene_bounds(scene, &bounds);
    const auto isOut = [&](const TrackPoint &point) {
        double x = 0.0;
        double y = 0.0;
        frame.toBoard(point.x, point.y, x, y);
        return x < bounds.min.x || x > bounds.max.x || y < bounds.min.y || y > bounds.max.y;
    };
    const auto count = std::count_if(track.points.begin(), track.points.end(), isOut);
    *line = QStringLiteral("  %1 of %2 points lie beside the board: are units and frame right?")
                .arg(count)
                .arg(track.points.size());
    return double(count) > kShare * double(track.points.size());
}

QStringList reportWith(const QStringList &values, const FitPlan &plan, const TrackFit &fit) {
    const ModelFit &best = fit.best();
    QStringList lines = trackReport(plan.track, best.board.frame, plan.scene.get());
    lines += QStringLiteral("verdict: ") + verdictText(fit);
    lines += nameOf(best.model) + QStringLiteral(": ") + breaksText(best);
    lines += values + correlationLines(best);
    lines += QStringLiteral("bounces: %1 computed, %2 as measured; %3")
                 .arg(best.bounces.size())
                 .arg(matchedCount(best))
                 .arg(residualText(best));
    return lines;
}

} // namespace

QString numbersText(const FittedValue &value) {
    if (!value.isDetermined()) return QStringLiteral("not determined: ") + value.reason;
    const double perUnit = value.quantity.perUnit;
    const double interval = value.halfInterval() / perUnit;
    return QStringLiteral("%1 ± %2").arg(rounded(value.value / perUnit, interval)).arg(interval, 0, 'g', 2);
}

QString valueText(const FittedValue &value) {
    return numbersText(value) + (value.isDetermined() ? unitText(value.quantity.unit) : QString());
}

QString verdictText(const TrackFit &fit) {
    const ModelFit &best = fit.best();
    const QString residual = QStringLiteral("residuals %1 mm are the tracker's noise (%2 mm)")
                                 .arg(best.rms * kMilli, 0, 'g', 3)
                                 .arg(fit.noise * kMilli, 0, 'g', 3);
    switch (fit.verdict) {
    case FitVerdict::RollingSuffices:
        return QStringLiteral("the rolling model suffices: ") + residual;
    case FitVerdict::RigidNeeded:
        return fit.fits.size() == 1 ? QStringLiteral("the rigid model fits: ") + residual
                                    : QStringLiteral("the rigid model is needed: %1; with rolling, %2")
                                          .arg(residual, breaksText(fit.fits.front()));
    case FitVerdict::Neither:
        break;
    }
    const QString who = fit.fits.size() == 1 ? QStringLiteral("the %1 doesn't explain").arg(nameOf(best.model))
                                             : QStringLiteral("neither model explains");
    return QStringLiteral("%1 the track: residuals %2 mm, noise %3 mm; %4")
        .arg(who)
        .arg(best.rms * kMilli, 0, 'g', 3)
        .arg(fit.noise * kMilli, 0, 'g', 3)
        .arg(whereText(best, fit.noise));
}

QStringList trackReport(const Track &track, const TrackFrame &frame, const phys_scene *scene) {
    QStringList lines{
        QStringLiteral("track %1: %2 points in %3 s, %4 Hz, noise %5 mm%6")
            .arg(track.name)
            .arg(track.points.size())
            .arg(track.end() - track.begin(), 0, 'g', 4)
            .arg(1.0 / track.period(), 0, 'g', 4)
            .arg(noiseOf(track) * kMilli, 0, 'g', 2)
            .arg(track.tilts.empty() ? QStringLiteral("; tilts not measured: one is looked for") : QString())};
    for (const QString &remark : track.remarks) lines += QStringLiteral("  ") + remark;
    QString beside;
    if (isBeside(track, frame, scene, &beside)) lines += beside;
    return lines;
}

QStringList fitSummary(const FitPlan &plan, const TrackFit &fit) { return reportWith({}, plan, fit); }

QStringList fitReport(const FitPlan &plan, const TrackFit &fit) {
    return reportWith(valueLines(fit.best()), plan, fit);
}

QString fitOptions(const ModelFit &fit) {
    QStringList words{QStringLiteral("--model %1").arg(modelName(fit.model))};
    for (const FittedValue &value : fit.values) {
        const bool isParameter = value.quantity.unit.isEmpty() && !value.quantity.id.startsWith(QLatin1String("frame"));
        if (value.isDetermined() && isParameter)
            words += QStringLiteral("--%1 %2")
                         .arg(QString(value.quantity.id).replace(QLatin1Char('_'), QLatin1Char('-')))
                         .arg(value.value, 0, 'g', 6);
    }
    return words.join(QLatin1Char(' '));
}

QByteArray fitCsv(const ModelFit &fit) {
    QByteArray csv = "time [s],x [m],y [m],computed_x [m],computed_y [m],residual_x [m],residual_y [m]\n";
    for (const FitResidual &residual : fit.residuals) {
        const TrackPoint &seen = residual.seen;
        const TrackPoint &computed = residual.computed;
        QList<QByteArray> fields;
        for (const double number :
             {seen.time, seen.x, seen.y, computed.x, computed.y, seen.x - computed.x, seen.y - computed.y})
            fields += exactText(number);
        csv += csvLine(fields);
    }
    return csv;
}

} // namespace inspector
