// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace inspector::ui {

/// A unit as typeset: a degree sign for deg, raised powers.
QString printedUnit(const QString &unit);

} // namespace inspector::ui
