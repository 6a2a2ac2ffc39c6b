// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/tables.h"

#include "core/setup/numbers.h"

#include <charconv>

namespace inspector {

namespace {

QString text(const char *words) { return QString::fromUtf8(words); }

QString withUnit(double value, const char *unit) {
    const QString number = QString::number(value);
    return unit[0] ? number + QLatin1Char(' ') + text(unit) : number;
}

} // namespace

QByteArray exactText(double number) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr - digits};
}

QByteArray csvLine(const QList<QByteArray> &fields) {
    return fields.join(fields.contains(QByteArray()) ? QByteArray(",") : QByteArray(", ")) + '\n';
}

QString modelName(uint32_t model) {
    return model == PHYS_MODEL_RIGID ? QStringLiteral("rigid") : QStringLiteral("rolling");
}

QString stepSizeText(double dt) {
    const TimeUnit &unit = timeUnitFor(dt);
    return QStringLiteral("%1 %2").arg(dt * unit.perSecond, 0, 'g', 4).arg(unit.name);
}

const char *programVersion() { return INSPECTOR_VERSION; }

QString versionLine() {
    return QStringLiteral("physics-inspector %1, libphysics %2").arg(text(programVersion()), text(phys_version()));
}

QStringList choicesOf(const phys_param_row &row) {
    if (!(row.flags & PHYS_ROW_CHOICE)) return {};
    return text(row.choices).toLower().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

QString expectedOf(const phys_param_row &row) {
    if (row.flags & PHYS_ROW_CHOICE) return choicesOf(row).join(QStringLiteral(" or "));
    if (row.flags & PHYS_ROW_SWITCH) return QStringLiteral("0 or 1");
    return QStringLiteral("a number from %1 to %2").arg(QString::number(row.min), withUnit(row.max, row.unit));
}

QString stepperTable(const Registry &registry) {
    QString table;
    for (uint32_t i = 0; i < phys_registry_count(registry.get()); ++i) {
        phys_stepper_info info;
        if (phys_registry_info(registry.get(), i, &info) != PHYS_OK) continue;
        table += QStringLiteral("%1  %2, version %3. %4\n")
                     .arg(text(info.id), -17)
                     .arg(text(info.name), text(info.version), text(info.summary));
        if (info.file[0]) table += QStringLiteral("%1  from %2\n").arg(QString(), -17).arg(text(info.file));
        for (uint32_t j = 0; j < info.row_count; ++j)
            table += QStringLiteral("%1  parameter %2\n").arg(QString(), -17).arg(text(info.rows[j]->id));
    }
    return table;
}

QString parameterTable(const std::vector<const phys_param_row *> &rows) {
    QString table;
    for (const phys_param_row *row : rows) {
        const QStringList choices = choicesOf(*row);
        const QString initial =
            choices.isEmpty() ? withUnit(row->initial, row->unit) : choices.value(int(row->initial - row->min));
        table += QStringLiteral("%1  %2, default %3. %4\n")
                     .arg(text(row->id), -17)
                     .arg(expectedOf(*row), initial, text(row->help));
    }
    return table;
}

} // namespace inspector
