// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/strokes.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace inspector::gl {

namespace {

Colour faded(const Colour &colour, double factor) {
    return {colour.r, colour.g, colour.b, colour.a * static_cast<float>(factor)};
}

} // namespace

void Strokes::line(const glm::dvec3 &from, const glm::dvec3 &to, const Colour &colour, float width) {
    m_strokes.push_back({from, to, colour, colour, width, 1.0F});
}

void Strokes::point(const glm::dvec3 &position, const Colour &colour, float diameter) {
    m_strokes.push_back({position, position, colour, colour, diameter, 1.0F});
}

void Strokes::arrow(const glm::dvec3 &foot, const glm::dvec3 &direction, double length, const Colour &colour,
                    float width) {
    const glm::dvec3 tip = foot + direction * length;
    // Any vector not parallel to the arrow spans its head's plane.
    const glm::dvec3 helper = std::abs(direction.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 side = glm::normalize(glm::cross(direction, helper)) * (0.12 * length);
    const glm::dvec3 neck = tip - direction * (0.25 * length);
    line(foot, tip, colour, width);
    line(tip, neck + side, colour, width);
    line(tip, neck - side, colour, width);
}

void Strokes::box(const glm::dvec3 &minimum, const glm::dvec3 &maximum, const Colour &colour, float width) {
    for (int axis = 0; axis < 3; ++axis) {
        const int first = (axis + 1) % 3;
        const int second = (axis + 2) % 3;
        for (int corner = 0; corner < 4; ++corner) {
            glm::dvec3 from = minimum;
            if (corner & 1) from[first] = maximum[first];
            if (corner & 2) from[second] = maximum[second];
            glm::dvec3 to = from;
            to[axis] = maximum[axis];
            line(from, to, colour, width);
        }
    }
}

void Strokes::trail(std::span<const glm::dvec3> points, const Colour &colour, float width, double spacing) {
    if (points.size() < 2) return;
    const double last = static_cast<double>(points.size() - 1);
    std::size_t begin = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        // The newest point is never merged, so that the trail ends at the ball.
        if (i + 1 < points.size() && glm::distance(points[begin], points[i]) < spacing) continue;
        const Colour oldColour = faded(colour, static_cast<double>(begin) / last);
        const Colour newColour = faded(colour, static_cast<double>(i) / last);
        m_strokes.push_back({points[begin], points[i], oldColour, newColour, width, 0.0F});
        begin = i;
    }
}

} // namespace inspector::gl
