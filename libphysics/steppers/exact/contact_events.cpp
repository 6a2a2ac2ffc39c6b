// SPDX-License-Identifier: MIT
#include "exact/contact_events.h"

#include "exact/response.h"
#include "scene/nearest.h"

namespace phys {

void ContactEvents::add(const Touching &touching, const Response &response, MovingBall &ball) {
    if (!ball.report.wanted()) return;
    bool isCarried = false;
    const Contact *wall = nullptr;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!isClosed(response, i)) continue;
        if (touching.contactOf(i).isTop)
            isCarried = true;
        else
            wall = &touching.contactOf(i);
    }
    add(isCarried, wall, ball);
}

void ContactEvents::addOnFloor(uint32_t wall, int axis, int side, MovingBall &ball) {
    if (!ball.report.wanted()) return;
    if (wall == PHYS_NO_BOX) return add(true, nullptr, ball);
    const Contact contact = contactAtFace(ball.setting, ball.position, wall, axis, side);
    add(true, &contact, ball);
}

void ContactEvents::add(bool isCarried, const Contact *wall, MovingBall &ball) {
    const double speed = glm::length(ball.motion.velocity);
    if (ball.elapsed > 0.0) {
        if (m_isCarried && !isCarried) ball.event(PHYS_EVENT_TAKEOFF, speed, speed);
        if (wall && m_wall == PHYS_NO_BOX) ball.event(PHYS_EVENT_CONTACT, *wall, speed, speed);
        if (!wall && m_wall != PHYS_NO_BOX) {
            const Nearest left = nearest(ball.scene().boxes[m_wall], ball.position);
            ball.report.event(PHYS_EVENT_RELEASE, ball.elapsed, left.point, left.normal, speed, speed,
                              ball.scene().givenBox(m_wall, left.point));
        }
    }
    m_isCarried = isCarried;
    m_wall = wall ? wall->box : PHYS_NO_BOX;
}

} // namespace phys
