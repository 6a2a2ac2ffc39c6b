// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/stepper_items.h"

#include <QComboBox>

namespace inspector::ui {

void addStepperItems(QComboBox &chooser, const Registry &registry) {
    for (uint32_t index = 0; index < phys_registry_count(registry.get()); ++index) {
        phys_stepper_info info;
        if (phys_registry_info(registry.get(), index, &info) != PHYS_OK) continue;
        if (chooser.findData(QByteArray(info.id)) >= 0) continue;
        chooser.addItem(QString::fromUtf8(info.name), QByteArray(info.id));
        chooser.setItemData(chooser.count() - 1, QString::fromUtf8(info.summary), Qt::ToolTipRole);
    }
}

} // namespace inspector::ui
