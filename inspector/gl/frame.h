// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture shows (Frame, from the simulation's side) and how it is viewed (View, from the widget). Lengths in
// metres, angles in radians, positions in the board frame (z up from the floor) unless said otherwise.
#pragma once

#include "gl/strokes.h"

#include <array>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace inspector::gl {

enum class Quality {
    Low,    ///< no shadow map
    Medium, ///< 1024 x 1024 shadow map, small soft kernel
    High    ///< 1536 x 1536 shadow map, wide soft kernel, antialiased edges
};
inline constexpr int kQualityCount = 3;

struct Ball {
    glm::dvec3 position{0.0};
    std::array<double, 4> orientation{0.0, 0.0, 0.0, 1.0}; ///< unit quaternion x y z w
    double radius = 0.006;
};

/// A translucent second ball with a tint.
struct GhostBall {
    Ball ball;
    Colour colour{0.25F, 0.55F, 1.0F, 0.55F};
};

/// A path, oldest point first: its alpha grows from 0 to the colour's own at the newest point.
struct Trail {
    std::vector<glm::dvec3> points;
    Colour colour{1.0F, 0.6F, 0.1F, 0.9F};
    float width = 3.0F; ///< logical pixels
};

struct Frame {
    double tiltX = 0.0; ///< slopes along x and y as boardToWorld() takes them
    double tiltY = 0.0;
    Ball ball;
    std::vector<GhostBall> ghosts;
    std::vector<Trail> trails;
    Strokes strokes; ///< lines, points and normals, drawn last; hidden parts show through faintly
};

/// The surroundings of the board: sRGB, 0..1.
struct Backdrop {
    glm::vec3 table{0.80F, 0.80F, 0.81F};
    glm::vec3 horizon{0.93F, 0.94F, 0.95F};
    bool operator==(const Backdrop &) const = default;
};

struct View {
    glm::dmat4 view{1.0};       ///< world to eye; the world is the board frame of a level board
    glm::dmat4 projection{1.0}; ///< eye to clip
    glm::ivec2 pixels{1, 1};    ///< size of the framebuffer in device pixels
    double pixelRatio = 1.0;    ///< device pixels per logical pixel
    Quality quality = Quality::Medium;
    Backdrop backdrop;
};

} // namespace inspector::gl
