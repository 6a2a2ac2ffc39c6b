// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/quantity_menu.h"

#include "core/setup/numbers.h"

#include <QMenu>

namespace inspector::ui {

void addQuantities(QMenu &menu, const std::function<bool(Channel)> &isChosen,
                   const std::function<void(Channel)> &choose) {
    QMenu *group = nullptr;
    for (size_t i = 0; i < kChannelCount; ++i) {
        const ChannelInfo &info = channelInfos()[i];
        const QString title = QString::fromUtf8(info.group);
        group = menu.findChild<QMenu *>(title, Qt::FindDirectChildrenOnly);
        if (!group) {
            group = menu.addMenu(title);
            group->setObjectName(title);
        }
        const QString unit = printedUnit(QString::fromUtf8(info.unit));
        const QString label = QString::fromUtf8(info.label);
        QAction *entry = group->addAction(unit.isEmpty() ? label : QStringLiteral("%1 [%2]").arg(label, unit));
        entry->setObjectName(QString::fromUtf8(info.id));
        entry->setCheckable(true);
        entry->setChecked(isChosen(Channel(i)));
        QObject::connect(entry, &QAction::triggered, &menu, [choose, i] { choose(Channel(i)); });
    }
}

} // namespace inspector::ui
