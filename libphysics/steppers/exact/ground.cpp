// SPDX-License-Identifier: MIT
#include "exact/ground.h"

#include "contact/near.h"
#include "scene/nearest.h"

namespace phys {

Ground::Ground(const MovingBall &ball, FloorRegions &regions)
    : m_start(ball.elapsed) {
    if (ball.runsAllStages()) return;
    m_region = regions.around(fromVec(ball.position), inPlane(ball.motion.velocity));
    if (!m_region) return;
    m_boxes.add(m_region->floor);
    for (int axis = 0; axis < 2; ++axis) {
        const FloorRegion::Range &range = m_region->along[static_cast<size_t>(axis)];
        if (ball.position[axis] == range.lowFace) m_boxes.add(range.lowBox);
        if (ball.position[axis] == range.highFace) m_boxes.add(range.highBox);
    }
    m_nearBoxes = m_boxes.count();
}

bool Ground::lookAround(const MovingBall &ball) {
    const Scene &scene = ball.scene();
    const double R = scene.radius, least = R - scene.tolerance;
    m_openWay = ball.left * (glm::length(ball.motion.velocity) + ball.left * glm::length(ball.setting.gravity()));
    const double reach = R * (1.0 + 1e-9) + scene.tolerance + m_openWay;
    bool isOutside = true;
    uint32_t near = 0;
    visitNear(scene, ball.position, R, [&](const phys_box &box, uint32_t) {
        const double square = squaredDistance(box, ball.position);
        isOutside = isOutside && square >= least * least;
        near += square <= reach * reach ? 1 : 0;
    });
    m_nearBoxes = isOutside && m_openWay <= (kCandidateReach - 1.01) * R ? near : kManyBoxes;
    return isOutside;
}

bool Ground::isOpen(const MovingBall &ball, uint32_t leansOn, double acceleration) const {
    if (ball.elapsed > m_start || ball.runsAllStages()) return false;
    const double way = ball.left * (glm::length(ball.motion.velocity) + 0.5 * ball.left * acceleration);
    return leansOn == m_nearBoxes && (keeps(ball, acceleration) || !(way > m_openWay));
}

} // namespace phys
