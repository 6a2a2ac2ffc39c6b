// SPDX-License-Identifier: MIT
#include "exact/choose.h"

#include "contact/held.h"
#include "exact/build_series.h"
#include "exact/last_bounce.h"
#include "exact/search.h"

#include <cmath>

namespace phys {

namespace {

/// A ball that stays in place can only turn about the normals of its sticking contacts.
void keepFixed(const MovingBall &ball, const Touching &touching, Response &response) {
    if (ball.motion.velocity != Vec3(0.0) || response.acceleration != Vec3(0.0)) return;
    Vec3 &turning = response.spinAcceleration;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Vec3 &n = touching.held(i).normal;
        if (response.reactions[i].mode == Mode::sticking) turning = glm::dot(turning, n) * n;
    }
}

/// The axes along which the ball can move. The accelerations along the normals of a hair crack's edges may be rounding
/// though the ball's isn't: then it rolls over one edge, and the other one, which doesn't press, opens: model.md 14.1.
Vec3 findFree(const MovingBall &ball, const Touching &touching, Response &response) {
    const Vec3 free = freeAxes(ball.moment(), touching.held(), response);
    if (free == Vec3(1.0)) return free;
    const double noise = ball.moment().rounding * accelerationScale(ball.moment());
    if (glm::length(response.acceleration - free * response.acceleration) <= noise) return free;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        Reaction &reaction = response.reactions[i];
        if (reaction.mode == Mode::smooth && reaction.pressure == 0.0) reaction.mode = Mode::open;
    }
    return freeAxes(ball.moment(), touching.held(), response);
}

/// How a normal is composed of two others. False if it isn't in their plane, or in their line and not opposite.
bool compose(const Vec3 &normal, const Vec3 &a, const Vec3 &b, std::array<double, 2> &shares) {
    constexpr double kParallel = 4.0 * kFits; // sine of an angle
    const Vec3 line = glm::cross(a, b);
    const double square = squared(line);
    shares = {-1.0, 0.0};
    if (square <= kParallel * kParallel) return squared(normal + a) <= kParallel * kParallel;
    if (std::abs(glm::dot(normal, line)) > kParallel * std::sqrt(square)) return false;
    shares = {glm::dot(glm::cross(normal, b), line) / square, glm::dot(glm::cross(a, normal), line) / square};
    return true;
}

/// The direction in which the ball moves, or starts to.
Vec3 heading(const MovingBall &ball, const Response &response) {
    const Vec3 &v = ball.motion.velocity, &a = response.acceleration;
    if (glm::length(v) > ball.negligibleSpeed()) return hat(v);
    return glm::length(a) > response.noise ? hat(a) : Vec3(0.0);
}

/// Whether two other closed contacts, in whose plane its normal is, lead the ball off one that doesn't press, though
/// its gap doesn't open at once; or whether they keep the ball from pressing it where a slip starts.
bool isLeftBeside(uint32_t idle, uint32_t one, uint32_t two, const Vec3 &way, const Touching &touching,
                  const Response &response) {
    constexpr double kLeast = 1e-9; // of the square of the way
    std::array<double, 2> shares;
    if (!compose(touching.held(idle).normal, touching.held(one).normal, touching.held(two).normal, shares))
        return false;
    const bool isLocked = shares[0] <= kLeast && shares[1] <= kLeast;
    if (isLocked && response.reactions[idle].mode == Mode::starting) return true;
    const auto bend = [&](uint32_t i) {
        return squared(tangential(touching.held(i).across * way, touching.held(i).normal));
    };
    const auto presses = [&](uint32_t i) { return response.reactions[i].pressure > response.noise; };
    double opens = bend(idle);
    if (presses(one)) opens -= shares[0] * bend(one);
    if (presses(two)) opens -= shares[1] * bend(two);
    return opens > kLeast && (isLocked || presses(one) || presses(two));
}

/// Opens contacts that don't press: where the ball leaves the narrowest place between features that leave it one line,
/// no gap opens at once; and where a slip starts, series would leave their pressure undetermined. model.md 14.1.
void openLeft(const MovingBall &ball, const Touching &touching, Response &response) {
    const Vec3 way = heading(ball, response);
    uint32_t opening = 0;
    for (uint32_t idle = 0; idle < touching.count(); ++idle) {
        if (!isClosed(response, idle) || response.reactions[idle].pressure > response.noise) continue;
        for (uint32_t i = 0; i < touching.count(); ++i) {
            for (uint32_t j = 0; j <= i; ++j) {
                if (i == idle || j == idle || !isClosed(response, i) || !isClosed(response, j)) continue;
                opening |= (isLeftBeside(idle, i, j, way, touching, response) ? 1U : 0U) << idle;
            }
        }
    }
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!(opening >> i & 1U)) continue;
        response.reactions[i] = {Mode::open, 0.0, Vec3(0.0), Vec3(0.0), response.reactions[i].slip};
    }
}

/// Whether friction at several contacts holds a ball that moves by no more than rounding.
bool isHeldByFriction(const MovingBall &ball, const Response &response) {
    const double R = ball.radius();
    const Moment moment = ball.moment();
    return countSticking(response) > 1 && isNoSlip(moment, moment.velocity) && isNoSlip(moment, R * moment.spin) &&
           glm::length(response.acceleration) <= response.noise &&
           glm::length(response.spinAcceleration) * R <= response.noise;
}

/// The velocity of a ball that friction or resistance holds is rounding and is removed, model.md 14.1.
void stopHeld(const Touching &touching, const Response &response, MovingBall &ball) {
    if (response.rolling != Vec3(0.0) || ball.isStill()) return;
    if (isHeldByFriction(ball, response)) ball.motion = {Vec3(0.0), Vec3(0.0)};
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (response.reactions[i].mode != Mode::sticking || touching.held(i).resistance == 0.0) continue;
        if (!isNoSlip(ball.moment(), ball.motion.velocity)) return;
        const Vec3 &n = touching.held(i).normal;
        const Vec3 pivoting = glm::dot(ball.motion.spin, n) * n;
        if (!isNoSlip(ball.moment(), ball.radius() * (ball.motion.spin - pivoting))) continue;
        const bool isRounding = countSticking(response) > 1 && isNoSlip(ball.moment(), ball.radius() * pivoting);
        ball.motion = {Vec3(0.0), mayPivot(i, touching, response) && !isRounding ? pivoting : Vec3(0.0)};
    }
}

/// Whether all accelerations are constant: the ball turns in its place, only faces press, or smooth contacts that let
/// the ball move along an axis only, and slips and resistance keep their directions.
bool isUniform(const MovingBall &ball, const Touching &touching, const Response &response, const Vec3 &free) {
    const bool isTurningOnly = ball.motion.velocity == Vec3(0.0) && response.acceleration == Vec3(0.0);
    if (isTurningOnly && response.spinAcceleration == Vec3(0.0)) return true;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Reaction &reaction = response.reactions[i];
        const Held &held = touching.held(i);
        const bool isStraight = touching.contactOf(i).isFace() || free != Vec3(1.0);
        if (reaction.mode == Mode::open) continue;
        if (isStraight && reaction.pressure == 0.0) continue; // as in the middle between two walls a ball apart
        const bool isTurned = !isTurningOnly && !touching.contactOf(i).isFace(); // the normal, by the motion
        if (isTurned && (reaction.mode != Mode::smooth || !isStraight)) return false;
        if (reaction.mode == Mode::slipping) {
            const Vec3 turning = glm::cross(response.spinAcceleration, held.normal);
            if (!isCollinear(reaction.slip, response.acceleration - ball.radius() * turning)) return false;
        }
        if (reaction.mode == Mode::sticking && held.resistance > 0.0 && response.rolling != Vec3(0.0)) {
            const Vec3 turning = tangential(response.spinAcceleration, held.normal);
            const double across = glm::length(glm::cross(response.rolling, turning));
            if (across * ball.radius() > response.noise && !isCollinear(response.rolling, turning)) return false;
        }
    }
    return true;
}

/// The ball rolls against resistance or slips on a face, and no other contact presses.
Resisted alongFace(const MovingBall &ball, const Held &face, const Reaction &reaction) {
    const Vec3 &n = face.normal, &v = ball.motion.velocity, &spin = ball.motion.spin;
    const int axis = n.x != 0.0 ? 0 : n.y != 0.0 ? 1 : 2;
    Vec3 along = ball.setting.gravity();
    along[axis] = 0.0;
    if (reaction.mode == Mode::slipping) {
        const double friction = face.friction * reaction.pressure;
        return Resisted::slipping(axis, v, reaction.slip, along, friction, ball.radius(), spin, n);
    }
    const double resistance = 5.0 / 7.0 * (face.resistance * reaction.pressure);
    return Resisted::rolling(axis, v, 5.0 / 7.0 * along, resistance, ball.radius(), spin, n);
}

/// A contact on whose face the ball slips, and a smooth one across it on which it leans.
struct Leaning {
    uint32_t rough, smooth;
};

/// Whether the ball slips on one face, certainly leans on a smooth one or a smooth edge across it, and touches nothing
/// else.
bool leans(const MovingBall &ball, const Touching &touching, const Response &response, Leaning &leaning) {
    leaning = {kMostHeld, kMostHeld};
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!isClosed(response, i)) continue;
        const Mode mode = response.reactions[i].mode;
        uint32_t &place = mode == Mode::slipping ? leaning.rough : leaning.smooth;
        if (place != kMostHeld || (mode != Mode::slipping && mode != Mode::smooth)) return false;
        place = i;
    }
    if (leaning.rough == kMostHeld || leaning.smooth == kMostHeld) return false;
    const Held &rough = touching.held(leaning.rough), &smooth = touching.held(leaning.smooth);
    if (!isFace(rough) || glm::dot(rough.across, smooth.across) != 0.0) return false;
    const double friction = rough.friction * response.reactions[leaning.rough].pressure;
    const double least = 0.01 * friction + 1e-9 * accelerationScale(ball.moment());
    return response.reactions[leaning.smooth].pressure > least;
}

/// The phase of such a slip; false for the general one.
bool slide(const MovingBall &ball, const Touching &touching, const Response &response, const Leaning &leaning,
           Slips slips, Phase &phase) {
    const Held &rough = touching.held(leaning.rough), &smooth = touching.held(leaning.smooth);
    const Reaction &rubs = response.reactions[leaning.rough], &presses = response.reactions[leaning.smooth];
    if (slips == Slips::mayClose) {
        const SlipEnd::Rough slipping{leaning.rough, rough.normal, rubs.slip, rough.friction * rubs.pressure};
        const SlipEnd::Support support{smooth.normal, presses.pressure, !isFace(smooth)};
        if (const std::optional<SlipEnd> closing = SlipEnd::of(ball.moment(), slipping, support)) {
            phase = *closing;
            return true;
        }
    }
    if (!isFace(smooth)) return false;
    const Slide::Faces faces{leaning.rough, leaning.smooth, axisOf(touching.contactOf(leaning.rough)),
                             axisOf(touching.contactOf(leaning.smooth))};
    phase.emplace<Slide>(ball.moment(), faces, rough.normal, rubs, rough.friction, presses);
    return true;
}

/// Whether a face's friction suffices for a ball that rolls on it round an edge, whatever pushes that: of gravity it
/// takes 2/7 at most, as R w^2 is less than 5/7 of it.
bool rollsRound(const MovingBall &ball, const Held &track, const Reaction &reaction) {
    constexpr double kCertain = 0.9;
    const double gravity = glm::length(tangential(ball.setting.gravity(), track.normal));
    const double resistance = 5.0 / 7.0 * track.resistance * reaction.pressure;
    return track.isGlued || 2.0 / 7.0 * gravity + resistance < kCertain * track.friction * reaction.pressure;
}

/// Whether the ball goes round one smooth edge that certainly presses, free or on a face across it that is smooth or on
/// which it certainly rolls, and touches nothing else. track: that face, or kMostHeld.
bool swings(const MovingBall &ball, const Touching &touching, const Response &response, uint32_t &edge,
            uint32_t &track) {
    const double least = 1e-9 * accelerationScale(ball.moment());
    edge = track = kMostHeld;
    Vec3 faces(0.0), around(0.0); // 1 along the normals of faces, and across the edge
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Reaction &reaction = response.reactions[i];
        const Contact &contact = touching.contactOf(i);
        if (!(reaction.pressure > least)) return false;
        if (reaction.mode == Mode::sticking && contact.isFace())
            track = i;
        else if (reaction.mode != Mode::smooth)
            return false;
        if (!contact.isFace() && (edge != kMostHeld || contact.axes() == 3)) return false;
        (contact.isFace() ? faces : around) += touching.held(i).across;
        if (!contact.isFace()) edge = i;
    }
    if (edge == kMostHeld || faces + around != glm::min(faces + around, Vec3(1.0))) return false;
    if (track == kMostHeld) return true;
    return rollsRound(ball, touching.held(track), response.reactions[track]) && heading(ball, response) != Vec3(0.0);
}

/// The axis along an edge.
int alongEdge(const Contact &edge) { return edge.sides[0] == 0 ? 0 : edge.sides[1] == 0 ? 1 : 2; }

void swing(const MovingBall &ball, const Touching &touching, const Response &response, uint32_t edge, uint32_t track,
           Phase &phase) {
    const int axis = alongEdge(touching.contactOf(edge));
    const Pendulum::Edge at{edge, touching.held(edge).normal, response.reactions[edge].pressure, axis};
    if (track != kMostHeld) {
        const Held &face = touching.held(track);
        const double resistance = face.resistance * response.reactions[track].pressure;
        const Pendulum::Track on{track, face.normal, resistance};
        phase.emplace<Pendulum>(ball.moment(), at, on, heading(ball, response), ball.left);
        return;
    }
    const double along = touching.count() == 1 ? ball.setting.gravity()[axis] : 0.0;
    phase.emplace<Pendulum>(ball.moment(), at, along, ball.left);
}

/// Whether the powers of a moving ball's speeds underflow: series would have no time scale, and in the longest step it
/// gets nowhere.
bool hardlyMoves(const MovingBall &ball) {
    constexpr double kLeast = 0x1p-400; // m/s
    const Motion &motion = ball.motion;
    return !ball.isStill() && glm::length(motion.velocity) + ball.radius() * glm::length(motion.spin) < kLeast;
}

/// After many hops: a ball that moves along the line of two rough contacts with hardly any spin about it has none, so
/// that its slips turn round in no time instead of in dozens of series. model.md 6.4.
void stopSpinAlong(const Touching &touching, MovingBall &ball) {
    constexpr double kHardly = 1e-9; // of the speeds
    if (touching.count() != 2 || !ball.setting.isRigid()) return;
    if (touching.held(0).friction == 0.0 || touching.held(1).friction == 0.0) return;
    const Vec3 line = hat(glm::cross(touching.held(0).normal, touching.held(1).normal));
    const double turning = glm::dot(ball.motion.spin, line), around = ball.radius() * turning;
    if (std::abs(around) > kHardly * speedScale(ball.moment())) return;
    if (!isCollinear(ball.motion.velocity, line)) return;
    ball.motion.spin -= turning * line;
    ball.report.lostSlip(0.2 * around * around);
}

} // namespace

bool isCollinear(const Vec3 &a, const Vec3 &b) {
    const auto isRounding = [](const Vec3 &across, double squares) {
        return glm::dot(across, across) <= 16.0 * kRounding * kRounding * squares;
    };
    const double squares = glm::dot(a, a) * glm::dot(b, b);
    if (squares > 1e-100 && squares < 1e100) return isRounding(glm::cross(a, b), squares);
    return isRounding(glm::cross(hat(a), hat(b)), 1.0);
}

uint32_t onlyFace(const Touching &touching, const Response &response) {
    const auto isIdle = [&](uint32_t i) { // between two walls a ball apart, the one that doesn't press
        const Reaction &reaction = response.reactions[i];
        if (reaction.mode == Mode::sticking || reaction.pressure != 0.0 || !touching.contactOf(i).isFace())
            return false;
        for (uint32_t j = 0; j < touching.count(); ++j) {
            if (isClosed(response, j) && touching.held(j).normal == -touching.held(i).normal) return true;
        }
        return false;
    };
    uint32_t closed = kMostHeld, idle = 0;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!isClosed(response, i)) continue;
        if (isIdle(i)) {
            idle |= 1U << i;
            continue;
        }
        if (closed != kMostHeld || !touching.contactOf(i).isFace()) return kMostHeld;
        closed = i;
    }
    if (closed == kMostHeld || idle == 0) return closed;
    const Vec3 friction = tangential(response.reactions[closed].force, touching.held(closed).normal);
    for (uint32_t i = 0; i < touching.count(); ++i) { // friction that holds the ball off a wall turns with the slip
        const double push = std::abs(glm::dot(friction, touching.held(i).normal));
        if ((idle >> i & 1U) && push > response.noise) return kMostHeld;
    }
    return closed;
}

phys_status choose(MovingBall &ball, Touching &touching, Choice &choice, Slips slips) {
    if (hasManyHops(ball)) stopSpinAlong(touching, ball);
    Response &response = choice.response;
    if (const phys_status status = respondNow(touching, ball, response)) return status;
    openLeft(ball, touching, response);
    balance(ball, touching, response);
    const Vec3 free = findFree(ball, touching, response);
    response.acceleration *= free;
    keepFixed(ball, touching, response);
    stopHeld(touching, response, ball);
    Motion &motion = ball.motion;
    if (!ball.setting.isRigid() && touching.count() > 0 && rests(ball, response)) { // in the air the spin stays
        ball.report.lostSlip(spinEnergy(motion.spin, ball.radius()));
        motion.spin = Vec3(0.0);
    }
    if (rests(ball, response)) {
        choice.phase = Uniform{Vec3(0.0), Vec3(0.0), motion.spin, Vec3(0.0)};
    } else if (isUniform(ball, touching, response, free)) {
        choice.phase = Uniform{motion.velocity, response.acceleration, motion.spin, response.spinAcceleration};
    } else if (const uint32_t face = onlyFace(touching, response); face != kMostHeld) {
        choice.phase = alongFace(ball, touching.held(face), response.reactions[face]);
    } else if (Leaning leaning; leans(ball, touching, response, leaning) &&
                                slide(ball, touching, response, leaning, slips, choice.phase)) {
        return PHYS_OK;
    } else if (hardlyMoves(ball)) {
        motion = {Vec3(0.0), Vec3(0.0)};
        return choose(ball, touching, choice, slips);
    } else if (uint32_t edge, track; swings(ball, touching, response, edge, track)) {
        swing(ball, touching, response, edge, track, choice.phase);
    } else if (!buildSeries(ball, touching, response, choice.phase.emplace<Series>())) {
        if (const phys_status status = jam(touching, ball, response)) return status;
        return choose(ball, touching, choice, slips);
    }
    return PHYS_OK;
}

} // namespace phys
