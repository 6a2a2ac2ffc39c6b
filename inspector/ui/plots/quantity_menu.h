// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/engine/sample.h"

#include <functional>

class QMenu;

namespace inspector::ui {

/// Adds a submenu for each group of quantities, with an entry for each. isChosen: whether it is checked; choose: called
/// when it is triggered.
void addQuantities(QMenu &menu, const std::function<bool(Channel)> &isChosen,
                   const std::function<void(Channel)> &choose);

/// MIME type of a dragged quantity; the data is its id.
inline constexpr char kQuantityMime[] = "application/x-physics-quantity";

} // namespace inspector::ui
