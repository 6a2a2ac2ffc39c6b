// SPDX-License-Identifier: MIT
#include "exact/last_bounce.h"

#include <cmath>

namespace phys {

namespace {

/// Bounces that rise no higher than this, in radii, are the last of infinitely many: model.md 6.4.
constexpr double kLastBounce = 1e-13;
/// Where what is between two bounces has another law than what comes after the last: the error is of first order there.
constexpr double kLastHop = 1e-26;

/// But with a restitution above this the bounces down there would never end.
constexpr double kSlowDecay = 0.95;

/// How much higher the last bounces rise in a step of much work: by this with each quarter of its work that is done.
/// Rather less exact than none.
double higher(const Work &work) {
    constexpr double kHigher = 100.0;
    double factor = 1.0;
    for (uint64_t quarters = work.quarters(); quarters > 0; --quarters) factor *= kHigher;
    return factor;
}

} // namespace

double lastHeight(const MovingBall &ball) {
    return std::max(ball.scene().tolerance, higher(ball.work) * kLastBounce * ball.radius());
}

double lastBounce(const MovingBall &ball, const Contacts &contacts, const Contact &contact, const Vec3 &acting) {
    const double R = ball.radius();
    const double speed = glm::dot(ball.motion.velocity, contact.normal);
    const Vec3 round = ball.motion.velocity - speed * contact.normal;
    const double back = -(glm::dot(acting, contact.normal) + contact.curving(round, R));
    if (endsAsSeries(ball, contacts, contact)) return 0.0;
    const bool isUpright = contact.normal.z == 0.0;
    const bool isSmooth = (isUpright && contact.friction == 0.0) || contact.restitution > kSlowDecay;
    const double height = isSmooth ? lastHeight(ball) : higher(ball.work) * kLastHop * R;
    return std::sqrt(2.0 * std::max(0.0, back) * height);
}

double squareOfFastBounce(const MovingBall &ball) {
    constexpr double kMost = 1e3; // relative: no contacts make more of the accelerations at hand
    return 2.0 * kMost * accelerationScale(ball.moment()) * lastHeight(ball);
}

bool endsSlips(const MovingBall &ball, const Contact &face) {
    const Vec3 g = ball.setting.gravity();
    const double back = -glm::dot(g, face.normal);
    return face.friction == 0.0 ||
           2.0 / 7.0 * glm::length(g + back * face.normal) <= 0.5 * (1.0 + face.restitution) * face.friction * back;
}

bool endsAsSeries(const MovingBall &ball, const Contacts &contacts, const Contact &face) {
    constexpr double kElastic = 1.0 - 1e-6; // restitution: such bounces end in no time to speak of
    const double eps = face.restitution, back = -glm::dot(ball.setting.gravity(), face.normal);
    if (contacts.count() != 1 || !face.isFace() || ball.work.quarters() > 0) return false;
    if (!(back > 0.0) || eps <= kSlowDecay || eps > kElastic) return false;
    if (face.friction == 0.0) return true;
    const double push = (1.0 + eps) * std::abs(glm::dot(ball.motion.velocity, face.normal));
    return endsSlips(ball, face) && 2.0 / 7.0 * glm::length(slipAt(ball.moment(), face.normal)) <= face.friction * push;
}

} // namespace phys
