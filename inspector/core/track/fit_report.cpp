// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/fit_report.h"

#include "core/setup/numbers.h"
#include "core/setup/tables.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

constexpr double kMilli = 1e3;  ///< mm/m
constexpr double kStrong = 0.8; ///< stronger correlations are reported

QString unitText(const QString &unit) { return unit.isEmpty() ? QString() : QLatin1Char(' ') + printedUnit(unit); }

/// Rounded to two significant digits of the interval.
QString rounded(double value, double interval) {
    if (!(interval > 0.0) || !std::isfinite(interval)) return QString::number(value, 'g', 4);
    const int digits = std::clamp(1 - int(std::floor(std::log10(interval))), 0, 9);
    return QString::number(value, 'f', digits);
}

QString nameOf(uint32_t model) { return modelName(model) + QStringLiteral(" model"); }

/// metres: NaN if nothing was compared
QString millimetres(double metres, int digits) {
    return std::isnan(metres) ? QStringLiteral("-")
                              : QString::number(metres * kMilli, 'g', digits) + QStringLiteral(" mm");
}

QString timesText(int count) {
    if (count == 0) return QStringLiteral("never");
    return count == 1 ? QStringLiteral("once") : QStringLiteral("%1 times").arg(count);
}

QString residualText(const ModelFit &fit) {
    return QStringLiteral("residuals %1 within %2 s after a bounce, %3 elsewhere")
        .arg(millimetres(fit.rmsNearBounces, 2))
        .arg(ModelFit::kNear)
        .arg(millimetres(fit.rmsElsewhere, 2));
}

/// How much of the track the computed ball follows.
QString shareText(const TrackFit &fit) {
    const ModelFit &best = fit.best();
    return QStringLiteral("%1 of %2 points, %3 of %4 s")
        .arg(best.residuals.size())
        .arg(fit.points)
        .arg(best.seconds, 0, 'g', 3)
        .arg(fit.duration, 0, 'g', 3);
}

QString besideText(size_t beside, size_t points) {
    return QStringLiteral("%1 of %2 points lie beside the board: are units, frame and level right?")
        .arg(beside)
        .arg(points);
}

QString breaksText(const ModelFit &fit) {
    if (fit.segments.empty()) return QStringLiteral("nowhere like the track");
    if (fit.breaks == 0 && fit.segments.size() == 1) return QStringLiteral("the whole track at once");
    if (fit.breaks == 0)
        return QStringLiteral("in %1 segments, in which computed and measured ball never part")
            .arg(fit.segments.size());
    return QStringLiteral("computed and measured ball part ") + timesText(fit.breaks);
}

/// Where a model doesn't explain the track: at bounces or between them.
QString whereText(const ModelFit &fit, double noise) {
    QString text = residualText(fit);
    if (!fit.bouncesOff(Surface::Wall))
        return text + QStringLiteral("; no wall is hit: what the ball does on the floor is missing");
    const QString parted =
        QStringLiteral("; they part %1, at a wall %2").arg(timesText(fit.breaks), timesText(fit.breaksAtWalls));
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
    if (fit.share < ModelFit::kLeastShare) return lines;
    for (size_t i = 0; i < fit.correlations.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (std::abs(fit.correlations[i][j]) > kStrong)
                lines += QStringLiteral("  %1 and %2 are hard to tell apart: correlation %3")
                             .arg(fit.values[j].quantity.id, fit.values[i].quantity.id)
                             .arg(fit.correlations[i][j], 0, 'f', 2);
    return lines;
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

/// The tilt's offset isn't the parameter of that name, which the table's tilts replace.
bool isParameter(const FitQuantity &quantity) {
    return !quantity.id.startsWith(QLatin1String("tilt")) && Parameters().indexOf(quantity.id) >= 0;
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
    const QString residual = QStringLiteral("residuals %1 are the tracker's noise (%2) on %3")
                                 .arg(millimetres(best.rms, 3), millimetres(fit.noise, 3), shareText(fit));
    switch (fit.verdict) {
    case FitVerdict::RollingSuffices:
        return QStringLiteral("the rolling model suffices: ") + residual;
    case FitVerdict::RigidNeeded:
        return fit.fits.size() == 1 ? QStringLiteral("the rigid model fits: ") + residual
                                    : QStringLiteral("the rigid model is needed: %1; with rolling, %2")
                                          .arg(residual, breaksText(fit.fits.front()));
    case FitVerdict::Undetermined:
        return QStringLiteral("none: the track determines nothing that is looked for, though the %1 goes with it: %2")
            .arg(nameOf(best.model), residual);
    case FitVerdict::Neither:
        break;
    }
    const QString who = fit.fits.size() == 1 ? QStringLiteral("the %1 doesn't explain").arg(nameOf(best.model))
                                             : QStringLiteral("neither model explains");
    if (2 * fit.beside > fit.points)
        return QStringLiteral("%1 the track on this maze: %2").arg(who, besideText(fit.beside, fit.points));
    if (best.share < ModelFit::kLeastShare)
        return QStringLiteral("%1 the track on this maze: the ball is like it on no more than %2; is the level right?")
            .arg(who, shareText(fit));
    return QStringLiteral("%1 the track: residuals %2, noise %3, on %4; %5")
        .arg(who, millimetres(best.rms, 3), millimetres(fit.noise, 3), shareText(fit), whereText(best, fit.noise));
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
    constexpr double kManyBeside = 0.1; // of the points
    const size_t beside = pointsBeside(track, frame, scene);
    if (double(beside) > kManyBeside * double(track.points.size()))
        lines += QStringLiteral("  ") + besideText(beside, track.points.size());
    return lines;
}

QStringList fitSummary(const FitPlan &plan, const TrackFit &fit) { return reportWith({}, plan, fit); }

QStringList fitReport(const FitPlan &plan, const TrackFit &fit) {
    return reportWith(valueLines(fit.best()), plan, fit);
}

std::vector<Setting> fittedSettings(const TrackFit &fit) {
    if (!fit.isExplained()) return {};
    const ModelFit &best = fit.best();
    std::vector<Setting> settings{{QStringLiteral("model"), double(best.model)}};
    for (const FittedValue &value : best.values)
        if (value.isDetermined() && isParameter(value.quantity))
            settings.push_back({value.quantity.id, value.value / value.quantity.perUnit});
    return settings;
}

QString fitOptions(const TrackFit &fit) {
    if (!fit.isExplained()) return QStringLiteral("none");
    const ModelFit &best = fit.best();
    QStringList words{QStringLiteral("--model %1").arg(modelName(best.model))};
    QStringList others;
    for (const FittedValue &value : best.values) {
        if (!value.isDetermined()) continue;
        const QString number = QString::number(value.value / value.quantity.perUnit, 'g', 6);
        QString id = value.quantity.id;
        if (isParameter(value.quantity))
            words += QStringLiteral("--%1 %2").arg(id.replace(QLatin1Char('_'), QLatin1Char('-')), number);
        else
            others += id + QLatin1Char(' ') + number + unitText(value.quantity.unit);
    }
    const QString line = words.join(QLatin1Char(' '));
    return others.isEmpty() ? line : line + QStringLiteral("  # and ") + others.join(QStringLiteral(", "));
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
