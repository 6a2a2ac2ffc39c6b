// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/engine/sample.h"

#include <functional>

class QMenu;

namespace inspector::ui {

// A submenu for each group of quantities, with an entry for each of them. isChosen: whether it is ticked; choose: what
// an entry does.
void addQuantities(QMenu &menu, const std::function<bool(Channel)> &isChosen,
                   const std::function<void(Channel)> &choose);

// What a quantity is dragged as: its id.
inline constexpr char kQuantityMime[] = "application/x-physics-quantity";

} // namespace inspector::ui
