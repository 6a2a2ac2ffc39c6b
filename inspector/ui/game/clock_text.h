// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cmath>

namespace inspector::ui {

/// Formats seconds as a stopwatch does: 1:23.45
inline QString clockText(double seconds) {
    const auto hundredths = qint64(std::floor(seconds * 100.0 + 1e-6));
    return QStringLiteral("%1:%2.%3")
        .arg(hundredths / 6000)
        .arg(hundredths / 100 % 60, 2, 10, QLatin1Char('0'))
        .arg(hundredths % 100, 2, 10, QLatin1Char('0'));
}

} // namespace inspector::ui
