// SPDX-License-Identifier: MIT
#include "contact/response.h"

#include <algorithm>
#include <cmath>

namespace phys {

Loss reflect(Ball &ball, const Vec3 &normal, double normalSpeedAfter) {
    const double before = glm::dot(ball.velocity, normal);
    ball.velocity += (normalSpeedAfter - before) * normal;
    // 7/10 v^2 for a ball whose spin follows, 1/2 v^2 for one that keeps it: model.md 9.
    const double inertia = ball.supported ? 0.7 : 0.5;
    return {inertia * (before * before - normalSpeedAfter * normalSpeedAfter), 0.0};
}

Loss reflectWithFriction(Ball &ball, const Vec3 &normal, double normalSpeedAfter, double friction, double radius) {
    const double before = glm::dot(ball.velocity, normal);
    const double impulse = normalSpeedAfter - before;
    ball.velocity += impulse * normal;
    const double slip = applyFriction(ball, normal, impulse, friction, radius);
    return {0.5 * (before * before - normalSpeedAfter * normalSpeedAfter), slip};
}

double applyFriction(Ball &ball, const Vec3 &normal, double normalImpulse, double friction, double radius) {
    if (friction == 0.0) return 0.0;
    const Vec3 surface = ball.velocity - radius * glm::cross(ball.spin, normal);
    const Vec3 slip = surface - glm::dot(surface, normal) * normal;
    const double slipSpeed = glm::length(slip);
    if (slipSpeed == 0.0) return 0.0;
    // An impulse jt changes the slip by 7/2 jt, so 2/7 of the slip ends it: model.md 2.2 F3.
    const double impulse = std::min(friction * normalImpulse, 2.0 / 7.0 * slipSpeed);
    const Vec3 direction = slip / slipSpeed;
    ball.velocity -= impulse * direction;
    ball.spin += 2.5 / radius * impulse * glm::cross(normal, direction);
    return impulse * slipSpeed - 1.75 * impulse * impulse;
}

} // namespace phys
