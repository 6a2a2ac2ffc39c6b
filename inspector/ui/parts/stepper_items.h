// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/handles.h"

class QComboBox;

namespace inspector::ui {

// An item for each stepper: its name, its summary as the tip, its id (a QByteArray) as the data.
// Those that it has are left out.
void addStepperItems(QComboBox &chooser, const Registry &registry);

} // namespace inspector::ui
