// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace inspector {

/// Formats a figure of a bounce with four significant digits.
inline QString figureText(double value) { return QString::number(value, 'g', 4); }

/// A speed with its unit; speed: m/s.
inline QString speedText(double speed) { return QStringLiteral("%1 m/s").arg(figureText(speed)); }

} // namespace inspector
