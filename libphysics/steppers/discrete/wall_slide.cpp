// SPDX-License-Identifier: MIT
#include "wall_slide.h"

#include "floor_contact.h"

#include <cmath>

namespace phys {

Vec2 slippingDrive(const Ball &ball, const phys_params &params, double radius) {
    const Vec2 slip = inPlane(ball.velocity) - spinSpeed(ball.spin, radius);
    const double speed = glm::length(slip);
    const Vec2 along = inPlane(params.gravity);
    return speed > 0.0 ? along + params.sliding_friction * params.gravity.z / speed * slip : along;
}

Vec2 slideAlongWalls(const StepContext &context, const Pressing &pressing, Ball &ball) {
    const phys_params &params = context.params;
    const double radius = context.scene.radius;
    const Vec2 before = inPlane(ball.velocity);
    ball.velocity += context.h * Vec3(inPlane(params.gravity), 0.0);

    double heat = 0.0;
    for (int i = 0; i < pressing.count; ++i) {
        const Vec3 normal(pressing.normals[i], 0.0);
        const double impulse = std::max(0.0, -glm::dot(ball.velocity, normal));
        ball.velocity += impulse * normal;
        heat += applyFriction(ball, normal, impulse, params.wall_friction, radius);
    }

    // A wall's friction may carry part of the weight, or all of it: then the ball is lifted.
    const double weight = -params.gravity.z * context.h - ball.velocity.z;
    if (weight < 0.0) {
        ball.velocity.z = -weight;
        ball.supported = false;
    } else {
        ball.velocity.z = 0.0;
        heat += applyFriction(ball, {0, 0, 1}, weight, params.sliding_friction, radius);
    }

    // What friction pushed into the walls they take back.
    Vec2 velocity = pressing.freePart(inPlane(ball.velocity));
    if (ball.supported && rolls(inPlane(ball.velocity), ball.spin, radius)) {
        velocity = clampedVelocity(Law<Vec2>{Vec2(0.0), rollingLaw(params).B, true}, velocity, context.h);
        ball.spin = Vec3(inPlane(rollingSpin(velocity, radius)), ball.spin.z);
    }
    ball.velocity = Vec3(velocity, ball.velocity.z);
    context.report.lostSlip(heat);
    // The mean velocity: the path then bends no more than the forces do, which sweeping along it relies on.
    return 0.5 * context.h * (before + velocity);
}

} // namespace phys
