// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/settings_text.h"

#include "core/setup/numbers.h"

#include <QStringList>

namespace inspector::ui {

QString settingsText(const Parameters &parameters, const std::vector<Setting> &settings) {
    QStringList texts;
    for (const Setting &setting : settings) {
        const phys_param_row &row = parameters.row(parameters.indexOf(setting.id));
        texts += QObject::tr("%1 of %2 %3")
                     .arg(QString::fromUtf8(row.label))
                     .arg(setting.value)
                     .arg(printedUnit(QString::fromUtf8(row.unit)))
                     .trimmed();
    }
    return texts.join(QStringLiteral(", "));
}

} // namespace inspector::ui
