// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/printed_unit.h"

namespace inspector::ui {

QString printedUnit(const QString &unit) {
    if (unit == QLatin1String("deg")) return QStringLiteral("°");
    if (unit == QLatin1String("us")) return QStringLiteral("µs");
    QString printed = unit;
    return printed.replace(QLatin1String("^2"), QStringLiteral("²")).replace(QLatin1Char('*'), QStringLiteral("·"));
}

} // namespace inspector::ui
