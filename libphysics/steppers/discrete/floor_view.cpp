// SPDX-License-Identifier: MIT
#include "floor_view.h"

#include "scene/nearest.h"

#include <cmath>

namespace phys {

namespace {

double lengthOf(const Vec3 &way) { return std::abs(way.x) + std::abs(way.y); }

} // namespace

bool FloorView::look(const StepContext &context, const Vec3 &start, const Vec3 &end, double way) {
    const Scene &scene = context.scene();
    const double tolerance = context.setting.tolerance;
    const double touching = scene.radius + tolerance;
    const double furthest = kCandidateReach * scene.radius; // the grid lists no more
    if (touching + way > furthest) return false;
    m_reach = std::min(touching + 1.5 * way, furthest); // for a bounce that leads farther
    const Vec3 low = start - m_reach, high = start + m_reach;
    const double top = start.z - scene.radius;
    m_floor = nullptr;
    m_count = 0;
    m_faceCount = 0;
    for (const uint32_t i : scene.boxesNear(start.x, start.y, scene.hasManyBoxes)) {
        const phys_box &box = scene.boxes[i];
        if (box.max.z <= top + tolerance) { // on the floor, boxes that aren't higher than it can't be hit
            const bool isFloor = box.max.z >= top - tolerance && Scene::isOver(box, start.x, start.y);
            if (isFloor && (!m_floor || box.max.z > m_floor->max.z)) m_floor = &box; // the nearest of them
            continue;
        }
        const bool isFar =
            box.min.x > high.x || box.max.x < low.x || box.min.y > high.y || box.max.y < low.y || box.min.z > high.z;
        if (isFar) continue;
        if (m_count == kMostNear) return false;
        m_near[m_count++] = i;
    }
    return m_floor && Scene::isOver(*m_floor, end.x, end.y);
}

bool FloorView::hasSlopes(const StepContext &context, const Ball &ball) const {
    return std::any_of(m_near.begin(), m_near.begin() + m_count,
                       [&](uint32_t number) { return isSlope(context.scene().boxes[number], ball); });
}

bool FloorView::addFace(const UprightFace &face, double tolerance) {
    for (uint32_t i = 0; i < m_faceCount; ++i) {
        UprightFace &other = m_faces[i];
        if (other.axis != face.axis) continue;
        if (other.normal != face.normal || std::abs(other.gap - face.gap) > tolerance) return false;
        if (face.gap < other.gap) other = face;
        return true;
    }
    m_faces[m_faceCount++] = face;
    return true;
}

bool FloorView::findFaces(const StepContext &context, const Vec3 &start, const Vec3 &end) {
    const Scene &scene = context.scene();
    const double tolerance = context.setting.tolerance;
    const double touching = scene.radius + tolerance;
    const double overlapping = scene.radius - tolerance;
    const Vec3 &p = start;
    std::array<Vec2, kMostNear> edges;
    uint32_t edgeCount = 0;
    for (uint32_t near = 0; near < m_count; ++near) {
        const uint32_t number = m_near[near];
        const phys_box &box = scene.boxes[number];
        const bool isMet =
            squaredDistance(box, p) <= touching * touching || squaredDistance(box, end) < overlapping * overlapping;
        if (!isMet) continue;
        if (box.min.z > p.z || box.max.z < p.z) return false; // a roof or a kerb
        // Near the end of a face the velocity determines what is touched, model.md 13.1; this is left to the general
        // case.
        const auto side = [&](double centre, double low, double high) {
            if (std::abs(centre - low) <= tolerance || std::abs(centre - high) <= tolerance) return 2;
            return centre < low ? -1 : centre > high ? 1 : 0;
        };
        const int x = side(p.x, box.min.x, box.max.x);
        const int y = side(p.y, box.min.y, box.max.y);
        if (x == 2 || y == 2 || (x == 0 && y == 0)) return false;
        if (x != 0 && y != 0) {
            edges[edgeCount++] = {x < 0 ? box.min.x : box.max.x, y < 0 ? box.min.y : box.max.y};
            continue;
        }
        const int axis = x != 0 ? 0 : 1;
        const int normal = x + y;
        const double surface = normal < 0 ? (&box.min.x)[axis] : (&box.max.x)[axis];
        const double gap = (p[axis] - surface) * normal - scene.radius;
        if (gap < -tolerance) return false;
        const UprightFace face{number, axis, static_cast<double>(normal), gap, surface + normal * scene.radius};
        if (!addFace(face, tolerance)) return false;
    }
    // Edges that a face shields from the ball.
    return std::all_of(edges.begin(), edges.begin() + edgeCount, [&](const Vec2 &edge) {
        return std::any_of(m_faces.begin(), m_faces.begin() + m_faceCount, [&](const UprightFace &face) {
            const double surface = face.place - face.normal * scene.radius;
            return (edge[face.axis] - surface) * face.normal <= tolerance;
        });
    });
}

bool FloorView::hasRoom(const StepContext &context, const Vec3 &start, const Vec3 &end) const {
    if (context.radius() + context.setting.tolerance + lengthOf(end - start) > m_reach ||
        !Scene::isOver(*m_floor, end.x, end.y))
        return false;
    const double overlapping = context.radius() - context.setting.tolerance;
    return std::none_of(m_near.begin(), m_near.begin() + m_count, [&](uint32_t box) {
        return squaredDistance(context.scene().boxes[box], end) < overlapping * overlapping;
    });
}

bool FloorView::isClear(const StepContext &context, const Vec2 &low, const Vec2 &high) const {
    const double margin = context.radius() + 2.0 * context.setting.tolerance;
    return std::all_of(m_near.begin(), m_near.begin() + m_count, [&](uint32_t number) {
        const phys_box &box = context.scene().boxes[number];
        for (uint32_t i = 0; i < m_faceCount; ++i) {
            const UprightFace &face = m_faces[i];
            const int along = 1 - face.axis;
            if (face.box == number) return low[along] > (&box.min.x)[along] && high[along] < (&box.max.x)[along];
            const double furthest = face.normal > 0.0 ? (&box.max.x)[face.axis] : (&box.min.x)[face.axis];
            const double surface = face.place - face.normal * context.radius();
            if ((furthest - surface) * face.normal <= context.setting.tolerance) return true; // behind the face
        }
        return low.x - margin > box.max.x || high.x + margin < box.min.x || low.y - margin > box.max.y ||
               high.y + margin < box.min.y;
    });
}

} // namespace phys
