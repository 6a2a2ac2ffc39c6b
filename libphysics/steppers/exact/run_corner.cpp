// SPDX-License-Identifier: MIT
// A ball held by two walls: it spins down on the floor, or falls between them. model.md 6.5.
#include "run.h"

#include <cmath>

namespace phys {

namespace {

/// Cosine of two normals that are at right angles.
constexpr double kAcross = 1e-12;

bool isUpright(const Touch &touch) { return touch.normal.z == 0.0; }

/// On the floor a slip that is none, up to rounding, leaves a spin about that contact's normal; friction there has
/// nothing to do then if the others' is across. False where it would have, or in the air, where the ball would roll.
bool settle(CornerLaw &law, CornerState &now, double smallest) {
    const double rounding = kRolls * (std::abs(now.up) + glm::length(now.spin)) + smallest;
    for (CornerContact &contact : law.contacts) {
        if (contact.friction == 0.0 || glm::length(slipAt(contact, now)) > rounding) continue;
        if (!law.onFloor) return false;
        contact.friction = 0.0;
        now.spin = glm::dot(contact.normal, now.spin) * contact.normal;
        for (const CornerContact &other : law.contacts) {
            const bool isAcross = std::abs(glm::dot(other.normal, contact.normal)) <= kAcross;
            if (&other != &contact && other.friction > 0.0 && !isAcross) return false;
        }
    }
    return true;
}

} // namespace

phys_status Run::stayInCorner(const Hold &hold) {
    // On the floor between smooth walls the spin has a closed form.
    if (m_floor && m_params.wall_friction == 0.0) {
        spinDown(slipVelocity());
        return PHYS_OK;
    }
    for (uint32_t i = 0; i < m_touches.count; ++i) {
        for (uint32_t j = i + 1; j < m_touches.count; ++j) {
            const std::optional<AtCorner> corner = lookAtCorner(m_touches.items[i], m_touches.items[j]);
            if (!corner) continue;
            followCorner(*corner);
            return PHYS_OK;
        }
    }
    // Friction takes the ball off all walls but one.
    for (uint32_t i = 0; i < m_touches.count && !m_cornered; ++i) {
        const Hold single = holdAt(m_board, m_touches.items[i], m_ball.position);
        if (!isFreeToStay(single)) continue;
        m_cornered = true;
        return stayAtWall(single);
    }
    return refuse("the ball is caught between it and another wall, where friction jams it or it rolls", hold.touch);
}

/// Whether the ball presses on that wall and none else, when it stays there.
bool Run::isFreeToStay(const Hold &single) const {
    if (single.kind != Hold::Kind::face && single.kind != Hold::Kind::edge) return false;
    const AtWall wall = lookAtWall(single);
    const WallMotion motion(wall.law, wall.now);
    const bool moves = motion.way.most(1.0) > 0.0;
    const auto blocks = [&](const Touch &touch) {
        return moves && glm::dot(inPlane(touch.normal), wall.axes.along) < -m_board.sameNormal();
    };
    return !isSpent(motion.wallForce, 1.0) && !std::any_of(m_touches.begin(), m_touches.end(), blocks);
}

/// The ball between two walls, if they hold it together.
std::optional<Run::AtCorner> Run::lookAtCorner(const Touch &first, const Touch &second) const {
    if (!isUpright(first) || !isUpright(second)) return std::nullopt;
    const double R = m_board.radius();
    const Vec3 gravity = toVec(m_params.gravity), &v = m_ball.velocity, &spin = m_ball.spin;
    AtCorner corner;
    corner.units = unitsFor(std::max(R * glm::length(spin), std::abs(v.z)));
    corner.now = {v.z / corner.units.speed, R / corner.units.speed * spin};
    CornerLaw &law = corner.law;
    law.gravity = gravity / corner.units.acceleration;
    const double friction = isRolling() ? 0.0 : m_params.wall_friction;
    law.contacts[0] = {first.normal, friction};
    law.contacts[1] = {second.normal, friction};
    law.onFloor = m_floor.has_value();
    if (law.onFloor) law.contacts[2] = {{0.0, 0.0, 1.0}, m_params.sliding_friction};
    if (!settle(law, corner.now, leastSpeed() / corner.units.speed)) return std::nullopt;

    const CornerMotion probe(law, corner.now, 2);
    if (!probe.isSolvable()) return std::nullopt;
    for (size_t i = 0; i < (law.onFloor ? 3 : 2); ++i) {
        if (isSpent(probe.force[i], 1.0)) return std::nullopt;
    }
    return corner;
}

/// Until the time is up, a force or a slip ends, or the ball has fallen as far as it can.
void Run::followCorner(const AtCorner &corner) {
    using enum WallEnd::Cause;
    const CornerMotion motion(corner.law, corner.now);
    const double left = m_left / corner.units.time();
    WallEnd end{motion.goodFor(), series};
    if (!motion.slips()) end.s = std::min(end.s, left); // s is the time
    end.cut(remains(left, motion.time), time);
    for (size_t i = 0; i < (m_floor ? 3 : 2); ++i) end.cut(motion.force[i], force);
    for (size_t i = 0; i < 2 && !m_floor; ++i)
        cutFall(end, motion.height, corner.units.length(), corner.law.contacts[i].normal);

    m_report.lostSlip(motion.heat.at(end.s) * corner.units.speed * corner.units.speed);
    const double t = end.cause == time ? m_left : motion.time.at(end.s) * corner.units.time();
    CornerState now = motion.at(end.s);
    CornerLaw law = corner.law;
    settle(law, now, leastSpeed() / corner.units.speed);
    const bool slipped = slipVelocity() != Vec2(0.0);
    const Vec3 before = m_ball.spin;
    m_ball.spin = corner.units.speed / m_board.radius() * now.spin;
    m_ball.velocity = {0.0, 0.0, m_floor ? 0.0 : corner.units.speed * now.up};
    if (!m_floor) m_ball.position.z += motion.height.at(end.s) * corner.units.length();
    if (end.cause == landing) m_ball.position.z = m_board.scene().supportedZ;
    m_meets = end.cause == landing;
    turn(0.5 * t * (before + m_ball.spin));
    spend(t);
    if (slipped && slipVelocity() == Vec2(0.0)) event(PHYS_EVENT_ROLL, 0.0, 0.0);
}

} // namespace phys
