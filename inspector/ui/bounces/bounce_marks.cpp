// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bounces/bounce_marks.h"

#include "ui/parts/board_vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <QLineF>

#include <glm/geometric.hpp>

namespace inspector::ui {

namespace {

constexpr double kMouseReach = 10.0; ///< logical pixels
const gl::Colour kColour{0.72F, 0.06F, 0.36F, 0.95F};
const gl::Colour kSelectedColour{0.98F, 0.12F, 0.50F, 1.0F};
constexpr float kOldest = 0.25F;      ///< share of the newest mark's alpha
constexpr double kNormalLength = 1.4; ///< radii
constexpr double kSelectedLength = 3.0;
constexpr double kRingRadius = 0.5;
constexpr int kRingPieces = 24;

bool hasBox(const LoggedEvent &event) { return event.event.box != PHYS_NO_BOX; }

bool isSelected(const BounceMarks &marks, const LoggedEvent &event) {
    return marks.selected && marks.selected->number == event.number;
}

/// Slightly above the surface, so that it isn't half hidden.
glm::dvec3 footOf(const LoggedEvent &event, double radius) {
    return toGlm(event.event.point) + 0.05 * radius * toGlm(event.event.normal);
}

void addMark(gl::Strokes &strokes, const LoggedEvent &event, double radius, const gl::Colour &colour) {
    const glm::dvec3 foot = footOf(event, radius);
    strokes.point(foot, colour, 5.0F);
    strokes.arrow(foot, toGlm(event.event.normal), kNormalLength * radius, colour, 2.0F);
}

/// A ring in the plane perpendicular to `normal`.
void addRing(gl::Strokes &strokes, const glm::dvec3 &middle, const glm::dvec3 &normal, double radius) {
    const glm::dvec3 helper = std::abs(normal.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = radius * glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 up = glm::cross(normal, right);
    glm::dvec3 from = middle + right;
    for (int i = 1; i <= kRingPieces; ++i) {
        const double angle = 2.0 * 3.141592653589793 * i / kRingPieces;
        const glm::dvec3 to = middle + std::cos(angle) * right + std::sin(angle) * up;
        strokes.line(from, to, kSelectedColour, 2.5F);
        from = to;
    }
}

void addSelected(gl::Strokes &strokes, const LoggedEvent &event, const phys_scene *scene) {
    const double radius = phys_scene_radius(scene);
    const glm::dvec3 foot = footOf(event, radius);
    if (!hasBox(event)) return addRing(strokes, foot, {0.0, 0.0, 1.0}, kRingRadius * radius);
    if (event.event.box < phys_scene_box_count(scene)) {
        const phys_box &box = phys_scene_boxes(scene)[event.event.box];
        strokes.box(toGlm(box.min), toGlm(box.max), kSelectedColour, 2.0F);
    }
    const glm::dvec3 normal = toGlm(event.event.normal);
    strokes.arrow(foot, normal, kSelectedLength * radius, kSelectedColour, 4.0F);
    addRing(strokes, foot, normal, kRingRadius * radius);
}

/// Whether the segment from `from` to `to` passes through the inside of the box.
bool isBetween(const phys_box &box, const glm::dvec3 &from, const glm::dvec3 &to) {
    const glm::dvec3 low = toGlm(box.min);
    const glm::dvec3 high = toGlm(box.max);
    double enter = 0.0;
    double leave = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double run = to[axis] - from[axis];
        if (run == 0.0) {
            if (from[axis] <= low[axis] || from[axis] >= high[axis]) return false;
            continue;
        }
        const double one = (low[axis] - from[axis]) / run;
        const double other = (high[axis] - from[axis]) / run;
        enter = std::max(enter, std::min(one, other));
        leave = std::min(leave, std::max(one, other));
    }
    return enter < leave;
}

bool isVisible(const glm::dvec3 &eye, const glm::dvec3 &point, const phys_scene *scene) {
    const std::span boxes(phys_scene_boxes(scene), phys_scene_box_count(scene));
    return std::none_of(boxes.begin(), boxes.end(), [&](const phys_box &box) { return isBetween(box, eye, point); });
}

/// The end points of a mark as drawn.
std::array<glm::dvec3, 2> endsOf(const LoggedEvent &event, double radius) {
    const glm::dvec3 foot = footOf(event, radius);
    return {foot, foot + kNormalLength * radius * toGlm(event.event.normal)};
}

/// The distance of a pixel from a line segment.
double distanceTo(const QPointF &pixel, const QPointF &from, const QPointF &to) {
    const QPointF run = to - from;
    const double square = QPointF::dotProduct(run, run);
    const double place = square > 0.0 ? std::clamp(QPointF::dotProduct(pixel - from, run) / square, 0.0, 1.0) : 0.0;
    return QLineF(pixel, from + place * run).length();
}

} // namespace

void addMarks(gl::Strokes &strokes, const BounceMarks &marks, const phys_scene *scene) {
    const double radius = phys_scene_radius(scene);
    const auto count = float(marks.recent.size());
    for (size_t i = 0; i < marks.recent.size(); ++i) {
        if (isSelected(marks, marks.recent[i])) continue;
        gl::Colour colour = kColour;
        colour.a *= kOldest + (1.0F - kOldest) * float(i + 1) / count;
        addMark(strokes, marks.recent[i], radius, colour);
    }
    if (marks.selected) addSelected(strokes, *marks.selected, scene);
}

std::optional<uint64_t> markAt(const gl::MazeView &view, const gl::Ray &ray, const BounceMarks &marks,
                               const phys_scene *scene) {
    const double radius = phys_scene_radius(scene);
    const QPointF pixel = view.positionOf(ray.origin + ray.direction);
    std::optional<uint64_t> best;
    double nearest = kMouseReach;
    const auto consider = [&](const LoggedEvent &event) {
        const auto [foot, tip] = endsOf(event, radius);
        const double distance = distanceTo(pixel, view.positionOf(foot), view.positionOf(tip));
        if (distance >= nearest) return;
        if (!isVisible(ray.origin, foot, scene) && !isVisible(ray.origin, tip, scene)) return;
        nearest = distance;
        best = event.number;
    };
    // Try the topmost mark first.
    if (marks.selected) consider(*marks.selected);
    std::for_each(marks.recent.rbegin(), marks.recent.rend(), consider);
    return best;
}

} // namespace inspector::ui
