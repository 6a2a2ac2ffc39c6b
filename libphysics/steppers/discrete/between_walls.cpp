// SPDX-License-Identifier: MIT
#include "between_walls.h"

#include <cmath>

namespace phys {

namespace {

double cross(const Vec2 &a, const Vec2 &b) { return a.x * b.y - a.y * b.x; }

} // namespace

std::optional<UprightWalls> UprightWalls::find(const StepContext &context, const Contacts &contacts, const Ball &ball) {
    if (context.isRigid() && context.params().wall_friction > 0.0) return {};
    UprightWalls walls;
    uint32_t tops = 0;
    for (const Contact &contact : contacts) {
        if (contact.isTop) {
            if (++tops > 1 || ball.velocity.z != 0.0 || contact.gap > context.scene().tolerance) return {};
        } else if (contact.normal.z != 0.0) {
            return {};
        } else {
            walls.m_walls[walls.m_count++] = {&contact, inPlane(contact.normal), 0.0, false};
        }
    }
    if (tops != 1) return {};
    return walls;
}

std::optional<Vec2> UprightWalls::limitDrive(const Vec2 &drive, double h, double tolerance, const Ball &ball) {
    for (uint32_t i = 0; i < m_count; ++i) {
        const bool isTouched = m_walls[i].contact->gap <= tolerance;
        m_walls[i].least = isTouched ? -glm::dot(inPlane(ball.velocity), m_walls[i].normal) / h : -INFINITY;
    }
    return project(drive);
}

bool UprightWalls::limitVelocity(const Vec2 &taken, double h, double tolerance, const Ball &before, Ball &ball) {
    const bool allTouched = std::all_of(m_walls.begin(), m_walls.begin() + m_count,
                                        [&](const Wall &wall) { return wall.contact->gap <= tolerance; });
    if (allTouched) return true;
    for (uint32_t i = 0; i < m_count; ++i) {
        const double gap = m_walls[i].contact->gap;
        m_walls[i].least = gap <= tolerance ? 0.0 : -gap / h;
        m_walls[i].isActive = false;
    }
    const std::optional<Vec2> velocity = project(inPlane(ball.velocity) + h * taken);
    if (!velocity) return false;
    ball.velocity = Vec3(*velocity, 0.0);
    // The ball may have moved with the old velocity; along the normals of pressing walls it moves with the new one.
    NormalSpan pressing;
    for (uint32_t i = 0; i < m_count; ++i) {
        if (m_walls[i].isActive) pressing.add(m_walls[i].contact->normal);
    }
    // Two walls leave no component of the old velocity, not even a rounding error, which would favour one of them.
    Vec3 way = ball.velocity;
    if (pressing.count() < 2) way -= pressing.across(ball.velocity - (ball.position - before.position) / h);
    ball.position = before.position + h * way;
    return true;
}

bool UprightWalls::turns(const Ball &ball) const {
    return std::any_of(m_walls.begin(), m_walls.begin() + m_count, [&](const Wall &wall) {
        const Contact &contact = *wall.contact;
        return !contact.isFace() && glm::dot(ball.velocity, contact.normal) <= contact.restSpeed;
    });
}

bool UprightWalls::arrives(double tolerance, const Ball &ball) const {
    return std::any_of(m_walls.begin(), m_walls.begin() + m_count, [&](const Wall &wall) {
        return wall.contact->gap > tolerance && glm::dot(ball.velocity, wall.contact->normal) <= 0.0;
    });
}

std::optional<Vec2> UprightWalls::keepDrive(const Vec2 &drive, double tolerance, Ball &ball) {
    uint32_t kept = 0;
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = *m_walls[i].contact;
        const double speed = glm::dot(ball.velocity, contact.normal);
        const bool isTouched = contact.gap <= tolerance;
        const bool leaves = speed > 0.0 && (!isTouched || speed > contact.restSpeed);
        if (leaves) continue;
        ball.velocity -= speed * contact.normal;
        m_walls[kept++] = m_walls[i];
    }
    m_count = kept;
    return project(drive);
}

bool UprightWalls::allows(const Vec2 &vector, double size) const {
    return std::all_of(m_walls.begin(), m_walls.begin() + m_count,
                       [&](const Wall &wall) { return glm::dot(vector, wall.normal) >= wall.least - 1e-12 * size; });
}

/// The vector nearest to the given one that all walls allow: none, one or two of them limit it, model.md 6.3.
std::optional<Vec2> UprightWalls::project(const Vec2 &vector) {
    if (allows(vector, 0.0)) return vector;
    double size = std::abs(vector.x) + std::abs(vector.y);
    for (uint32_t i = 0; i < m_count; ++i) {
        if (m_walls[i].least > -INFINITY) size += std::abs(m_walls[i].least);
    }
    for (uint32_t i = 0; i < m_count; ++i) {
        Wall &wall = m_walls[i];
        const double into = glm::dot(vector, wall.normal);
        if (into >= wall.least) continue;
        const Vec2 along = (vector - into * wall.normal) + wall.least * wall.normal;
        if (!allows(along, size)) continue;
        wall.isActive = true;
        return along;
    }
    for (uint32_t i = 0; i < m_count; ++i) {
        for (uint32_t j = i + 1; j < m_count; ++j) {
            Wall &a = m_walls[i];
            Wall &b = m_walls[j];
            const double turn = cross(a.normal, b.normal);
            if (std::abs(turn) <= 1e-9 || a.least == -INFINITY || b.least == -INFINITY) continue;
            const Vec2 corner{(a.least * b.normal.y - b.least * a.normal.y) / turn,
                              (b.least * a.normal.x - a.least * b.normal.x) / turn};
            if (!allows(corner, size)) continue;
            a.isActive = b.isActive = true;
            return corner;
        }
    }
    return {};
}

void UprightWalls::arrive(const Scene &scene, Ball &ball) const {
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = *m_walls[i].contact;
        if (!m_walls[i].isActive || !contact.isFace()) continue;
        const int axis = contact.sides[0] ? 0 : 1;
        ball.position[axis] = contact.point[axis] + contact.sides[axis] * scene.radius;
        if (contact.gap <= scene.tolerance) ball.velocity[axis] = 0.0;
    }
}

} // namespace phys
