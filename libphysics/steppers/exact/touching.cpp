// SPDX-License-Identifier: MIT
#include "exact/touching.h"

#include "contact/held.h"
#include "scene/nearest.h"

#include <cmath>

namespace phys {

namespace {

/// Whether the ball is too fast for the groove between two contacts on the same side of it: so fast that it rises over
/// their edges, while its speeds along their almost equal normals are rounding. model.md 6.4.
bool crosses(const MovingBall &ball, const Vec3 &first, const Vec3 &second, const Vec3 &along) {
    if (glm::dot(first, second) <= 0.0) return false;
    const Vec3 across = ball.motion.velocity - glm::dot(ball.motion.velocity, along) * along;
    const Vec3 wide = first - second; // in radii
    const double square = glm::dot(across, across), rounding = ball.negligibleSpeed();
    return square > rounding * rounding &&
           square > glm::dot(wide, wide) * ball.radius() * glm::length(ball.setting.gravity());
}

} // namespace

void Touching::hold(uint32_t number, const phys_params &params) {
    if (m_count == kMostHeld) return;
    const Contact &contact = contacts[number];
    Held &held = m_held[m_count];
    held.normal = contact.normal;
    held.across = contact.across(Vec3(1.0));
    held.friction = contact.friction;
    held.resistance = contact.isTop ? params.rolling_friction : 0.0;
    held.isGlued = contact.isGlued;
    m_numbers[m_count++] = number;
}

void Touching::holdStill(const Vec3 &velocity, double negligible, const phys_params &params) {
    holdNone();
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        if (std::abs(glm::dot(velocity, contacts[i].normal)) <= negligible) hold(i, params);
    }
}

void takeFaces(const Contacts &contacts, uint32_t among, MovingBall &ball) {
    constexpr uint32_t kLow = 1, kHigh = 2; // the side of the face on which the ball is
    std::array<Vec3, 2> at{};
    std::array<uint32_t, 3> sides{};
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        if (!(among >> i & 1U) || !contacts[i].isFace()) continue;
        const int axis = axisOf(contacts[i]), side = contacts[i].sides[axis];
        at[side > 0 ? 1 : 0][axis] = contacts[i].point[axis] + side * ball.radius();
        sides[static_cast<size_t>(axis)] |= side > 0 ? kHigh : kLow;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const uint32_t touched = sides[static_cast<size_t>(axis)];
        if (touched == 0) continue;
        ball.position[axis] = touched == (kLow | kHigh) ? 0.5 * (at[0][axis] + at[1][axis]) : at[touched - 1][axis];
    }
}

bool takeEdges(const Contacts &contacts, MovingBall &ball) {
    const Vec3 start = ball.position;
    constexpr int kRounds = 8;
    constexpr double kLeast = 0.01; // square of the share of a normal that is along the faces
    Vec3 free(1.0);
    for (const Contact &contact : contacts) {
        if (contact.isFace()) free[axisOf(contact)] = 0.0;
    }
    for (int round = 0; round < kRounds && contacts.count() > 1; ++round) {
        takeFaces(contacts, kAll, ball);
        Vec3 off(0.0); // of all similar ones, so that their order doesn't matter
        double count = 0.0;
        for (const Contact &contact : contacts) {
            if (contact.isFace()) continue;
            const double gap = nearest(ball.scene().boxes[contact.box], ball.position).distance - ball.radius();
            const Vec3 along = free * contact.normal;
            const double square = glm::dot(along, along);
            const Vec3 way = square > kLeast ? along / square : contact.normal;
            if (std::abs(gap) > kRounding * ball.radius()) off += gap * way;
            count += 1.0;
        }
        if (off == Vec3(0.0)) break;
        ball.position -= off / count;
    }
    return ball.position != start;
}

void project(const Touching &touching, uint32_t among, MovingBall &ball) {
    // Sine of the angle between normals, or between one and a plane, below which they are parallel up to rounding.
    constexpr double kParallel = 1e-12;
    Vec3 &v = ball.motion.velocity;
    if (v == Vec3(0.0)) return;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!(among >> i & 1U)) continue;
        const Vec3 &n = touching.held(i).normal;
        bool isAlong = false; // a line: what remains across it is rounding, which would be to one side
        for (uint32_t j = 0; j < i; ++j) {
            const Vec3 line = glm::cross(n, touching.held(j).normal);
            if (!(among >> j & 1U)) continue;
            if (glm::dot(line, line) < kParallel * kParallel) continue;
            const Vec3 along = hat(line);
            if (crosses(ball, n, touching.held(j).normal, along)) continue;
            for (uint32_t k = 0; k < j; ++k) {
                if (!(among >> k & 1U)) continue;
                if (std::abs(glm::dot(touching.held(k).normal, along)) > kParallel) v = Vec3(0.0);
            }
            v = glm::dot(v, along) * along;
            isAlong = true;
        }
        if (touching.contactOf(i).isFace()) {
            v[axisOf(touching.contactOf(i))] = 0.0;
        } else if (!isAlong) {
            v -= glm::dot(v, n) * n;
        }
    }
}

} // namespace phys
