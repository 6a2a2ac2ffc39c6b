// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/comparison/deviation_text.h"

namespace inspector::ui {

namespace {

constexpr double kMilli = 1e-3;

QString signedText(double value, const char *unit) {
    const QString sign = value > 0.0 ? QStringLiteral("+") : QString();
    return QStringLiteral("%1%2 %3").arg(sign).arg(value / kMilli, 0, 'g', 4).arg(QLatin1String(unit));
}

} // namespace

QString distanceText(double distance, double radius) {
    return QStringLiteral("%1 mm = %2 R").arg(distance / kMilli, 0, 'g', 4).arg(distance / radius, 0, 'g', 3);
}

QString speedDifferenceText(double speed) { return signedText(speed, "mm/s"); }

QString energyDifferenceText(double energy) { return signedText(energy, "mJ/kg"); }

} // namespace inspector::ui
