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

/// Bounces on one face are a geometric series: those of them, down to half the speed, that surely meet nothing else are
/// made at once. model.md 6.4.
void ExactStep::skipBounces() {
    constexpr double kLeast = 0.9; // restitution: with less there are few of them
    constexpr double kMostAtOnce = 1e5;
    if (m_contacts.count() != 1 || !m_contacts[0].isFace() || m_contacts[0].restitution < kLeast) return;
    Contact &face = m_contacts[0];
    const Vec3 g = m_setting.gravity(), n = face.normal;
    const double back = -glm::dot(g, n), speed = glm::dot(m_motion.velocity, n), eps = face.restitution;
    if (!(back > 0.0) || !(speed > 0.0)) return;
    const Vec3 pull = g + back * n, along = m_motion.velocity - speed * n;
    const double drag = face.friction > 0.0 ? 2.0 / 7.0 : 0.0; // share of the pull that friction takes
    const bool slips = drag > 0.0 && !isNoSlip(moment(), slipAt(moment(), n));
    if (slips || drag * glm::length(pull) > 0.5 * face.friction * back) return;

    const double flight = 2.0 * speed / back, fast = glm::length(along), clear = clearWay(face, 0.25 * speed * flight);
    if (!(clear > 0.0)) return;
    const double free = 2.0 * clear / (fast + std::sqrt(fast * fast + 2.0 * glm::length(pull) * clear));
    const double most = std::min(countOf(eps, std::min(free, m_left) / flight) - 1.0, kMostAtOnce);
    // The last of them is found as without this: which it is must not depend on the steps in which they are made.
    const double share = std::max(0.5, lastBounce(face, g) / speed);
    const double decay = eps == 1.0 ? kNever : elementary::log1p(share - 1.0) / elementary::log1p(eps - 1.0) - 1.0;
    const double count = std::floor(std::min(most, decay));
    if (!(count >= 1.0)) return;
    const auto timeOf = [&](double bounces) { return flight * geometric(eps, bounces); };
    const auto squaresOf = [&](double bounces) { return flight * flight * geometric(eps * eps, bounces); };
    const auto wayOf = [&](double bounces) {
        const double time = timeOf(bounces);
        return time * along + 0.5 * ((1.0 - drag) * time * time + drag * squaresOf(bounces)) * pull;
    };
    const auto speedAfter = [&](double bounces) { return speed - (1.0 - eps) * 0.5 * back * timeOf(bounces); };
    for (double i = 1.0; m_report.wanted() && i <= count; ++i) {
        const Vec3 point = face.point + wayOf(i);
        m_report.event(face.isTop ? PHYS_EVENT_LANDING : PHYS_EVENT_IMPACT, m_elapsed + timeOf(i), point, n,
                       -speedAfter(i - 1.0), speedAfter(i), m_scene.givenBox(face.box, point));
    }
    const double time = timeOf(count), last = speedAfter(count);
    m_work.add(Work::kBounce * static_cast<uint64_t>(count));
    m_report.lostImpact(0.5 * (speed - last) * (speed + last));
    m_report.lostSlip(0.5 * drag * squaresOf(count) * glm::dot(pull, pull));
    const Vec3 turning = 2.5 * drag / m_scene.radius * glm::cross(n, pull);
    turn(Uniform{Vec3(0.0), Vec3(0.0), m_motion.spin, turning}, time);
    const Vec3 way = wayOf(count);
    m_position += way;
    face.point += way;
    m_motion.velocity += (1.0 - drag) * time * pull + (last - speed) * n;
    m_motion.spin += time * turning;
    m_elapsed += time;
    m_left -= time;
}

/// How far a ball that bounces so high on a face can go in any direction along it: all the while it is over the face,
/// and nothing that stands out of its plane is near.
double ExactStep::clearWay(const Contact &face, double height) const {
    const double R = m_scene.radius, reach = R + height + m_scene.tolerance;
    const phys_box &own = m_scene.boxes[face.box];
    double clear = 0.48 * R - height;
    for (int axis = 0; axis < 3; ++axis) {
        if (face.sides[axis] != 0) continue;
        clear = std::min({clear, m_position[axis] - (&own.min.x)[axis] - m_scene.tolerance,
                          (&own.max.x)[axis] - m_position[axis] - m_scene.tolerance});
    }
    Work unused;
    const Outlook around{m_scene, m_position, m_motion, m_contacts, unused};
    visitNear(m_scene, m_position, R + 0.48 * R, [&](const phys_box &box, uint32_t) {
        if (!around.isBehindTouchedFace(box))
            clear = std::min(clear, std::sqrt(squaredDistance(box, m_position)) - reach);
    });
    return clear;
}

} // namespace phys
