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

/// Of three slipping contacts with normals in one plane two carry the load, those with the smaller sum of N. How it may
/// pass to the third: model.md 14.1.
struct Exchange {
    std::array<uint32_t, 3> contacts; ///< the last one is relieved
    std::array<Vec3, 3> pushes;       ///< force per N
    std::array<double, 3> shares;     ///< change of N per N of the third, which is 1
    Vec3 line{0.0};                   ///< along which the ball moves
    double most = 0.0;                ///< N of the third when another one is relieved
    double more = 0.0;                ///< the sum of N is larger by this then
    double rounding = 0.0;            ///< of that
};

/// False if there are no such contacts, for a ball that moves like this.
bool findExchange(const Motion &motion, const Touching &touching, const Response &response, const MovingBall &ball,
                  Exchange &exchange);

/// If both pairs have the same sum, the motion decides: the load is on the pair whose sum becomes the smaller one, or,
/// if that is always the other pair, on all three so that the sums remain equal.
void balance(const MovingBall &ball, const Touching &touching, Response &response);

uint32_t countSticking(const Response &response);

/// Whether the ball stays in place.
bool rests(const MovingBall &ball, const Response &response);

} // namespace phys
