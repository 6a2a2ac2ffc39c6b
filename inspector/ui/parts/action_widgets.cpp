// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/action_widgets.h"

#include <QAction>
#include <QCheckBox>
#include <QToolButton>

namespace inspector::ui {

QToolButton *buttonFor(QAction &action, const QString &prefix) {
    auto *button = new QToolButton;
    button->setObjectName(prefix + action.objectName());
    button->setDefaultAction(&action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QCheckBox *switchFor(QAction &action, const QString &prefix) {
    auto *box = new QCheckBox(action.text());
    box->setObjectName(prefix + action.objectName());
    box->setToolTip(action.toolTip());
    box->setChecked(action.isChecked());
    box->setFocusPolicy(Qt::TabFocus);
    QObject::connect(box, &QCheckBox::clicked, &action, &QAction::trigger);
    QObject::connect(&action, &QAction::toggled, box, &QCheckBox::setChecked);
    return box;
}

} // namespace inspector::ui
