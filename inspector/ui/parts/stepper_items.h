// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/handles.h"

class QComboBox;

namespace inspector::ui {

/// Adds an item for each stepper: name, summary as the tool tip, id (a QByteArray) as the data. Steppers that are there
/// already are skipped.
void addStepperItems(QComboBox &chooser, const Registry &registry);

} // namespace inspector::ui
