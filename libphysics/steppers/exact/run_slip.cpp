// SPDX-License-Identifier: MIT
// The rigid model on the floor: a ball whose contact point slips. model.md 2.2, 3.6, 6.5.
#include "run.h"

#include "shared/law.h"

#include <cmath>

namespace phys {

/// On a frictionless floor the spin has no part in the motion.
bool Run::slides() const { return !isRolling() && m_params.sliding_friction == 0.0; }

/// Zero for a ball that rolls, that flies, or whose model knows no slip.
Vec2 Run::slipVelocity() const {
    if (isRolling() || slides() || !m_ball.supported) return Vec2(0.0);
    const Vec2 v = inPlane(m_ball.velocity), w = spinSpeed(m_ball.spin, m_board.radius());
    return length(v - w) <= kRolls * (length(v) + length(w)) ? Vec2(0.0) : v - w;
}

/// Whether static friction can make the ball roll with the acceleration that its contacts leave: model.md 2.2 F2. An
/// edge's part along its normal is no larger than what it takes away.
bool Run::gripHolds(const Hold &hold) const {
    if (isRolling() || slides()) return true;
    Vec3 g(m_params.gravity.x, m_params.gravity.y, 0.0);
    if (hold.kind == Hold::Kind::face) g[hold.plane.axis] = 0.0;
    return 2.0 / 7.0 * length(inPlane(g)) <= m_params.sliding_friction * -m_params.gravity.z;
}

/// Acceleration of a slipping ball now; a slip that only starts does so along g_t.
Drive Run::slipDrive(const Vec2 &u) const {
    const Vec2 g = inPlane(m_params.gravity);
    const double slip = length(u), slope = length(g);
    const Vec2 direction = slip > 0.0 ? u / slip : slope > 0.0 ? g / slope : Vec2(0.0);
    return {Vec3(g - m_params.sliding_friction * -m_params.gravity.z * direction, 0.0), 0.0};
}

phys_status Run::slip() {
    const Vec2 u = slipVelocity();
    const Drive acting = slipDrive(u);
    const Vec3 &p = m_ball.position;
    Vec3 &v = m_ball.velocity;
    Hold hold;
    if (v != Vec3(0.0)) hold = holdMoving(m_board, m_touches, p, v, acting);
    if (v == Vec3(0.0)) hold = holdResting(m_board, m_touches, p, acting);
    noteHold(hold);
    switch (hold.kind) {
    case Hold::Kind::wedged:
        return stayInCorner(hold);
    case Hold::Kind::face:
    case Hold::Kind::edge:
        return stayAtWall(hold);
    case Hold::Kind::beyond:
        return refuse("the ball stays in contact with its top or bottom", hold.touch);
    default:
        return slipFreely(u);
    }
}

phys_status Run::slipFreely(const Vec2 &u) {
    const Law<Vec2> law = slippingLaw(m_params);
    move(Motion::slipping(m_ball.position, m_ball.velocity, u, law.A, law.B), nullptr, m_left);
    return PHYS_OK;
}

/// In a corner the ball spins down in its place: u' = -(5/2) mu_s gn hat(u), model.md 6.5.
void Run::spinDown(const Vec2 &u) {
    const double friction = m_params.sliding_friction * -m_params.gravity.z;
    const double slip = length(u);
    const double end = slip / (2.5 * friction);
    const double t = std::min(m_left, end);
    const double left = t == end ? 0.0 : slip - 2.5 * friction * t;
    m_report.lostSlip(friction * 0.5 * (slip + left) * t);
    const Vec3 before = m_ball.spin;
    const Vec3 spin = rollingSpin(-left / slip * u, m_board.radius());
    m_ball.spin = {spin.x, spin.y, before.z};
    turn(0.5 * t * (before + m_ball.spin));
    spend(t);
    if (t == end) event(PHYS_EVENT_ROLL, 0.0, 0.0);
}

/// Spin after t seconds of a slipping motion: what the friction turned, or exactly rolling at the end of the slip.
void Run::settleSlip(const Motion &motion, double t) {
    const ResistedLaw::Point slipped = motion.slipAt(t);
    m_report.lostSlip(m_params.sliding_friction * -m_params.gravity.z * slipped.path);
    if (slipped.v == Vec2(0.0)) {
        roll();
        event(PHYS_EVENT_ROLL, glm::length(m_ball.velocity), glm::length(m_ball.velocity));
        return;
    }
    const Vec3 spin = rollingSpin(inPlane(m_ball.velocity) - slipped.v, m_board.radius());
    m_ball.spin = {spin.x, spin.y, m_ball.spin.z};
}

/// The spin that belongs to the velocity of a rolling ball; drilling goes on freely.
void Run::roll() {
    const Vec3 spin = rollingSpin(inPlane(m_ball.velocity), m_board.radius());
    m_ball.spin = {spin.x, spin.y, m_ball.spin.z};
}

} // namespace phys
