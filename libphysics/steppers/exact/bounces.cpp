// SPDX-License-Identifier: MIT
// Many bounces at once: model.md 6.4.
#include "base/elementary.h"
#include "contact/near.h"
#include "exact/exact_step.h"
#include "scene/nearest.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr double kNear = 0.48; // radii: as far as bounces are followed without a search

/// 1 + ratio + ratio^2 + ..., so many terms.
double geometric(double ratio, double count) {
    return ratio == 1.0 ? count : elementary::expm1(count * elementary::log1p(ratio - 1.0)) / (ratio - 1.0);
}

/// How many terms of it come to no more than `sum`.
double countOf(double ratio, double sum) {
    if (ratio == 1.0) return sum;
    const double rest = sum * (ratio - 1.0);
    return rest > -1.0 ? elementary::log1p(rest) / elementary::log1p(ratio - 1.0) : kNever;
}

} // namespace

/// Bounces on a face that are alike: their times, speeds and ways are geometric series.
struct ExactStep::BounceSeries {
    double speed, flight; ///< from the face; the time of the first flight
    double slowing;       ///< m/s^2: by which the speed falls from bounce to bounce
    double drag;          ///< share of the pull that friction takes
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

/// The face that the ball comes back to first, if it leaves all that it touches and faces alone pull it back.
const Contact *ExactStep::nextBounce() const {
    const Contact *next = nullptr;
    double first = kNever;
    const double negligible = negligibleSpeed(m_motion, m_scene.radius);
    for (const Contact &contact : m_contacts) {
        const double speed = glm::dot(m_motion.velocity, contact.normal);
        if (speed <= negligible) return nullptr;
        const double back = -glm::dot(m_setting.gravity(), contact.normal);
        if (!contact.isFace() || !(back > 0.0) || !(speed < first * back)) continue;
        next = &contact;
        first = speed / back;
    }
    return next;
}

/// Bounces on one face that surely meet nothing else need no search, and where each is like the one before no flight of
/// their own: model.md 6.4.
void ExactStep::skipBounces() {
    const Contact *next = m_heldCount == 0 ? nextBounce() : nullptr;
    if (!next) return;
    const double back = -glm::dot(m_setting.gravity(), next->normal), speed = glm::dot(m_motion.velocity, next->normal);
    const double flight = 2.0 * speed / back, height = 0.25 * speed * flight;
    if (flight * glm::length(m_motion.velocity) > kNear * m_scene.radius) return;
    if (flight >= m_left && height > lastHeight()) return;
    const bool isAlone = m_contacts.count() == 1;
    const uint32_t box = next->box;
    m_contacts.drop([&](const Contact &contact) { return contact.box != box; });
    const Obstacles obstacles = findObstacles(m_contacts[0], height);
    if (!endSeries(obstacles) && !skipSeries(obstacles)) makeBounces(back, obstacles);
    if (!isAlone || glm::dot(m_motion.velocity, m_contacts[0].normal) == 0.0) resolve();
}

/// One bounce after the other, but the last.
void ExactStep::makeBounces(double back, const Obstacles &obstacles) {
    Contact &face = m_contacts[0];
    const Vec3 g = m_setting.gravity(), n = face.normal, pull = g + back * n, start = m_position;
    do {
        const double speed = glm::dot(m_motion.velocity, n), flight = 2.0 * speed / back;
        const Vec3 along = m_motion.velocity - speed * n, way = flight * (along + 0.5 * flight * pull);
        const double least = std::max(lastBounce(face, g), negligibleSpeed(m_motion, m_scene.radius));
        if (flight >= m_left || face.restitution * speed <= least) return;
        if (!isClear(obstacles, m_position - start, flight * along, 0.5 * flight * flight * pull)) return;
        turn(Uniform{Vec3(0.0), Vec3(0.0), m_motion.spin, Vec3(0.0)}, flight);
        m_position += way;
        face.point += way;
        m_motion.velocity = along + flight * pull - speed * n;
        m_elapsed += flight;
        m_left -= flight;
        m_work.add(Work::kBounce);
        collide(negligibleSpeed(m_motion, m_scene.radius));
    } while (!m_work.isTooMuch() && !isRegular(face));
}

/// Whether friction ends at each bounce on a face what slip the flight before has made, or there is none.
bool ExactStep::endsSlips(const Contact &face) const {
    const Vec3 g = m_setting.gravity();
    const double back = -glm::dot(g, face.normal);
    return face.friction == 0.0 ||
           2.0 / 7.0 * glm::length(g + back * face.normal) <= 0.5 * (1.0 + face.restitution) * face.friction * back;
}

/// Whether each bounce is like the one before: friction has ended all slip, or there is none.
bool ExactStep::isRegular(const Contact &face) const {
    constexpr double kLeast = 0.9; // restitution: with less there are few of them
    if (face.restitution < kLeast || !endsSlips(face)) return false;
    return face.friction == 0.0 || isNoSlip(moment(), slipAt(moment(), face.normal));
}

/// Regular bounces are a geometric series: those down to half the speed are made at once. False if there are none.
bool ExactStep::skipSeries(const Obstacles &obstacles) {
    const Contact &face = m_contacts[0];
    if (!isRegular(face)) return false;
    const BounceSeries series(m_motion, face, m_setting.gravity());
    const double eps = face.restitution, flight = series.flight;
    const double most = countOf(eps, std::min(freeTime(series, obstacles), m_left) / flight) - 1.0;
    // The last of them is found as without this: which it is must not depend on the steps in which they are made.
    const double share = std::max(0.5, lastBounce(face, m_setting.gravity()) / series.speed);
    const double decay = eps == 1.0 ? kNever : elementary::log1p(share - 1.0) / elementary::log1p(eps - 1.0) - 1.0;
    const double count = std::floor(std::min(most, decay));
    if (!(count >= 1.0)) return false;
    const auto partOf = [&](double bounces) {
        const double time = flight * geometric(eps, bounces);
        return SeriesPart{time, flight * flight * geometric(eps * eps, bounces), series.speed - series.slowing * time};
    };
    double before = series.speed;
    for (double i = 1.0; i <= count; ++i) {
        if (!m_report.hasRoom()) {
            m_report.lostEvents(count - i + 1.0);
            break;
        }
        const SeriesPart part = partOf(i);
        const Vec3 point = face.point + series.way(part);
        m_report.event(face.isTop ? PHYS_EVENT_LANDING : PHYS_EVENT_IMPACT, m_elapsed + part.time, point, face.normal,
                       -before, part.speed, m_scene.givenBox(face.box, point));
        before = part.speed;
    }
    followSeries(series, partOf(count));
    return true;
}

/// The rest of infinitely many regular bounces, which rise no higher than rounding, as one sum: until it ends, or the
/// step does. False if there is no such rest.
bool ExactStep::endSeries(const Obstacles &obstacles) {
    const Contact &face = m_contacts[0];
    if (!endsAsSeries(face)) return false;
    const BounceSeries series(m_motion, face, m_setting.gravity());
    if (0.25 * series.speed * series.flight > lastHeight()) return false;
    const double whole = series.speed / series.slowing;
    const double time = std::min({whole, m_left, freeTime(series, obstacles)});
    if (!(time > 0.0)) return false;
    const double speed = time == whole ? 0.0 : series.speed - series.slowing * time, share = speed / series.speed;
    const double eps = face.restitution;
    followSeries(series, {time, series.flight * series.flight * (1.0 - share * share) / (1.0 - eps * eps), speed});
    return true;
}

/// How long bounces surely meet nothing but their face.
double ExactStep::freeTime(const BounceSeries &series, const Obstacles &obstacles) const {
    double clear = kNear * m_scene.radius;
    for (const Obstacle &obstacle : obstacles) clear = std::min(clear, obstacle.gap);
    if (!(clear > 0.0)) return 0.0;
    const double fast = glm::length(series.along);
    return 2.0 * clear / (fast + std::sqrt(fast * fast + 2.0 * glm::length(series.pull) * clear));
}

void ExactStep::followSeries(const BounceSeries &series, const SeriesPart &part) {
    Contact &face = m_contacts[0];
    m_work.add(Work::kBounce);
    m_report.lostImpact(0.5 * (series.speed - part.speed) * (series.speed + part.speed));
    m_report.lostSlip(0.5 * series.drag * part.squares * glm::dot(series.pull, series.pull));
    const Vec3 turning = 2.5 * series.drag / m_scene.radius * glm::cross(face.normal, series.pull);
    turn(Uniform{Vec3(0.0), Vec3(0.0), m_motion.spin, turning}, part.time);
    const Vec3 way = series.way(part);
    m_position += way;
    face.point += way;
    m_motion.velocity += (1.0 - series.drag) * part.time * series.pull + (part.speed - series.speed) * face.normal;
    m_motion.spin += part.time * turning;
    m_elapsed += part.time;
    m_left -= part.time;
}

/// What a ball that bounces so high on a face may meet, which isn't the face: what stands out of its plane, and its
/// ends.
ExactStep::Obstacles ExactStep::findObstacles(const Contact &face, double height) {
    const double R = m_scene.radius, tolerance = m_scene.tolerance;
    const phys_box &own = m_scene.boxes[face.box];
    Obstacles obstacles;
    for (int axis = 0; axis < 3; ++axis) {
        if (face.sides[axis] != 0) continue;
        Vec3 inward(0.0);
        inward[axis] = 1.0;
        obstacles.add({inward, m_position[axis] - (&own.min.x)[axis] - tolerance});
        obstacles.add({-inward, (&own.max.x)[axis] - m_position[axis] - tolerance});
    }
    const Outlook around{m_scene, m_position, m_motion, m_contacts, m_work};
    visitNear(m_scene, m_position, (1.0 + kNear) * R + height, [&](const phys_box &box, uint32_t) {
        m_work.add(Work::kBox);
        const Nearest close = nearest(box, m_position);
        const double off = close.distance - R;
        if (off > kNear * R + height || around.isBehindTouchedFace(box)) return;
        if (obstacles.isFull()) obstacles[0].gap = -kNever; // more than can be looked at
        if (obstacles.isFull()) return;
        const double rise = height * std::max(0.0, -glm::dot(close.normal, face.normal));
        obstacles.add({close.normal, (std::abs(off) <= tolerance ? 0.0 : off - tolerance) - rise});
    });
    return obstacles;
}

/// Whether the ball meets none of them from `gone` on, all the while it goes along `way` and along `bend`.
bool ExactStep::isClear(const Obstacles &obstacles, const Vec3 &gone, const Vec3 &way, const Vec3 &bend) const {
    if (glm::length(gone) + glm::length(way) + glm::length(bend) > kNear * m_scene.radius) return false;
    return std::all_of(obstacles.begin(), obstacles.end(), [&](const Obstacle &obstacle) {
        const double first = glm::dot(obstacle.normal, way), second = glm::dot(obstacle.normal, bend);
        const double least = std::min(0.0, second < 0.0 ? first + second : first);
        return obstacle.gap + glm::dot(obstacle.normal, gone) + least >= 0.0;
    });
}

} // namespace phys
