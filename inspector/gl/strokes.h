// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace inspector::gl {

using Colour = glm::vec4; ///< sRGB with straight alpha, 0..1

/// A line of constant screen width; a point is a line of length 0 with round ends.
struct Stroke {
    glm::vec3 from;
    glm::vec3 to;
    Colour fromColour;
    Colour toColour;
    float width;     ///< logical pixels
    float roundEnds; ///< 1: half discs at both ends; 0: flat, so that translucent segments join without darker dots
};

/// Collects strokes by immediate-mode calls; the renderer draws all of them in one flush. Positions in the board frame,
/// m.
class Strokes {
public:
    void line(const glm::dvec3 &from, const glm::dvec3 &to, const Colour &colour, float width = 2.0F);
    void point(const glm::dvec3 &position, const Colour &colour, float diameter = 8.0F);
    /// An arrow of `length` metres from `foot` along the unit vector `direction`.
    void arrow(const glm::dvec3 &foot, const glm::dvec3 &direction, double length, const Colour &colour,
               float width = 2.0F);
    /// The edges of an axis-aligned box.
    void box(const glm::dvec3 &minimum, const glm::dvec3 &maximum, const Colour &colour, float width = 1.5F);
    /// A path, oldest point first, that fades in towards the newest. Points closer than `spacing` metres are merged.
    void trail(std::span<const glm::dvec3> points, const Colour &colour, float width, double spacing);

    void clear() { m_strokes.clear(); }
    bool empty() const { return m_strokes.empty(); }
    const std::vector<Stroke> &all() const { return m_strokes; }

private:
    std::vector<Stroke> m_strokes;
};

} // namespace inspector::gl
