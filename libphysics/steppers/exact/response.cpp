// SPDX-License-Identifier: MIT
#include "exact/response.h"

#include "contact/held.h"

#include <algorithm>

namespace phys {

namespace {

/// Whether a contact is straight along a line and across it.
bool isStraight(const Held &held, const Vec3 &line, double rounding) {
    return glm::length(held.across * line) <= rounding;
}

/// The force of a slipping contact per N. False for another one, and for a slip that all but ends: its direction may be
/// rounding.
bool pushOf(const Motion &motion, const Held &held, const MovingBall &ball, Vec3 &push) {
    const Moment moment = ball.moment();
    const Vec3 slip = slipAt(motion, held.normal, moment.radius);
    const bool ends = glm::length(slip) <= kSlipEnds * speedScale(moment);
    if (held.isGlued || (held.friction > 0.0 && ends)) return false;
    push = held.normal - held.friction * hat(slip);
    return true;
}

bool areCoplanar(const Vec3 &a, const Vec3 &b, const Vec3 &c, double rounding) {
    return std::abs(glm::dot(c, glm::cross(a, b))) <= rounding;
}

double sumOf(const std::array<double, 4> &parts) { return parts[0] + parts[1] + parts[2]; }

/// Of the sum of N: the direction of a slip with few digits has few digits itself, and where two pushes are nearly
/// opposite it takes much of them to balance little.
double roundingOf(const Exchange &exchange, const Motion &motion, const Touching &touching, const MovingBall &ball) {
    constexpr double kSame = 2e-12, kDirection = 16.0 * 0x1p-52;
    double angle = 0.0; // the largest of the sets that may carry the load, so that it is the same for each of them
    for (size_t i = 0; i < exchange.count; ++i) angle = std::max(angle, std::abs(exchange.shares[i]));
    angle *= std::abs(exchange.determinant(exchange.pushes[0], exchange.pushes[1], exchange.pushes[2]));
    double rounding = kSame * accelerationScale(ball.moment()) / std::min(1.0, angle);
    for (size_t i = 0; i < exchange.count; ++i) {
        const Held &held = touching.held(exchange.contacts[i]);
        if (held.friction == 0.0) continue;
        const Vec3 slip = slipAt(motion, held.normal, ball.radius());
        const double force = held.friction * std::abs(exchange.shares[i]) * exchange.most;
        const double turn = kDirection * speedScale(ball.moment()) / glm::length(slip);
        rounding += force * turn * std::abs(sumOf(exchange.balanced(glm::cross(held.normal, hat(slip)))));
    }
    return rounding;
}

/// Rate of change of the sum of shares under these accelerations, 1/s.
double rateOf(const Exchange &exchange, const MovingBall &ball, const Touching &touching, const Vec3 &acceleration,
              const Vec3 &spinAcceleration) {
    Vec3 all(0.0);
    for (size_t i = 0; i < exchange.count; ++i) {
        const Held &held = touching.held(exchange.contacts[i]);
        if (held.friction == 0.0) continue;
        const Vec3 slip = slipAt(ball.moment(), held.normal), d = hat(slip);
        const Vec3 rate = acceleration - ball.radius() * glm::cross(spinAcceleration, held.normal);
        all -= exchange.shares[i] * held.friction / glm::length(slip) * (rate - glm::dot(rate, d) * d);
    }
    return sumOf(exchange.balanced(all));
}

void takeJammed(const Moment &jammed, const Touching &touching, MovingBall &ball, Response &response) {
    const Motion before = ball.motion;
    ball.motion = {jammed.velocity, jammed.spin};
    ball.report.lostSlip(kineticEnergy(before, ball.radius()) - kineticEnergy(ball.motion, ball.radius()));
    response = respond(ball.moment(), touching.held(), ball.work);
}

} // namespace

phys_status jam(const Touching &touching, MovingBall &ball, Response &response) {
    Moment jammed = ball.moment();
    response.isFound = false;
    if (endSlips(jammed, touching.held(), ball.work)) takeJammed(jammed, touching, ball, response);
    if (!response.isFound) {
        stopSlips(jammed, touching.held(), ball.work);
        takeJammed(jammed, touching, ball, response);
    }
    if (response.isFound) return PHYS_OK;
    if (const phys_status status = ball.checkWork()) return status;
    return fail(ball.error, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) is jammed by friction", ball.position.x,
                ball.position.y, ball.position.z);
}

phys_status respondNow(const Touching &touching, MovingBall &ball, Response &response) {
    response = respond(ball.moment(), touching.held(), ball.work);
    if (const phys_status status = ball.checkWork()) return status;
    return response.isFound ? PHYS_OK : jam(touching, ball, response);
}

bool findExchange(const Motion &motion, const Touching &touching, const Response &response, const MovingBall &ball,
                  Exchange &exchange) {
    const double rounding = 4.0 * ball.moment().rounding, noForce = kFits * accelerationScale(ball.moment());
    uint32_t pressing = 0;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (response.reactions[i].mode == Mode::sticking || response.reactions[i].mode == Mode::starting) return false;
        if (response.reactions[i].pressure <= noForce) continue;
        if (pressing == 3 || !pushOf(motion, touching.held(i), ball, exchange.pushes[pressing])) return false;
        exchange.contacts[pressing++] = i;
    }
    if (pressing < 2) return false;
    const auto normal = [&](size_t i) { return touching.held(exchange.contacts[i]).normal; };
    exchange.count = pressing + 1;
    exchange.line = pressing == 2 ? hat(glm::cross(normal(0), normal(1))) : Vec3(0.0);
    if (pressing == 3 && areCoplanar(normal(0), normal(1), normal(2), rounding)) return false;
    if (exchange.determinant(exchange.pushes[0], exchange.pushes[1], exchange.pushes[2]) == 0.0) return false;
    const auto isStraightAlong = [&](uint32_t i) { return isStraight(touching.held(i), exchange.line, rounding); };
    if (!isStraightAlong(exchange.contacts[0]) || !isStraightAlong(exchange.contacts[1])) return false;
    bool isFound = false;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Held &held = touching.held(i);
        if (response.reactions[i].pressure > noForce || !isStraightAlong(i)) continue;
        if (std::abs(glm::dot(held.normal, exchange.line)) > rounding) continue;
        bool isOpposite = false; // a squeeze of both moves nothing
        for (size_t k = 0; k < pressing; ++k) isOpposite = isOpposite || held.normal == -normal(k);
        Vec3 push;
        if (isOpposite || !pushOf(motion, held, ball, push)) continue;
        std::array<double, 4> shares = exchange.balanced(push);
        double most = kNever, sum = 1.0;
        size_t leaving = 0;
        for (size_t k = 0; k < pressing; ++k) {
            sum += shares[k];
            const double pressure = response.reactions[exchange.contacts[k]].pressure;
            if (!(shares[k] < 0.0) || pressure / -shares[k] >= most) continue;
            most = pressure / -shares[k];
            leaving = k;
        }
        shares[pressing] = 1.0;
        if (most == kNever || (isFound && most * sum >= exchange.more)) continue;
        if (pressing == 3 && areCoplanar(held.normal, normal((leaving + 1) % 3), normal((leaving + 2) % 3), rounding)) {
            continue; // they would let the ball go the way of the third one
        }
        isFound = true;
        exchange.contacts[pressing] = i;
        exchange.pushes[pressing] = push;
        exchange.shares = shares;
        exchange.most = most;
        exchange.more = most * sum;
        exchange.rounding = roundingOf(exchange, motion, touching, ball);
    }
    return isFound;
}

void balance(const MovingBall &ball, const Touching &touching, Response &response) {
    Exchange exchange;
    if (touching.count() < 3 || !findExchange(ball.motion, touching, response, ball, exchange)) return;
    if (std::abs(exchange.more) > 2.0 * exchange.rounding) return;
    Vec3 pushed(0.0), turned(0.0);
    for (size_t i = 0; i < exchange.count; ++i) {
        pushed += exchange.most * exchange.shares[i] * exchange.pushes[i];
        turned -= kInertia / ball.radius() * exchange.most * exchange.shares[i] *
                  glm::cross(touching.held(exchange.contacts[i]).normal, exchange.pushes[i]);
    }
    pushed = glm::dot(pushed, exchange.line) * exchange.line;
    const Vec3 a = response.acceleration, turning = response.spinAcceleration;
    const double here = rateOf(exchange, ball, touching, a, turning);
    const double there = rateOf(exchange, ball, touching, a + pushed, turning + turned);
    if (here >= 0.0) return;
    const double share = there <= 0.0 ? 1.0 : here / (here - there);
    for (size_t i = 0; i < exchange.count; ++i) {
        Reaction &reaction = response.reactions[exchange.contacts[i]];
        const Held &held = touching.held(exchange.contacts[i]);
        reaction.mode = held.friction > 0.0 ? Mode::slipping : Mode::smooth;
        reaction.direction = hat(reaction.slip);
        const double pressure = reaction.pressure + share * exchange.most * exchange.shares[i];
        reaction.pressure = pressure > kFits * exchange.most ? pressure : 0.0;
        reaction.force = reaction.pressure * exchange.pushes[i];
    }
    response.acceleration += share * pushed;
    response.spinAcceleration += share * turned;
}

uint32_t closedContacts(const Touching &touching, const Response &response) {
    uint32_t bits = 0;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        bits |= (isClosed(response, i) ? 1U : 0U) << touching.numberOf(i);
    }
    return bits;
}

uint32_t countSticking(const Response &response) {
    uint32_t count = 0;
    for (const Reaction &reaction : response.list()) count += reaction.mode == Mode::sticking ? 1 : 0;
    return count;
}

bool mayPivot(uint32_t at, const Touching &touching, const Response &response) {
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const bool sticks = i != at && response.reactions[i].mode == Mode::sticking;
        if (sticks && touching.held(i).normal != -touching.held(at).normal) return false;
    }
    return true;
}

bool rests(const MovingBall &ball, const Response &response) {
    if (ball.motion.velocity != Vec3(0.0)) return false;
    if (glm::length(response.acceleration) > response.noise) return false;
    if (glm::length(response.spinAcceleration) * ball.radius() > response.noise) return false;
    for (const Reaction &reaction : response.list()) {
        if (reaction.mode == Mode::slipping || reaction.mode == Mode::starting) return false;
    }
    return true;
}

} // namespace phys
