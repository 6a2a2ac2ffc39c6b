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

/// Bits of the contacts (of all, not only lasting ones) that stay closed.
uint32_t closedContacts(const Touching &touching, const Response &response);

/// Of three slipping contacts with normals in one plane two carry the load, of four that leave the ball no way three:
/// those with the smaller sum of N. How it may pass to the other one: model.md 14.1.
struct Exchange {
    uint32_t count = 0;               ///< of contacts: 3 or 4
    std::array<uint32_t, 4> contacts; ///< the last one is relieved
    std::array<Vec3, 4> pushes;       ///< force per N
    std::array<double, 4> shares;     ///< change of N per N of the last one, which is 1
    Vec3 line{0.0};                   ///< along which the ball moves, or 0
    double most = 0.0;                ///< N of the last one when another one is relieved
    double more = 0.0;                ///< the sum of N is larger by this then
    double rounding = 0.0;            ///< of that

    /// Determinant of the pushes of those that carry the load, along the line where these are two.
    double determinant(const Vec3 &a, const Vec3 &b, const Vec3 &c) const {
        return glm::dot(count == 3 ? line : c, glm::cross(a, b));
    }
    /// What balances a force, of those that carry the load.
    std::array<double, 4> balanced(const Vec3 &force) const {
        const Vec3 &a = pushes[0], &b = pushes[1], &c = pushes[2];
        const double all = -determinant(a, b, c);
        std::array<double, 4> parts{determinant(force, b, c) / all, determinant(a, force, c) / all, 0.0, 0.0};
        if (count == 4) parts[2] = determinant(a, b, force) / all;
        return parts;
    }
};

/// False if there are no such contacts, for a ball that moves like this.
bool findExchange(const Motion &motion, const Touching &touching, const Response &response, const MovingBall &ball,
                  Exchange &exchange);

/// If both sets have the same sum, the motion decides: the load is on the set whose sum becomes the smaller one, or, if
/// that is always the other set, on all of them so that the sums remain equal.
void balance(const MovingBall &ball, const Touching &touching, Response &response);

uint32_t countSticking(const Response &response);

/// Whether a ball that sticks at a contact may turn about its normal: nowhere else it sticks, but opposite to it.
bool mayPivot(uint32_t at, const Touching &touching, const Response &response);

/// Whether the ball stays in place.
bool rests(const MovingBall &ball, const Response &response);

} // namespace phys
