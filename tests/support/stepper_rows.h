// SPDX-License-Identifier: MIT
// Data rows over the built-in steppers, so that a new stepper of the registry is included in every suite.
#pragma once

#include <physics/physics.h>

#include <QByteArray>
#include <QByteArrayList>

namespace support {

/// Ids of all built-in steppers, from crude to exact.
QByteArrayList stepperIds();

/// Whether the stepper has a parameter row of its own with this id.
bool hasOwnRow(const QByteArray &stepper, const char *row);

/// Steppers of fixed substeps with the overlap collision (model.md 10): those with the row as_reported.
QByteArrayList discreteStepperIds();

/// Steppers of second order or higher between impacts, and those with no error but rounding: orders.h.
QByteArrayList higherOrderStepperIds();

/// "rolling" or "rigid".
QByteArray modelName(uint32_t model);

/// Column `stepper` (QByteArray) and one row for each built-in stepper.
void addStepperRows();

/// Columns `stepper` (QByteArray) and `model` (uint32_t) and one row for each pair.
void addStepperAndModelRows();

} // namespace support
