// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace inspector::ui {

// A unit as it is printed: deg as a degree sign, powers raised.
QString printedUnit(const QString &unit);

} // namespace inspector::ui
