// SPDX-License-Identifier: MIT
// The rigid model at a rough wall: a ball that rolls on the floor and rolls or rubs along the wall. model.md 6.5.
#include "run.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// A rubbing below this, relative to the speeds whose difference it is, is their rounding.
constexpr double kRolls = 8.0 * kRounding;

double signOf(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; }

} // namespace

/// Whether friction acts between the ball and what holds it.
bool Run::isRough(const Hold &hold) const {
    if (isRolling() || m_params.wall_friction == 0.0 || hold.kind == Hold::Kind::none) return false;
    return glm::dot(toVec(m_params.gravity), hold.touch.normal) < 0.0;
}

/// Everything is along the wall, in the direction z x n: drive g, wall force N, velocity v, R om_z, and what rubs:
/// v - R om_z. The accelerations are constant until the ball stops or the rubbing ends.
phys_status Run::rubOnWall(const Hold &hold) {
    if (!m_ball.supported || slides())
        return refuse("the ball rubs on this rough wall without a floor's grip", hold.touch);
    if (hold.kind != Hold::Kind::face)
        return refuse("the ball stays on this rough edge or in this rough corner", hold.touch);

    const double R = m_board.radius();
    const Vec3 n = hold.touch.normal, along{-n.y, n.x, 0.0};
    const Vec3 gravity = toVec(m_params.gravity);
    const double g = glm::dot(gravity, along), pressing = -glm::dot(gravity, n);
    const double grip = m_params.wall_friction * pressing, floorGrip = m_params.sliding_friction * -gravity.z;
    const double v = glm::dot(m_ball.velocity, along), spin = R * m_ball.spin.z;
    const double rubbing = std::abs(v - spin) <= kRolls * (std::abs(v) + std::abs(spin)) ? 0.0 : v - spin;
    const double resistance = m_params.rolling_friction * -gravity.z;

    // Rolling on both: floor and wall take (2/5) a each.
    if (rubbing == 0.0) {
        if (v == 0.0 && std::abs(g) <= resistance) return rest(hold);
        const double forward = v != 0.0 ? signOf(v) : signOf(g);
        const double a = 5.0 / 9.0 * (g - forward * resistance);
        if (2.0 / 9.0 * std::abs(g) <= std::min(grip, floorGrip)) {
            const double stop = a * forward < 0.0 ? -v / a : kNever;
            rollInGroove(hold, a, a, stop);
            return PHYS_OK;
        }
    }
    // Rubbing: the wall's friction is what it is, against what rubs or starts to.
    const double direction = rubbing != 0.0 ? signOf(rubbing) : signOf(g);
    const double drive = g - direction * grip;
    const double spinRate = 2.5 * direction * grip;
    const double forward = v != 0.0 ? signOf(v) : signOf(drive);
    const bool stays = v == 0.0 && std::abs(drive) <= resistance;
    const double a = stays ? 0.0 : 5.0 / 7.0 * (drive - forward * resistance);
    if (0.4 * std::abs(a) > floorGrip)
        return refuse("the ball slips on the floor and rubs on this rough wall", hold.touch);
    const double stop = a * forward < 0.0 ? -v / a : kNever;
    const double change = a - spinRate;
    const double gripped = rubbing * change < 0.0 ? -rubbing / change : kNever;
    rollInGroove(hold, a, spinRate, std::min(stop, gripped));
    return PHYS_OK;
}

/// Along the wall with constant acceleration of the centre and of R om_z, until `end` at the latest.
void Run::rollInGroove(const Hold &hold, double acceleration, double spinRate, double end) {
    const double R = m_board.radius();
    const Vec3 n = hold.touch.normal, along{-n.y, n.x, 0.0};
    const double spin = R * m_ball.spin.z;
    const double pressing = -glm::dot(toVec(m_params.gravity), n);
    m_ball.velocity[hold.plane.axis] = 0.0;
    const Vec3 start = m_ball.position, velocity = m_ball.velocity;

    const Motion motion = Motion::parabola(start, velocity, acceleration * along);
    const FaceWay way = alongFace(hold.plane, motion);
    const double t = move(motion, &hold.plane, std::min(way.until, end));
    if (t == way.until && way.ends) m_ball.position[1 - hold.plane.axis] = way.end;
    const double turned = t * (spin + 0.5 * t * spinRate);
    const double moved = glm::dot(m_ball.position - start, along);
    m_report.lostSlip(m_params.wall_friction * pressing * std::abs(moved - turned));

    // The phase ends because a speed has become zero, or both are equal: then they are so exactly.
    const double before = glm::length(velocity);
    double v = glm::dot(m_ball.velocity, along), now = spin + t * spinRate;
    if (std::abs(v) <= kRolls * before) v = 0.0;
    if (std::abs(v - now) <= kRolls * (std::abs(spin) + before)) now = v;
    m_ball.velocity = v * along;
    roll();
    m_ball.spin.z = now / R;
    if (v == 0.0 && before > 0.0) event(PHYS_EVENT_STOP, before, 0.0);
}

} // namespace phys
