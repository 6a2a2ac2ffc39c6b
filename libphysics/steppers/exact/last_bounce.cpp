// SPDX-License-Identifier: MIT
#include "exact/last_bounce.h"

#include "contact/near.h"
#include "scene/nearest.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// Bounces no higher than this, in radii, are treated as the last of infinitely many: model.md 6.4.
constexpr double kLastBounce = 1e-13;
/// The same after many hops.
constexpr double kHighBounce = 1e-7;
/// Height for contacts where the law between bounces differs from that after the last one: the error is of first order
/// there.
constexpr double kLastHop = 1e-26;

/// For restitutions above this, the series of bounces would never end.
constexpr double kSlowDecay = 0.95;

/// Hops last no longer than gravity takes for a way of this many radii.
constexpr double kHop = 1e-5;

/// Whether the ball meets, or returns to, nothing but one contact within a time (s).
bool meetsNothingElse(const MovingBall &ball, const Contact &contact, double time) {
    const double R = ball.radius(), tolerance = ball.scene().tolerance, negligible = ball.negligibleSpeed();
    const Vec3 &v = ball.motion.velocity;
    const Vec3 along = v - glm::dot(v, contact.normal) * contact.normal;
    const double way = time * glm::length(along);
    const double bend = time * time * glm::length(ball.setting.gravity()) + way * way / R;
    bool isFree = true;
    visitNear(ball.scene(), ball.position, R + way + bend, [&](const phys_box &box, uint32_t number) {
        if (number == contact.box || !isFree) return;
        const Nearest close = nearest(box, ball.position);
        const double gap = close.distance - R, rate = glm::dot(along, close.normal);
        const bool isLasting = gap <= tolerance && std::abs(glm::dot(v, close.normal)) <= negligible;
        isFree = isLasting || close.normal == contact.normal || gap + time * std::min(0.0, rate) > bend;
    });
    return isFree;
}

/// The largest height of last bounces, m, where the law between bounces may differ from that after the last one. After
/// some hops it counts that the pressure acts like their impulses in the mean, unless a floor gives the ball the spin
/// of rolling, or the ball would meet something else meanwhile: friction, if any, only turns by the share of the slip
/// that a bounce is. Not of a ball that already leaves: it meets the pressure without that impulse. model.md 6.4.
double lastHopHeight(const MovingBall &ball, const Contacts &contacts, const Contact &contact, double back) {
    constexpr double kExact = 1e-15; // of the speed
    if (hasManyHops(ball)) return lastHeight(ball);
    const double least = kLastHop * ball.radius();
    const auto isGlued = [](const Contact &one) { return one.isGlued; };
    if (!hasSomeHops(ball) || std::any_of(contacts.begin(), contacts.end(), isGlued)) return least;
    if (contact.friction > 0.0 && glm::dot(ball.motion.velocity, contact.normal) >= 0.0) return least;
    double height = lastHeight(ball);
    if (contact.friction > 0.0) {
        const Moment moment = ball.moment();
        const double slip = glm::length(slipAt(moment, contact.normal));
        height = std::min(height, kExact * speedScale(moment) * slip / (2.0 * contact.friction * back));
    }
    const double rest = 2.0 * std::sqrt(2.0 * height / back) / (1.0 - contact.restitution);
    return height > least && meetsNothingElse(ball, contact, rest) ? height : least;
}

} // namespace

void countHop(uint32_t count, double time, MovingBall &ball) {
    const double most = kHop * ball.radius(), g = glm::length(ball.setting.gravity());
    if (hasManyHops(ball) || time * time * g > most) return;
    const Vec3 &v = ball.motion.velocity;
    const bool goesOn = glm::dot(v, v) > g * most; // such a ball doesn't come to rest where it is
    ball.hops = std::min(ball.hops + count, goesOn ? kManyHops - 1 : kManyHops);
    ball.lastHop = ball.position;
}

phys_status checkHops(const MovingBall &ball) {
    constexpr double kNear = 0.01; // radii
    if (!hasManyHops(ball)) return PHYS_OK;
    if (ball.isStill() && glm::length(ball.position - ball.lastHop) <= kNear * ball.radius()) return PHYS_OK;
    return fail(ball.error, PHYS_ERROR_EVENT_CAP,
                "more than %u bounces in one step, after which the ball moves on: take a smaller dt", kMostHops);
}

double lastHeight(const MovingBall &ball) {
    return std::max(ball.scene().tolerance, (hasManyHops(ball) ? kHighBounce : kLastBounce) * ball.radius());
}

double lastBounce(const MovingBall &ball, const Contacts &contacts, const Contact &contact, const Vec3 &acting) {
    const double R = ball.radius();
    const double speed = glm::dot(ball.motion.velocity, contact.normal);
    const Vec3 round = ball.motion.velocity - speed * contact.normal;
    const double back = -(glm::dot(acting, contact.normal) + contact.curving(round, R));
    if (endsAsSeries(ball, contacts, contact)) return 0.0;
    if (!(back > 0.0)) return 0.0;
    const bool isUpright = contact.normal.z == 0.0;
    const bool isSmooth = (isUpright && contact.friction == 0.0) || contact.restitution > kSlowDecay;
    const double height = isSmooth ? lastHeight(ball) : lastHopHeight(ball, contacts, contact, back);
    return std::sqrt(2.0 * back * height);
}

double squareOfFastBounce(const MovingBall &ball) {
    constexpr double kMost = 1e3; // relative: an upper bound for the ratio of accelerations due to contacts
    return 2.0 * kMost * accelerationScale(ball.moment()) * lastHeight(ball);
}

bool endsSlips(const MovingBall &ball, const Contact &face) {
    const Vec3 g = ball.setting.gravity();
    const double back = -glm::dot(g, face.normal);
    return face.friction == 0.0 ||
           2.0 / 7.0 * glm::length(g + back * face.normal) <= 0.5 * (1.0 + face.restitution) * face.friction * back;
}

bool endsAsSeries(const MovingBall &ball, const Contacts &contacts, const Contact &face) {
    constexpr double kElastic = 1.0 - 1e-6; // restitution above which bounces are too many for an end
    const double eps = face.restitution, back = -glm::dot(ball.setting.gravity(), face.normal);
    if (contacts.count() != 1 || !face.isFace() || hasManyHops(ball)) return false;
    if (!(back > 0.0) || eps <= kSlowDecay || eps > kElastic) return false;
    if (face.friction == 0.0) return true;
    const double push = (1.0 + eps) * std::abs(glm::dot(ball.motion.velocity, face.normal));
    return endsSlips(ball, face) && 2.0 / 7.0 * glm::length(slipAt(ball.moment(), face.normal)) <= face.friction * push;
}

} // namespace phys
