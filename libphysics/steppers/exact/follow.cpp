// SPDX-License-Identifier: MIT
#include "exact/follow.h"

#include "contact/held.h"
#include "contact/mirror.h"
#include "exact/last_bounce.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

template<class P>
Losses losses(const P &phase, double t, const Touching &, const Response &, double) {
    return phase.losses(t);
}

Losses losses(const Uniform &phase, double t, const Touching &touching, const Response &response, double R) {
    Losses lost;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Reaction &reaction = response.reactions[i];
        const Held &held = touching.held(i);
        if (reaction.mode == Mode::slipping || reaction.mode == Mode::starting) {
            const double speed = phase.meanSlip(t, reaction.direction, held.normal, R);
            lost.slip += held.friction * reaction.pressure * t * speed;
        }
        if (reaction.mode == Mode::sticking)
            lost.rolling += held.resistance * reaction.pressure * R * t * phase.meanSpin(t, response.rolling);
    }
    return lost;
}

/// Moves until the phase ends, and further until a vanishing speed has ended.
template<class P>
void move(const P &phase, const End &end, const Touching &touching, const Response &response, MovingBall &ball) {
    const double t = end.after;
    if (ball.report.wanted() && t > 0.0) {
        const Losses lost = losses(phase, t, touching, response, ball.radius());
        ball.report.lostSlip(lost.slip);
        ball.report.lostRolling(lost.rolling);
    }
    if (t > 0.0) { // after no time, the series may have terms beyond all numbers
        const Place place = phase.placeAt(t);
        ball.turn(phase, place, t);
        ball.position += place.way;
        ball.motion = {place.velocity, place.spin};
    }
    const double turning = ball.radius() * glm::length(response.spinAcceleration);
    const bool waits = ball.waits(end, std::max(phase.mostAcceleration(), turning));
    const double passed = std::min(t + (waits ? end.rest : 0.0), ball.left);
    ball.pass(passed);
    // Before normals are turned, because a slip that has ended would begin again at another place of an edge.
    if (passed > t && end.cause == Cause::grip) ball.position += (passed - t) * ball.motion.velocity;
}

/// Turns normals to where the phase has led round edges and corners.
void turnNormals(const MovingBall &ball, const Response &response, Touching &touching) {
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Contact &contact = touching.contactOf(i);
        if (contact.isFace() || !isClosed(response, i)) continue;
        touching.held(i).normal = hat(contact.across(ball.position - contact.point));
    }
}

/// Removes the velocity along the normals of the contacts that stay closed; of edges and corners in the mean, so that
/// their order leaves no trace, if that leaves none: the normals are perpendicular.
void stopAcross(const Touching &touching, const Response &response, MovingBall &ball) {
    Vec3 &velocity = ball.motion.velocity, speeds(0.0);
    double edges = 0.0;
    uint32_t closed = 0;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!isClosed(response, i)) continue;
        closed |= 1U << i;
        if (touching.contactOf(i).isFace()) continue;
        const Vec3 &n = touching.held(i).normal;
        speeds += glm::dot(velocity, n) * n;
        edges += 1.0;
    }
    if (edges > 0.0) velocity -= speeds / edges;
    bool isLeft = false;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Contact &contact = touching.contactOf(i);
        if (isClosed(response, i) && contact.isFace()) velocity[axisOf(contact)] = 0.0;
    }
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const double speed = glm::dot(velocity, touching.held(i).normal);
        isLeft = isLeft || ((closed >> i & 1U) && std::abs(speed) > 4.0 * kRounding * glm::length(velocity));
    }
    if (isLeft) project(touching, closed, ball);
}

/// Puts the ball at the radius of the edges and corners that stay closed, in the mean of those that share an axis.
void keepEdges(const Touching &touching, const Response &response, MovingBall &ball) {
    Vec3 sum(0.0), count(0.0);
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Contact &contact = touching.contactOf(i);
        if (!isClosed(response, i) || contact.isFace()) continue;
        const Vec3 &n = touching.held(i).normal;
        for (int axis = 0; axis < 3; ++axis) {
            if (contact.sides[axis] == 0) continue;
            sum[axis] += contact.point[axis] + ball.radius() * n[axis];
            count[axis] += 1.0;
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (count[axis] > 0.0) ball.position[axis] = sum[axis] / count[axis];
    }
}

/// Puts the ball on the border that it has reached, and on another one that it has reached at the same time. A search
/// that took too many looks ends before it: then the next phase goes on from there.
void putOnBorders(const Border &border, MovingBall &ball) {
    constexpr double kReached = 64.0; // tolerances
    const double tolerance = ball.scene().tolerance;
    if (std::abs(ball.position[border.axis] - border.coordinate) > kReached * tolerance) return;
    ball.position[border.axis] = border.coordinate;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double end : {(&border.box.min.x)[axis], (&border.box.max.x)[axis]}) {
            if (std::abs(ball.position[axis] - end) <= tolerance) ball.position[axis] = end;
        }
    }
}

/// Bits of the contacts at which friction holds the ball after the phase.
uint32_t stickingAfter(Cause cause, const Touching &touching, const Response &response) {
    uint32_t bits = 0;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Mode mode = response.reactions[i].mode;
        const bool rubs = touching.held(i).friction > 0.0 && !touching.held(i).isGlued;
        const bool holds = mode == Mode::sticking || (mode == Mode::slipping && cause == Cause::grip);
        bits |= (rubs && holds ? 1U : 0U) << i;
    }
    return bits;
}

/// Ends the slip at a contact by a friction impulse, if it is at most `most`. False if there was nothing to end.
bool stick(uint32_t i, double most, const Touching &touching, MovingBall &ball) {
    const Held &held = touching.held(i);
    const Vec3 slip = slipAt(ball.moment(), held.normal);
    if (slip == Vec3(0.0) || glm::length(slip) > most) return false;
    if (touching.contactOf(i).isTop) {
        ball.motion.velocity -= 2.0 / 7.0 * Vec3(slip.x, slip.y, 0.0);
        ball.roll();
        return true;
    }
    ball.motion.velocity -= 2.0 / 7.0 * slip;
    ball.motion.spin += 5.0 / 7.0 / ball.radius() * glm::cross(held.normal, slip);
    return true;
}

/// What ends a slip leads into other contacts, and stopping that brings part of the slip back. grips: the contact whose
/// slip ends, whatever is left of it.
void sweepSlips(uint32_t sticking, uint32_t grips, double rounding, const Touching &touching, const Response &response,
                MovingBall &ball) {
    const Sorted sorted(Mirror(ball.moment(), touching.held()), touching.held()); // symmetric images sweep alike
    bool isStill = false;
    for (int sweep = 0; sweep < 8 && !isStill; ++sweep) {
        stopAcross(touching, response, ball);
        isStill = true;
        for (uint32_t k = 0; k < sorted.count; ++k) {
            const uint32_t i = sorted.index[k];
            if (!(sticking >> i & 1U)) continue;
            if (stick(i, i == grips ? kNever : rounding, touching, ball)) isStill = false;
        }
    }
}

/// Removes rounding errors: slip at sticking contacts, and a velocity that ends with it.
void clearSlips(const End &end, uint32_t sticking, double rounding, const Touching &touching, const Response &response,
                MovingBall &ball) {
    const bool grips = end.cause == Cause::grip;
    uint32_t walls = 0; // bits of those that stick
    for (uint32_t i = 0; i < touching.count(); ++i) walls |= (touching.contactOf(i).isTop ? 0 : sticking) & 1U << i;
    if (walls == 0) {
        stopAcross(touching, response, ball);
    } else {
        sweepSlips(walls, grips ? end.contact : kMostHeld, rounding, touching, response, ball);
    }
    if (!grips && end.cause != Cause::stop) return;
    if (glm::length(ball.motion.velocity) <= rounding) ball.motion.velocity = Vec3(0.0);
    if (ball.radius() * glm::length(ball.motion.spin) <= rounding) ball.motion.spin = Vec3(0.0);
}

/// The axes across which a phase is its own mirror image. It moves the ball along none of them, not even by rounding,
/// to which the image would give the same sign.
class MirrorPlanes {
public:
    MirrorPlanes(const MovingBall &ball, std::span<const Held> held)
        : m_position(ball.position) {
        const Vec3 gravity = ball.setting.gravity(), &v = ball.motion.velocity, &spin = ball.motion.spin;
        for (int axis = 0; axis < 2; ++axis) {
            Vec3 along(0.0);
            along[axis] = spin[axis];
            const bool isMotion = v[axis] == 0.0 && gravity[axis] == 0.0 && spin == along;
            m_has[static_cast<size_t>(axis)] =
                isMotion && std::all_of(held.begin(), held.end(), [&](const Held &one) {
                    Vec3 image = one.normal;
                    image[axis] = -image[axis];
                    return std::any_of(held.begin(), held.end(), [&](const Held &other) {
                        return other.normal == image && other.friction == one.friction && other.across == one.across;
                    });
                });
        }
    }

    void keep(MovingBall &ball) const {
        const auto put = [](double &component, double value) {
            if (component != value) component = value; // a zero keeps its sign
        };
        for (int axis = 0; axis < 2; ++axis) {
            if (!m_has[static_cast<size_t>(axis)]) continue;
            put(ball.position[axis], m_position[axis]);
            put(ball.motion.velocity[axis], 0.0);
            for (int other = 0; other < 3; ++other) {
                if (other != axis) put(ball.motion.spin[other], 0.0);
            }
        }
    }

private:
    Vec3 m_position;
    std::array<bool, 2> m_has;
};

/// Gives the ball the spin of rolling on the floors that hold it.
void rollOnTops(uint32_t sticking, double rounding, const Touching &touching, const Response &response,
                MovingBall &ball) {
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!touching.contactOf(i).isTop) continue;
        const Vec3 &normal = touching.held(i).normal;
        const bool sticks = sticking >> i & 1U && glm::length(slipAt(ball.moment(), normal)) <= rounding;
        const bool isGlued = touching.held(i).isGlued && isClosed(response, i); // model.md 2.1 R7
        if (sticks || isGlued) ball.roll();
    }
}

/// Whether the ball slips at a contact that holds it, by no more than rounding but more than the law takes for none.
bool slips(uint32_t sticking, const Touching &touching, const MovingBall &ball) {
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if ((sticking >> i & 1U) && !isNoSlip(ball.moment(), slipAt(ball.moment(), touching.held(i).normal)))
            return true;
    }
    return false;
}

/// Makes exact what holds at the end of a phase.
void settle(const Event &event, const Response &response, MovingBall &ball, Touching &touching) {
    const End &end = event.end;
    const double before = glm::length(ball.motion.velocity);
    turnNormals(ball, response, touching);
    if (end.cause == Cause::stop) {
        const Vec3 &n = touching.held(end.contact).normal;
        ball.event(PHYS_EVENT_STOP, before, 0.0);
        const bool pivots = mayPivot(end.contact, touching, response);
        ball.motion = {Vec3(0.0), pivots ? glm::dot(ball.motion.spin, n) * n : Vec3(0.0)};
    }
    if (end.cause == Cause::grip) {
        stick(end.contact, kNever, touching, ball);
        const bool isTop = touching.contactOf(end.contact).isTop;
        if (isTop) ball.event(PHYS_EVENT_ROLL, before, glm::length(ball.motion.velocity));
    }
    const uint32_t sticking = stickingAfter(end.cause, touching, response);
    const bool holds = sticking != 0 || end.cause == Cause::stop;
    const double rounding = holds ? 4e-13 * speedScale(ball.moment()) : 0.0;
    if (holds) clearSlips(end, sticking, rounding, touching, response, ball);
    if (end.cause != Cause::time || !rests(ball, response)) {
        keepEdges(touching, response, ball);
        takeFaces(touching.contacts, closedContacts(touching, response), ball);
        turnNormals(ball, response, touching); // to the stored place, beyond whose digits the others have led
        stopAcross(touching, response, ball);
    }
    rollOnTops(sticking, rounding, touching, response, ball);
    // What is left of a slip beyond the law's own rounding would be taken for one.
    for (int sweep = 0; sweep < 8 && slips(sticking, touching, ball); ++sweep) {
        clearSlips(end, sticking, rounding, touching, response, ball);
        rollOnTops(sticking, rounding, touching, response, ball);
    }
    if (end.cause == Cause::border) putOnBorders(event.border, ball);
}

} // namespace

void follow(const Choice &choice, const Event &event, MovingBall &ball, Touching &touching) {
    const bool isSeries = std::holds_alternative<Series>(choice.phase);
    if (isSeries || event.end.cause == Cause::touch) {
        const uint32_t hop = std::holds_alternative<Resisted>(choice.phase) ? kResistedCount : kHopCount;
        countHop(isSeries ? seriesCount(touching.count()) : hop, event.end.after, ball);
    }
    const MirrorPlanes planes(ball, touching.held());
    std::visit([&](const auto &phase) { move(phase, event.end, touching, choice.response, ball); }, choice.phase);
    settle(event, choice.response, ball, touching);
    planes.keep(ball);
}

} // namespace phys
