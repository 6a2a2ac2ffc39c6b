// SPDX-License-Identifier: MIT
#include "exact/bounces.h"

#include "base/elementary.h"
#include "contact/held.h"
#include "contact/near.h"
#include "exact/last_bounce.h"
#include "exact/resolve.h"
#include "exact/search.h"
#include "phases/resisted.h"
#include "phases/uniform.h"
#include "scene/nearest.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr double kNear = 0.48; // radii: distance over which bounces are handled without a search

/// The geometric series 1 + ratio + ratio^2 + ... with this many terms.
double geometric(double ratio, double count) {
    return ratio == 1.0 ? count : elementary::expm1(count * elementary::log1p(ratio - 1.0)) / (ratio - 1.0);
}

/// The number of terms whose sum is at most `sum`.
double countOf(double ratio, double sum) {
    if (ratio == 1.0) return sum;
    const double rest = sum * (ratio - 1.0);
    return rest > -1.0 ? elementary::log1p(rest) / elementary::log1p(ratio - 1.0) : kNever;
}

/// An obstacle beside a face lies behind the plane of its nearest point.
struct Obstacle {
    Vec3 normal;
    double gap; ///< m, minus all motion of the ball along the face's normal
};
using Obstacles = ShortList<Obstacle>;

/// Sums over the first bounces of a series.
struct SeriesPart {
    double time;
    double squares; ///< s^2: sum of the squares of the flights' durations
    double speed;   ///< speed away from the face at its end
};

/// Similar bounces on a face: their durations, speeds and distances are geometric series.
struct BounceSeries {
    double speed, flight; ///< away from the face; duration of the first flight
    double slowing;       ///< m/s^2: rate at which the normal speed of the bounces decreases
    double drag;          ///< share of the gravity along the face that friction compensates
    Vec3 along, pull;     ///< velocity and gravity along the face

    BounceSeries(const Motion &motion, const Contact &face, const Vec3 &gravity)
        : speed(glm::dot(motion.velocity, face.normal)) {
        const double back = -glm::dot(gravity, face.normal);
        flight = 2.0 * speed / back;
        slowing = (1.0 - face.restitution) * 0.5 * back;
        drag = face.friction > 0.0 ? 2.0 / 7.0 : 0.0;
        along = motion.velocity - speed * face.normal;
        pull = gravity + back * face.normal;
    }

    Vec3 way(const SeriesPart &part) const {
        return part.time * along + 0.5 * ((1.0 - drag) * part.time * part.time + drag * part.squares) * pull;
    }
};

/// The face to which the ball returns first, if it leaves all that it touches and only faces pull it back.
const Contact *nextBounce(const MovingBall &ball, const Contacts &contacts) {
    const Contact *next = nullptr;
    double first = kNever;
    const double negligible = ball.negligibleSpeed();
    for (const Contact &contact : contacts) {
        const double speed = glm::dot(ball.motion.velocity, contact.normal);
        if (speed <= negligible) return nullptr;
        const double back = -glm::dot(ball.setting.gravity(), contact.normal);
        if (!contact.isFace() || !(back > 0.0) || !(speed < first * back)) continue;
        next = &contact;
        first = speed / back;
    }
    return next;
}

/// Speed away from the only face that is touched at which a bounce is the last one, or negligible.
double leastBounce(const MovingBall &ball, const Contacts &contacts) {
    return std::max(lastBounce(ball, contacts, contacts[0], ball.setting.gravity()), ball.negligibleSpeed());
}

/// Whether the bounces are similar: friction has ended all slip, or there is none.
bool isRegular(const MovingBall &ball, const Contact &face) {
    constexpr double kLeast = 0.9; // restitution: with less, there are only few bounces
    if (face.restitution < kLeast || !endsSlips(ball, face)) return false;
    return face.friction == 0.0 || isNoSlip(ball.moment(), slipAt(ball.moment(), face.normal));
}

/// Whether many bounces of equal height follow while the ball slips, after many in this step.
bool isEven(const MovingBall &ball, const Contact &face) {
    constexpr double kElastic = 1.0 - 1e-11; // restitution
    if (!hasSomeHops(ball) || face.friction == 0.0 || face.restitution < kElastic) return false;
    return !isNoSlip(ball.moment(), slipAt(ball.moment(), face.normal));
}

/// The obstacles for a ball that bounces up to this height on a face, the only one it touches: whatever rises above the
/// face's plane, and the face's ends.
Obstacles findObstacles(const Contacts &contacts, double height, MovingBall &ball) {
    const Contact &face = contacts[0];
    const double R = ball.radius(), tolerance = ball.scene().tolerance;
    const phys_box &own = ball.scene().boxes[face.box];
    Obstacles obstacles;
    for (int axis = 0; axis < 3; ++axis) {
        if (face.sides[axis] != 0) continue;
        Vec3 inward(0.0);
        inward[axis] = 1.0;
        obstacles.add({inward, ball.position[axis] - (&own.min.x)[axis] - tolerance});
        obstacles.add({-inward, (&own.max.x)[axis] - ball.position[axis] - tolerance});
    }
    const Outlook around{ball.scene(), ball.position, ball.motion, contacts, ball.work};
    ball.work.add(Work::kObstacles);
    visitNear(ball.scene(), ball.position, (1.0 + kNear) * R + height, [&](const phys_box &box, uint32_t) {
        ball.work.add(Work::kBox);
        const Nearest close = nearest(box, ball.position);
        const double off = close.distance - R;
        if (off > kNear * R + height || around.isBehindTouchedFace(box)) return;
        if (obstacles.isFull()) obstacles[0].gap = -kNever; // too many to consider
        if (obstacles.isFull()) return;
        const double rise = height * std::max(0.0, -glm::dot(close.normal, face.normal));
        obstacles.add({close.normal, (std::abs(off) <= tolerance ? 0.0 : off - tolerance) - rise});
    });
    return obstacles;
}

/// Whether the ball meets none of them from `gone` on, while it moves along `way` and along `bend`.
bool isClear(const Obstacles &obstacles, const Vec3 &gone, const Vec3 &way, const Vec3 &bend, const Scene &scene) {
    if (glm::length(gone) + glm::length(way) + glm::length(bend) > kNear * scene.radius) return false;
    return std::all_of(obstacles.begin(), obstacles.end(), [&](const Obstacle &obstacle) {
        const double first = glm::dot(obstacle.normal, way), second = glm::dot(obstacle.normal, bend);
        const double gap = obstacle.gap + glm::dot(obstacle.normal, gone), end = gap + first + second;
        // If it is touched at the end, there is an impact on both at once.
        return end > 2.0 * scene.tolerance && std::min(gap, second < 0.0 ? end : gap + first) >= 0.0;
    });
}

/// How long bounces certainly meet nothing except their face.
double freeTime(const BounceSeries &series, const Obstacles &obstacles, double radius) {
    double clear = kNear * radius;
    for (const Obstacle &obstacle : obstacles) clear = std::min(clear, obstacle.gap);
    if (!(clear > 0.0)) return 0.0;
    const double fast = glm::length(series.along);
    return 2.0 * clear / (fast + std::sqrt(fast * fast + 2.0 * glm::length(series.pull) * clear));
}

/// Makes bounces one after the other, except for the last one.
void makeBounces(double back, const Obstacles &obstacles, MovingBall &ball, Touching &touching) {
    Contact &face = touching.contacts[0];
    const Vec3 g = ball.setting.gravity(), n = face.normal, pull = g + back * n, start = ball.position;
    do {
        const double speed = glm::dot(ball.motion.velocity, n), flight = 2.0 * speed / back;
        const Vec3 along = ball.motion.velocity - speed * n, way = flight * (along + 0.5 * flight * pull);
        if (flight >= ball.left || face.restitution * speed <= leastBounce(ball, touching.contacts)) return;
        const Vec3 bend = 0.5 * flight * flight * pull;
        if (!isClear(obstacles, ball.position - start, flight * along, bend, ball.scene())) return;
        const Uniform turning{Vec3(0.0), Vec3(0.0), ball.motion.spin, Vec3(0.0)};
        ball.turn(turning, turning.placeAt(flight), flight);
        ball.position += way;
        face.point += way;
        ball.motion.velocity = along + flight * pull - speed * n;
        ball.pass(flight);
        ball.work.add(Work::kBounce);
        countHop(kBounceCount, flight, ball);
        collide(ball.negligibleSpeed(), ball, touching);
    } while (!ball.work.isTooMuch() && !isRegular(ball, face) && !isEven(ball, face));
}

void followSeries(const BounceSeries &series, const SeriesPart &part, MovingBall &ball, Contact &face) {
    ball.work.add(Work::kBounce);
    ball.report.lostImpact(0.5 * (series.speed - part.speed) * (series.speed + part.speed));
    ball.report.lostSlip(0.5 * series.drag * part.squares * glm::dot(series.pull, series.pull));
    const Vec3 turning = 2.5 * series.drag / ball.radius() * glm::cross(face.normal, series.pull);
    const Uniform spinning{Vec3(0.0), Vec3(0.0), ball.motion.spin, turning};
    ball.turn(spinning, spinning.placeAt(part.time), part.time);
    const Vec3 way = series.way(part);
    ball.position += way;
    face.point += way;
    ball.motion.velocity += (1.0 - series.drag) * part.time * series.pull + (part.speed - series.speed) * face.normal;
    ball.motion.spin += part.time * turning;
    ball.pass(part.time);
}

/// One of many bounces, as the report shows it.
struct Bounce {
    double time; ///< s from now on
    Vec3 way;
    double before, after; ///< speeds
};

/// Reports bounces at a face while there is room for them. bounce(i): the i-th one, from 1 on.
template<class BounceAt>
void reportBounces(double count, const Contact &face, MovingBall &ball, const BounceAt &bounce) {
    for (uint64_t number = 1; static_cast<double>(number) <= count; ++number) {
        const double i = static_cast<double>(number);
        if (!ball.report.hasRoom()) return ball.report.lostEvents(count - i + 1.0);
        const Bounce now = bounce(i);
        const Vec3 point = face.point + now.way;
        ball.report.event(face.isTop ? PHYS_EVENT_LANDING : PHYS_EVENT_IMPACT, ball.elapsed + now.time, point,
                          face.normal, -now.before, now.after, ball.scene().givenBox(face.box, point));
    }
}

/// Regular bounces form a geometric series: those down to half the speed are made at once. False if there are none.
bool skipSeries(const Obstacles &obstacles, MovingBall &ball, Contacts &contacts) {
    Contact &face = contacts[0];
    if (!isRegular(ball, face)) return false;
    const BounceSeries series(ball.motion, face, ball.setting.gravity());
    const double eps = face.restitution, flight = series.flight;
    const double most = countOf(eps, std::min(freeTime(series, obstacles, ball.radius()), ball.left) / flight) - 1.0;
    // The last of them is found in the same way as without this, because it must not depend on the steps.
    const double share = std::max(0.5, leastBounce(ball, contacts) / series.speed);
    const double decay = eps == 1.0 ? kNever : elementary::log1p(share - 1.0) / elementary::log1p(eps - 1.0) - 1.0;
    const double count = std::floor(std::min(most, decay));
    if (!(count >= 1.0)) return false;
    const auto partOf = [&](double bounces) {
        const double time = flight * geometric(eps, bounces);
        return SeriesPart{time, flight * flight * geometric(eps * eps, bounces), series.speed - series.slowing * time};
    };
    reportBounces(count, face, ball, [&](double i) {
        const SeriesPart part = partOf(i);
        return Bounce{part.time, series.way(part), partOf(i - 1.0).speed, part.speed};
    });
    followSeries(series, partOf(count), ball, face);
    return true;
}

/// Gives the ball a share of the friction of one bounce, whose impulse this is.
void rub(const Contact &face, double impulse, double share, MovingBall &ball) {
    const Vec3 friction = -share * face.friction * impulse * hat(slipAt(ball.moment(), face.normal));
    ball.motion.velocity += friction;
    ball.motion.spin -= kInertia / ball.radius() * glm::cross(face.normal, friction);
}

/// Many even bounces: from the middle of one impulse to that of another the mean pressure moves the ball along the face
/// as they do, up to the square of a flight. False if there are few.
bool skipSlip(const Obstacles &obstacles, MovingBall &ball, Contacts &contacts) {
    constexpr double kFew = 64.0, kLower = 1e-9; // kLower: of the speed, by which they may become slower
    Contact &face = contacts[0];
    if (!isEven(ball, face)) return false;
    BounceSeries series(ball.motion, face, ball.setting.gravity());
    if (series.speed <= leastBounce(ball, contacts)) return false;
    const double flight = series.flight, impulse = (1.0 + face.restitution) * series.speed;
    const double friction = face.friction * impulse / flight, before = kineticEnergy(ball.motion, ball.radius());
    const Motion given = ball.motion;
    ball.motion.velocity = series.along;
    rub(face, impulse, -0.5, ball);
    const Moment moment = ball.moment();
    const Resisted phase =
        Resisted::slipping(moment, {0, axisOf(face), face.normal}, slipAt(moment, face.normal), friction);
    const Vec3 pull = series.pull;
    series.pull += friction * hat(pull == Vec3(0.0) ? series.along : pull);
    const double free =
        std::min(freeTime(series, obstacles, ball.radius()), phase.end(ball.left, ball.work).after - 4.0 * flight);
    const double most = std::min(free, ball.left) / flight;
    const double count = std::floor(std::min(most, kLower / (1.0 - face.restitution)));
    if (!(count >= kFew)) {
        ball.motion = given;
        return false;
    }
    reportBounces(count, face, ball, [&](double i) {
        return Bounce{i * flight, phase.at(i * flight).way, series.speed, series.speed};
    });
    const Place end = phase.placeAt(count * flight);
    ball.turn(phase, end, count * flight);
    ball.position += end.way;
    face.point += end.way;
    ball.motion = {end.velocity, end.spin};
    rub(face, impulse, 0.5, ball);
    ball.motion.velocity += series.speed * face.normal;
    ball.report.lostSlip(before + glm::dot(pull, end.way) - kineticEnergy(ball.motion, ball.radius()));
    ball.work.add(Work::kBounce + Resisted::lookWork());
    ball.pass(count * flight);
    return true;
}

/// The remaining infinite series of regular bounces, which rise no higher than rounding, as one sum: until it or the
/// step ends. False if there is no such remainder.
bool endSeries(const Obstacles &obstacles, MovingBall &ball, Contacts &contacts) {
    Contact &face = contacts[0];
    if (!endsAsSeries(ball, contacts, face)) return false;
    const BounceSeries series(ball.motion, face, ball.setting.gravity());
    if (0.25 * series.speed * series.flight > lastHeight(ball)) return false;
    const double whole = series.speed / series.slowing;
    const double time = std::min({whole, ball.left, freeTime(series, obstacles, ball.radius())});
    if (!(time > 0.0)) return false;
    const double speed = time == whole ? 0.0 : series.speed - series.slowing * time, share = speed / series.speed;
    const double eps = face.restitution;
    followSeries(series, {time, series.flight * series.flight * (1.0 - share * share) / (1.0 - eps * eps), speed}, ball,
                 face);
    return true;
}

} // namespace

void skipBounces(const Ground &ground, MovingBall &ball, Touching &touching) {
    Contacts &contacts = touching.contacts;
    const Contact *next = touching.count() == 0 ? nextBounce(ball, contacts) : nullptr;
    if (!next) return;
    const double back = -glm::dot(ball.setting.gravity(), next->normal);
    const double speed = glm::dot(ball.motion.velocity, next->normal);
    const double flight = 2.0 * speed / back, height = 0.25 * speed * flight;
    if (flight * glm::length(ball.motion.velocity) > kNear * ball.radius()) return;
    if (flight >= ball.left && height > lastHeight(ball)) return;
    const bool isAlone = contacts.count() == 1;
    const uint32_t box = next->box;
    contacts.drop([&](const Contact &contact) { return contact.box != box; });
    const Obstacles obstacles = findObstacles(contacts, height, ball);
    if (!endSeries(obstacles, ball, contacts) && !skipSeries(obstacles, ball, contacts) &&
        !skipSlip(obstacles, ball, contacts)) {
        makeBounces(back, obstacles, ball, touching);
    }
    const double left = glm::dot(ball.motion.velocity, contacts[0].normal);
    const bool hasEnded = left == 0.0 || (ball.left > 0.0 && left <= ball.negligibleSpeed());
    if (!isAlone || hasEnded) resolve(ground, ball, touching);
}

} // namespace phys
