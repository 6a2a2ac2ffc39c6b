// SPDX-License-Identifier: MIT
// Impacts, landings, take-offs: what happens in no time. model.md 2.1 and 2.2, 5.5, 6.4.
#include "run.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr uint32_t kMostPasses = 64; // model.md 5.5

/// Landing speeds below this, in sqrt(gn R), end the bouncing on a floor: model.md 6.4. The cut of a floor is first
/// order in the speed, so it's lower than that of a wall.
constexpr double kSmallestHop = 1e-13;

} // namespace

/// Takes one contact after the other, the fastest approach first, until the ball moves into none: model.md 5.5.
phys_status Run::resolve() {
    m_board.findTouches(m_ball.position, m_touches);
    if (m_touches.overflow) return refuse("the ball touches too many boxes at once", m_touches.items[0]);
    snapToFaces();
    uint32_t pass = 0;
    for (; pass < kMostPasses; ++pass) {
        const Touch *worst = nullptr;
        double fastest = 0.0;
        for (const Touch &touch : m_touches) {
            const double rate = glm::dot(m_ball.velocity, touch.normal);
            if (rate >= fastest || !approaches(m_board, touch.normal, touch.feature, m_ball.velocity)) continue;
            fastest = rate;
            worst = &touch;
        }
        if (worst) bounce(*worst);
        const bool landed = resolveFloor();
        if (!worst && !landed) break;
    }
    m_report.passes(pass);
    m_report.passCap(kMostPasses);
    if (pass == kMostPasses) stopBetween();
    return PHYS_OK;
}

/// A face's coordinates are exact, so is the ball's on it; and a velocity along it has no part across.
void Run::snapToFaces() {
    for (const Touch &touch : m_touches) {
        if (touch.feature != PHYS_FEATURE_FACE) continue;
        for (int axis = 0; axis < 3; ++axis) {
            if (touch.normal[axis] == 0.0) continue;
            m_ball.position[axis] = touch.point[axis] + touch.normal[axis] * m_board.radius();
            const bool across = approaches(m_board, touch.normal, touch.feature, m_ball.velocity) ||
                                approaches(m_board, -touch.normal, touch.feature, m_ball.velocity);
            if (!across) m_ball.velocity[axis] = 0.0;
        }
    }
}

void Run::bounce(const Touch &touch) {
    m_levelTouches = 0;
    const double before = glm::dot(m_ball.velocity, touch.normal);
    double after = -m_params.restitution_wall * before;
    if (isLastBounce(touch, after)) after = 0.0;
    const bool wasSupported = m_ball.supported;
    const Loss loss = isRolling()
                          ? reflect(m_ball, touch.normal, after)
                          : reflectWithFriction(m_ball, touch.normal, after, m_params.wall_friction, m_board.radius());
    m_report.lostImpact(loss.impact);
    m_report.lostSlip(loss.slip);
    // Nothing but rounding is left of a velocity that led straight into it, but for what leads along an edge.
    const Vec3 round = velocityRound(touch.normal, touch.feature, m_ball.velocity);
    const bool stops = after == 0.0 && glm::length(round) <= 4.0 * kRounding * -before;
    for (int axis = 0; stops && axis < 3; ++axis) {
        if (touch.normal[axis] != 0.0) m_ball.velocity[axis] = 0.0;
    }
    if (isRolling() && wasSupported) roll();
    contactEvent(PHYS_EVENT_IMPACT, touch, before, after);
    // A rough wall also pushes the ball up, or into the floor: model.md 4.
    if (wasSupported && m_ball.velocity.z > 0.0 && m_ball.velocity.z <= smallestHop()) {
        m_report.lostImpact(0.5 * m_ball.velocity.z * m_ball.velocity.z);
        m_ball.velocity.z = 0.0;
    }
    if (wasSupported && m_ball.velocity.z > 0.0) takeOff();
    if (wasSupported && m_ball.velocity.z < 0.0) land();
}

/// model.md 6.4: a bounce that rises no higher than rounding is the last of infinitely many.
bool Run::isLastBounce(const Touch &touch, double after) const {
    const Vec3 velocity = m_ball.velocity + (after - glm::dot(m_ball.velocity, touch.normal)) * touch.normal;
    const Vec2 u = inPlane(velocity) - spinSpeed(m_ball.spin, m_board.radius());
    const Drive acting = isRolling() || !m_ball.supported ? drive() : slipDrive(u);
    const double back = pressing(m_board, touch, velocity, acting);
    const double lowest = std::max(m_board.tolerance(), 1e-13 * m_board.radius());
    return back > 0.0 && after * after <= 2.0 * back * lowest;
}

/// The ball has come down on a floor, or not: true if its velocity changed.
bool Run::resolveFloor() {
    const Scene &scene = m_board.scene();
    const Vec3 &p = m_ball.position;
    if (m_ball.supported || !scene.hasFloor || std::abs(p.z - scene.supportedZ) > m_board.tolerance()) return false;
    if (m_ball.velocity.z >= 0.0 || !scene.overFloor(p.x, p.y)) return false;
    land();
    return true;
}

double Run::smallestHop() const {
    return kSmallestHop * std::sqrt(std::max(0.0, -m_params.gravity.z) * m_board.radius());
}

void Run::land() {
    const Scene &scene = m_board.scene();
    m_ball.position.z = scene.supportedZ;
    const double before = m_ball.velocity.z;
    double after = -m_params.restitution_floor * before;
    if (after <= smallestHop()) after = 0.0;
    const Vec3 up{0.0, 0.0, 1.0};
    m_ball.supported = false;
    const Loss loss = isRolling() ? reflect(m_ball, up, after)
                                  : reflectWithFriction(m_ball, up, after, m_params.sliding_friction, m_board.radius());
    m_report.lostImpact(loss.impact);
    m_report.lostSlip(loss.slip);
    m_ball.velocity.z = after;
    m_ball.supported = after == 0.0 && m_params.gravity.z < 0.0;
    if (m_ball.supported && isRolling()) followVelocity();
    if (!m_report.wanted()) return;
    const Vec3 point = m_ball.position - Vec3(0.0, 0.0, m_board.radius());
    m_report.event(PHYS_EVENT_LANDING, m_elapsed, point, {0.0, 0.0, 1.0}, before, after,
                   scene.givenFloorAt(point.x, point.y));
}

void Run::takeOff() {
    m_ball.supported = false;
    event(PHYS_EVENT_TAKEOFF, glm::length(m_ball.velocity), glm::length(m_ball.velocity));
}

/// Bounces between solids that don't come to an end, model.md 5.5: what still leads into them is removed.
void Run::stopBetween() {
    const double before = glm::dot(m_ball.velocity, m_ball.velocity);
    for (int round = 0; round < 2; ++round) {
        for (const Touch &touch : m_touches) {
            const double rate = glm::dot(m_ball.velocity, touch.normal);
            if (rate < 0.0) m_ball.velocity -= rate * touch.normal;
        }
    }
    const auto into = [this](const Touch &touch) {
        return approaches(m_board, touch.normal, touch.feature, m_ball.velocity);
    };
    if (std::any_of(m_touches.begin(), m_touches.end(), into)) m_ball.velocity = Vec3(0.0);
    const double inertia = m_ball.supported && isRolling() ? 0.7 : 0.5;
    m_report.lostImpact(inertia * (before - glm::dot(m_ball.velocity, m_ball.velocity)));
    if (m_ball.supported && isRolling()) roll();
}

} // namespace phys
