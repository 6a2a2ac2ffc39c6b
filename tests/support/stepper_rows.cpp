// SPDX-License-Identifier: MIT
#include "stepper_rows.h"

#include "orders.h"

#include <QTest>

#include <cstring>

namespace support {

QByteArrayList stepperIds() {
    QByteArrayList ids;
    for (uint32_t i = 0; i < phys_registry_count(nullptr); ++i) {
        phys_stepper_info info;
        if (phys_registry_info(nullptr, i, &info) == PHYS_OK) ids.append(info.id);
    }
    return ids;
}

bool hasOwnRow(const QByteArray &stepper, const char *row) {
    phys_stepper_info info;
    if (phys_registry_find(nullptr, stepper.constData(), &info, nullptr)) return false;
    for (uint32_t i = 0; i < info.row_count; ++i) {
        if (std::strcmp(info.rows[i]->id, row) == 0) return true;
    }
    return false;
}

QByteArrayList discreteStepperIds() {
    QByteArrayList ids;
    for (const QByteArray &id : stepperIds()) {
        if (hasOwnRow(id, "as_reported")) ids.append(id);
    }
    return ids;
}

QByteArrayList higherOrderStepperIds() {
    QByteArrayList ids;
    for (const QByteArray &id : stepperIds()) {
        if (ordersOf({id.constData(), static_cast<size_t>(id.size())}).smooth != 1) ids.append(id);
    }
    return ids;
}

QByteArray modelName(uint32_t model) { return model == PHYS_MODEL_RIGID ? "rigid" : "rolling"; }

void addStepperRows() {
    QTest::addColumn<QByteArray>("stepper");
    for (const QByteArray &id : stepperIds()) QTest::newRow(id.constData()) << id;
}

void addStepperAndModelRows() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    for (const QByteArray &id : stepperIds()) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            QTest::newRow((id + ", " + modelName(model)).constData()) << id << model;
        }
    }
}

} // namespace support
