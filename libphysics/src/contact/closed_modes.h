// SPDX-License-Identifier: MIT
// Modes of lasting contacts that are found in closed form, model.md 14.1: a single contact, smooth ones, and those on a
// floor.
#pragma once

#include "contact/modes.h"

namespace phys {

/// Only smooth contacts, bits `among`: they act as on a point mass. False if more than three of them have to push.
bool respondSmooth(const Moment &moment, std::span<const Held> held, uint32_t among, double zero, Response &response);

/// A ball on a floor whose other contacts, bits `among`, are vertical faces without friction: the floor carries the
/// ball, the others push in its plane. False if the floor's friction depends on their forces.
bool respondOnFloor(const Moment &moment, std::span<const Held> held, uint32_t floor, uint32_t among, double zero,
                    Response &response);

/// A single contact.
Response respondAlone(const Moment &moment, const Held &contact, double zero, Response response);

} // namespace phys
