// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh.h"

#include <array>
#include <span>

namespace inspector::gl {

/// Builds a mesh piece by piece. A piece is cut from one plank: its grain runs along its longer horizontal side and has
/// an origin of its own.
class MeshBuilder {
public:
    void beginPiece(const Material &material, const Bounds &bounds);
    /// Counter-clockwise seen from outside; normals of unit length.
    void triangle(const std::array<glm::vec3, 3> &positions, const std::array<glm::vec3, 3> &normals);
    /// A flat convex polygon.
    void polygon(std::span<const glm::vec3> corners, const glm::vec3 &normal);

    Mesh take();

private:
    std::uint32_t indexOf(const Vertex &vertex);
    glm::vec2 grainCoordinate(const glm::vec3 &position, const glm::vec3 &normal) const;

    Mesh m_mesh;
    std::size_t m_pieceBegin = 0; ///< first vertex of the current piece
    Vertex m_prototype{};         ///< carries the current piece's material
    bool m_alongY = false;
    glm::vec2 m_grainOrigin{0.0F};
    unsigned m_pieces = 0;
};

enum class BoxKind { Floor, Wall, Rim, Exit };

struct MazeBox {
    glm::dvec3 minimum{0.0}; ///< m, board frame
    glm::dvec3 maximum{0.0};
    BoxKind kind = BoxKind::Wall;
};

/// The default material of each kind, used where there is no .mtl.
Material boxMaterial(BoxKind kind);

/// A maze mesh made from its boxes alone; top edges are chamfered so that they catch the light.
Mesh mazeFromBoxes(std::span<const MazeBox> boxes);

/// A ball of radius 1 with a pattern that makes rolling visible.
Mesh patternedBall();

} // namespace inspector::gl
