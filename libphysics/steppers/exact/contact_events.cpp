// SPDX-License-Identifier: MIT
#include "exact/contact_events.h"

#include "exact/response.h"
#include "scene/nearest.h"

namespace phys {

void ContactEvents::add(const Touching &touching, const Response &response, MovingBall &ball) {
    if (!ball.report.wanted()) return;
    bool isCarried = false;
    uint32_t wall = PHYS_NO_BOX, place = 0;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!isClosed(response, i)) continue;
        if (touching.contactOf(i).isTop) {
            isCarried = true;
        } else {
            wall = touching.contactOf(i).box;
            place = i;
        }
    }
    const double speed = glm::length(ball.motion.velocity);
    if (ball.elapsed > 0.0) {
        if (m_isCarried && !isCarried) ball.event(PHYS_EVENT_TAKEOFF, speed, speed);
        if (wall != PHYS_NO_BOX && m_wall == PHYS_NO_BOX) {
            const Contact &contact = touching.contactOf(place);
            ball.event(PHYS_EVENT_CONTACT, contact, speed, speed);
        }
        if (wall == PHYS_NO_BOX && m_wall != PHYS_NO_BOX) {
            const Nearest left = nearest(ball.scene().boxes[m_wall], ball.position);
            ball.report.event(PHYS_EVENT_RELEASE, ball.elapsed, left.point, left.normal, speed, speed,
                              ball.scene().givenBox(m_wall, left.point));
        }
    }
    m_isCarried = isCarried;
    m_wall = wall;
}

} // namespace phys
