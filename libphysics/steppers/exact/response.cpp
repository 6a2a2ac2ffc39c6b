// SPDX-License-Identifier: MIT
#include "exact/response.h"

namespace phys {

namespace {

void takeJammed(const Moment &jammed, const Touching &touching, MovingBall &ball, Response &response) {
    const double R = ball.radius();
    const auto energy = [R](const Vec3 &v, const Vec3 &spin) {
        return 0.5 * glm::dot(v, v) + 0.2 * R * R * glm::dot(spin, spin);
    };
    ball.report.lostSlip(energy(ball.motion.velocity, ball.motion.spin) - energy(jammed.velocity, jammed.spin));
    ball.motion = {jammed.velocity, jammed.spin};
    response = respond(ball.moment(), touching.held(), ball.work);
}

} // namespace

phys_status jam(const Touching &touching, MovingBall &ball, Response &response) {
    Moment jammed = ball.moment();
    response.isFound = false;
    if (endSlips(jammed, touching.held(), ball.work)) takeJammed(jammed, touching, ball, response);
    if (!response.isFound) {
        stopSlips(jammed, touching.held(), ball.work);
        takeJammed(jammed, touching, ball, response);
    }
    if (response.isFound) return PHYS_OK;
    if (const phys_status status = ball.checkWork()) return status;
    return fail(ball.error, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) is jammed by friction", ball.position.x,
                ball.position.y, ball.position.z);
}

phys_status respondNow(const Touching &touching, MovingBall &ball, Response &response) {
    response = respond(ball.moment(), touching.held(), ball.work);
    if (const phys_status status = ball.checkWork()) return status;
    return response.isFound ? PHYS_OK : jam(touching, ball, response);
}

uint32_t countSticking(const Response &response) {
    uint32_t count = 0;
    for (const Reaction &reaction : response.list()) count += reaction.mode == Mode::sticking ? 1 : 0;
    return count;
}

bool rests(const MovingBall &ball, const Response &response) {
    if (ball.motion.velocity != Vec3(0.0)) return false;
    if (glm::length(response.acceleration) > response.noise) return false;
    if (glm::length(response.spinAcceleration) * ball.radius() > response.noise) return false;
    for (const Reaction &reaction : response.list()) {
        if (reaction.mode == Mode::slipping || reaction.mode == Mode::starting) return false;
    }
    return true;
}

} // namespace phys
