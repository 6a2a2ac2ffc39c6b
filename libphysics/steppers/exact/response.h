// SPDX-License-Identifier: MIT
// The effect of the present lasting contacts, by the law of contact: model.md 14.1.
#pragma once

#include "exact/touching.h"

namespace phys {

/// Evaluates the law. If no modes fit, friction jams the ball and its slips end at once; PHYS_ERROR_STUCK if none fit
/// afterwards.
phys_status respondNow(const Touching &touching, MovingBall &ball, Response &response);

/// If no modes fit, friction drives the reactions beyond all bounds, which is an impact without a collision. Slips end,
/// within Coulomb's cones if modes fit afterwards.
phys_status jam(const Touching &touching, MovingBall &ball, Response &response);

inline bool isClosed(const Response &response, uint32_t lasting) {
    return response.reactions[lasting].mode != Mode::open;
}

uint32_t countSticking(const Response &response);

/// Whether the ball stays in place.
bool rests(const MovingBall &ball, const Response &response);

} // namespace phys
