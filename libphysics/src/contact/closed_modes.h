// SPDX-License-Identifier: MIT
// Modes of lasting contacts that need no trying, model.md 14.1: a single contact, smooth ones, and those on a floor.
#pragma once

#include "contact/modes.h"

namespace phys {

/// Only smooth contacts, bits `among`: they push as on a point. False if more than two have to.
bool respondSmooth(const Moment &moment, std::span<const Held> held, uint32_t among, double zero, Response &response);

/// A ball on a floor whose other contacts, bits `among`, are upright and smooth: the floor carries it, the others push
/// in the plane. False if the floor's friction has to be found together with them.
bool respondOnFloor(const Moment &moment, std::span<const Held> held, uint32_t floor, uint32_t among, double zero,
                    Response &response);

/// One contact alone.
Response respondAlone(const Moment &moment, const Held &contact, double zero, Response response);

} // namespace phys
