// SPDX-License-Identifier: MIT
#include "exact/first_event.h"

#include "contact/held.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace phys {

namespace {

template<class P>
End ownEnd(const P &phase, const Touching &, const Response &, MovingBall &ball) {
    return phase.end(ball.left, ball.work);
}

End ownEnd(const Uniform &phase, const Touching &touching, const Response &response, MovingBall &ball) {
    End end;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Reaction &reaction = response.reactions[i];
        const Held &held = touching.held(i);
        if (reaction.mode == Mode::slipping && reaction.pressure != 0.0)
            end.cut(phase.endOfSlip(reaction.slip, held.normal, ball.radius(), i));
        if (reaction.mode == Mode::sticking && held.resistance > 0.0) end.cut(phase.endOfRolling(response.rolling, i));
    }
    return end;
}

/// Ends a phase when something begins to hold.
template<class Holds>
void cutWhen(const Holds &holds, double until, End &end) {
    constexpr int kLooks = 4, kHalvings = 40;
    end.cut({firstHolding(holds, until, kLooks, kHalvings), Cause::time, 0});
}

/// The ball's motion at a moment of the phase.
Moment momentAt(const Way &now, const Vec3 &spin, const MovingBall &ball) {
    Moment moment = ball.moment();
    moment.velocity = now.velocity;
    moment.spin = spin;
    return moment;
}

/// Turns a normal to where the phase has led the ball.
void turn(Held &held, const Vec3 &way, double radius) { held.normal = hat(held.normal + held.across * way / radius); }

/// When the load passes to a third contact, whose pair has the smaller sum of N from then on: model.md 14.1.
template<class P>
void cutAtExchange(const P &phase, const Touching &touching, const Response &response, MovingBall &ball, End &end) {
    Exchange exchange;
    if (touching.count() < 3 || !findExchange(ball.motion, touching, response, ball, exchange)) return;
    const double until = std::min(end.after, ball.left);
    const double before = exchange.more;
    const auto isLess = [&](double t) {
        ball.work.add(phase.lookWork());
        const bool isKnown = findExchange({phase.at(t).velocity, phase.spinAt(t)}, touching, response, ball, exchange);
        return isKnown && exchange.more < -std::max(exchange.rounding, -2.0 * before);
    };
    cutWhen(isLess, until, end);
}

bool onlySlips(const Response &response) {
    const std::span<const Reaction> list = response.list();
    return std::all_of(list.begin(), list.end(), [](const Reaction &reaction) {
        return reaction.mode == Mode::open || reaction.mode == Mode::smooth || reaction.mode == Mode::slipping;
    });
}

/// Some contacts: which of those of the phase they are, and as they are at one of its moments.
struct Some {
    std::array<uint32_t, kMostHeld> number;
    std::array<Held, kMostHeld> held;
    uint32_t count = 0;
};

/// The contacts at a moment of the phase, without those that it has left by then.
Some stillHeld(const Way &now, const Touching &touching, const Response &response, const MovingBall &ball) {
    Some some;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        Held one = touching.held(i);
        const double apart = glm::dot(one.normal, response.acceleration) + curvature(ball.moment(), one);
        const bool isLeft = std::abs(glm::dot(one.normal, now.velocity)) > ball.negligibleSpeed();
        if (!isClosed(response, i) && (isLeft || apart > response.noise)) continue;
        turn(one, now.way, ball.radius());
        some.number[some.count] = i;
        some.held[some.count++] = one;
    }
    return some;
}

uint32_t countPressing(const Response &response, double noForce) {
    const std::span<const Reaction> list = response.list();
    return static_cast<uint32_t>(
        std::count_if(list.begin(), list.end(), [&](const Reaction &reaction) { return reaction.pressure > noForce; }));
}

/// Whether the same contacts press, which then do so with the same forces.
bool pressAlike(const Some &some, std::span<const double> pressures, const Response &chosen, double noForce) {
    for (uint32_t i = 0; i < some.count; ++i) {
        const bool presses = pressures[some.number[i]] > noForce;
        if (presses != (chosen.reactions[i].pressure > noForce)) return false;
    }
    return true;
}

/// N of each contact at a moment of the phase.
std::array<double, kMostHeld> pressuresAt(const Series &phase, double t, const Response &) {
    return phase.pressures(t);
}
std::array<double, kMostHeld> pressuresAt(const Uniform &, double, const Response &response) {
    std::array<double, kMostHeld> pressures{};
    for (uint32_t i = 0; i < response.count; ++i) pressures[i] = response.reactions[i].pressure;
    return pressures;
}

bool sharesLoad(const Series &phase) { return phase.sharesLoad(); }
/// Such accelerations are constant if those that press share the load, too; a slip at another contact may turn.
bool sharesLoad(const Uniform &) { return false; }

/// How much larger the sum of N is at a moment of the phase than that of the law's choice then, beyond rounding. most:
/// contacts with pressure of a choice that counts.
template<class P>
double excess(const P &phase, double t, uint32_t most, const Touching &touching, const Response &response,
              MovingBall &ball) {
    constexpr double kSame = 4e-9, kDirection = 16.0 * 0x1p-52;
    ball.work.add(phase.lookWork());
    const Way now = phase.at(t);
    const Moment moment = momentAt(now, phase.spinAt(t), ball);
    const Some some = stillHeld(now, touching, response, ball);
    const Response chosen = respond(moment, {some.held.data(), some.count}, ball.work);
    if (!chosen.isFound || !onlySlips(chosen)) return 0.0;
    const std::array<double, kMostHeld> pressures = pressuresAt(phase, t, response);
    const double noForce = kFits * accelerationScale(moment);
    if (countPressing(chosen, noForce) > most || pressAlike(some, pressures, chosen, noForce)) return 0.0;
    const double present = std::accumulate(pressures.begin(), pressures.end(), 0.0);
    double more = present - kSame * (present + accelerationScale(moment));
    for (const Reaction &reaction : chosen.list()) {
        more -= reaction.pressure;
        if (reaction.mode != Mode::slipping) continue;
        more -= kDirection * glm::length(reaction.force) * speedScale(moment) / glm::length(reaction.slip);
    }
    return more;
}

/// When the law chooses other modes, whose sum of N is smaller from then on: model.md 14.1.
template<class P>
void cutAtChoice(const P &phase, const Touching &touching, const Response &response, MovingBall &ball, End &end) {
    if (touching.count() < 3 || !onlySlips(response) || areUncoupled(touching.held())) return;
    if (sharesLoad(phase)) return;
    Exchange exchange;
    // As many as now are those to which the load may pass, cutAtExchange; fewer let the ball go.
    const bool passes = findExchange(ball.motion, touching, response, ball, exchange);
    const uint32_t most = passes ? exchange.count - 2 : kMostHeld;
    const double before = std::max(0.0, excess(phase, 0.0, most, touching, response, ball));
    const auto isMore = [&](double t) { return excess(phase, t, most, touching, response, ball) > 2.0 * before; };
    cutWhen(isMore, std::min(end.after, ball.left), end);
}

/// Of two contacts at which the ball sticks: the normal acceleration with which it would leave one if only the other
/// one pressed, at a moment of the phase.
template<class P>
double relief(const P &phase, double t, uint32_t leaving, const Touching &touching, MovingBall &ball) {
    ball.work.add(phase.lookWork() + Work::kEquations);
    const Way now = phase.at(t);
    Moment moment = momentAt(now, phase.spinAt(t), ball);
    Held left = touching.held(leaving), other = touching.held(1 - leaving);
    turn(left, now.way, ball.radius());
    turn(other, now.way, ball.radius());
    const Vec3 slip = slipAt(moment, other.normal); // rounding, as it sticks
    moment.velocity -= 2.0 / 7.0 * slip;
    moment.spin += 5.0 / 7.0 / ball.radius() * glm::cross(other.normal, slip);
    const Response alone = respond(moment, {&other, 1}, ball.work);
    return glm::dot(left.normal, alone.acceleration) + curvature(moment, left);
}

/// When a ball that sticks at two contacts could leave one of them, which only friction presses from then on: the other
/// one alone has the smaller sum of N, model.md 14.1.
template<class P>
void cutAtRelief(const P &phase, const Touching &touching, const Response &response, MovingBall &ball, End &end) {
    if (touching.count() != 2 || countSticking(response) != 2) return;
    const double until = std::min(end.after, ball.left), zero = 2.0 * kFits * accelerationScale(ball.moment());
    for (const uint32_t leaving : {0U, 1U}) {
        const auto lets = [&](double t) { return relief(phase, t, leaving, touching, ball) >= 0.0; };
        if (touching.held(1 - leaving).isGlued || relief(phase, 0.0, leaving, touching, ball) >= -zero) continue;
        cutWhen(lets, until, end);
    }
}

/// Whether the ball moves in a level plane, without a floor.
bool staysLevel(const Touching &touching, const Response &response, const MovingBall &ball) {
    if (response.acceleration.z != 0.0 || std::abs(ball.motion.velocity.z) > ball.negligibleSpeed()) return false;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (touching.contactOf(i).isTop && isClosed(response, i)) return false;
    }
    return true;
}

template<class P>
Event firstEvent(const P &phase, const Ground &ground, const Touching &touching, const Response &response,
                 MovingBall &ball) {
    End end{ball.left, Cause::time, 0};
    if constexpr (std::is_same_v<P, Uniform>) {
        if (phase.velocity == Vec3(0.0) && rests(ball, response)) return {end, {}};
    }
    end.cut(ownEnd(phase, touching, response, ball));
    cutAtExchange(phase, touching, response, ball, end);
    if constexpr (std::is_same_v<P, Series> || std::is_same_v<P, Uniform>) {
        cutAtChoice(phase, touching, response, ball, end);
    }
    cutAtRelief(phase, touching, response, ball, end);
    const double acceleration = phase.mostAcceleration();
    const uint32_t closed = closedContacts(touching, response);
    const bool meetsNothing = ground.isOpen(ball, static_cast<uint32_t>(std::popcount(closed)), acceleration);
    if (meetsNothing && ground.keeps(ball, acceleration)) return {end, {}};
    const Outlook around{ball.scene(), ball.position, ball.motion, touching.contacts, ball.work, closed};
    // Near boxes are searched first, as the ends of long faces are usually far away.
    const double length = kFirstWindow * ball.radius(), speed = glm::length(ball.motion.velocity);
    const double soon = meetsNothing ? 0.0 : std::min(end.after, leastTime(length, speed, acceleration));
    double touch = firstTouch(around, phase, 0.0, soon, length);
    Border border;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!isClosed(response, i)) continue;
        cutAtBorder(around, touching.contactOf(i), phase, std::min(end.after, touch), border);
    }
    if (!meetsNothing && staysLevel(touching, response, ball)) {
        cutAtLevelFloor(around, phase, std::min(end.after, touch), length, border);
    }
    end.cut({border.after, Cause::border, 0});
    if (!meetsNothing && touch == kNever) touch = firstTouch(around, phase, soon, end.after, 2.0 * length);
    end.cut({touch, Cause::touch, 0});
    return {end, border};
}

} // namespace

Event firstEvent(const Ground &ground, const Touching &touching, const Choice &choice, MovingBall &ball) {
    return std::visit([&](const auto &phase) { return firstEvent(phase, ground, touching, choice.response, ball); },
                      choice.phase);
}

} // namespace phys
