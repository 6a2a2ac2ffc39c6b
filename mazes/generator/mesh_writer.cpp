// SPDX-License-Identifier: MIT
#include "generator/numbers.h"
#include "generator/writers.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mazes {

namespace {

constexpr Length kBevel = kMillimetre / 2;

struct MaterialRow {
    Material material;
    std::string_view name;
    std::string_view colours; // ambient, diffuse, specular, shininess
};

constexpr std::array<MaterialRow, 4> kMaterials = {{
    {Material::Floor, "floor", "Ka 0.78 0.60 0.40\nKd 0.78 0.60 0.40\nKs 0.12 0.11 0.10\nNs 24\n"},
    {Material::Exit, "exit", "Ka 0.10 0.72 0.42\nKd 0.10 0.72 0.42\nKs 0.25 0.25 0.25\nNs 48\nKe 0.02 0.16 0.09\n"},
    {Material::Rim, "rim", "Ka 0.27 0.15 0.09\nKd 0.27 0.15 0.09\nKs 0.28 0.26 0.24\nNs 64\n"},
    {Material::Wall, "wall", "Ka 0.50 0.29 0.16\nKd 0.50 0.29 0.16\nKs 0.20 0.18 0.16\nNs 40\n"},
}};

std::string_view materialName(Material material) {
    for (const MaterialRow &row : kMaterials)
        if (row.material == material) return row.name;
    return {};
}

// A box with bevelled edges has 24 vertices: at each of the 8 corners one per adjoining face, moved inwards along the
// other two axes. Each carries the normal of its face; across the bevels between them shading turns smoothly.
using Corner = std::array<int, 3>; // per axis 0 at the box's minimum, 1 at its maximum

// Position of a vertex in the box's list of 24; `axis` says which of the corner's three faces.
int vertexOf(int axis, const Corner &corner) {
    return (axis * 2 + corner[axis]) * 4 + corner[(axis + 1) % 3] + 2 * corner[(axis + 2) % 3];
}

struct Face {
    int count = 0;
    std::array<int, 4> vertices{}; // counter-clockwise seen from outside
};

Face facing(Face face, bool outwards) {
    if (!outwards) std::reverse(face.vertices.begin(), face.vertices.begin() + face.count);
    return face;
}

Corner cornerAt(int axis, int side, int next, int afterNext) {
    Corner corner{};
    corner[axis] = side;
    corner[(axis + 1) % 3] = next;
    corner[(axis + 2) % 3] = afterNext;
    return corner;
}

Face flatFace(int axis, int side) {
    const auto at = [&](int next, int afterNext) { return vertexOf(axis, cornerAt(axis, side, next, afterNext)); };
    return facing({4, {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}}, side == 1);
}

// The strip between the faces across `axis` and across the next axis.
Face bevelFace(int axis, int side, int nextSide) {
    const int next = (axis + 1) % 3;
    const Corner low = cornerAt(axis, side, nextSide, 0);
    const Corner high = cornerAt(axis, side, nextSide, 1);
    return facing({4, {vertexOf(axis, low), vertexOf(next, low), vertexOf(next, high), vertexOf(axis, high)}},
                  side == nextSide);
}

Face cornerFace(const Corner &corner) {
    return facing({3, {vertexOf(0, corner), vertexOf(1, corner), vertexOf(2, corner)}},
                  (corner[0] + corner[1] + corner[2]) % 2 == 1);
}

std::array<Face, 26> bevelledBoxFaces() {
    std::array<Face, 26> faces{};
    std::size_t count = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
            faces[count++] = flatFace(axis, side);
            faces[count++] = bevelFace(axis, side, 0);
            faces[count++] = bevelFace(axis, side, 1);
        }
    }
    for (int corner = 0; corner < 8; ++corner)
        faces[count++] = cornerFace({corner & 1, (corner >> 1) & 1, (corner >> 2) & 1});
    return faces;
}

Length bevelOf(const Box &box) {
    Length bevel = kBevel;
    for (std::size_t axis = 0; axis < 3; ++axis) bevel = std::min(bevel, (box.max[axis] - box.min[axis]) / 4);
    return bevel;
}

// The edges of the underside stay sharp, so that a wall meets its floor without a gap.
Point vertexPosition(const Box &box, Length bevel, int axis, const Corner &corner) {
    Point position{};
    for (int other = 0; other < 3; ++other) {
        const bool isSharp = other == axis || (other == 2 && corner[2] == 0);
        const Length inset = isSharp ? 0 : bevel;
        position[other] = corner[other] == 1 ? box.max[other] - inset : box.min[other] + inset;
    }
    return position;
}

void appendVertices(const Box &box, std::string &text) {
    const Length bevel = bevelOf(box);
    for (int vertex = 0; vertex < 24; ++vertex) {
        const int axis = vertex / 8;
        const Corner corner = cornerAt(axis, (vertex / 4) % 2, vertex % 2, (vertex / 2) % 2);
        const Point position = vertexPosition(box, bevel, axis, corner);
        text += "v " + metres(position[0]) + " " + metres(position[1]) + " " + metres(position[2]) + "\n";
    }
}

void appendFaces(std::size_t verticesBefore, std::string &text) {
    static const std::array<Face, 26> faces = bevelledBoxFaces();
    for (const Face &face : faces) {
        text += "f";
        for (int i = 0; i < face.count; ++i) {
            const int vertex = face.vertices[i];
            const std::size_t position = verticesBefore + static_cast<std::size_t>(vertex) + 1;
            text += " " + std::to_string(position) + "//" + std::to_string(vertex / 4 + 1);
        }
        text += "\n";
    }
}

} // namespace

std::string meshFile(const Board &board, std::string_view generator, std::string_view materialFile) {
    std::string text = "# ";
    text.append(generator).append("\nmtllib ").append(materialFile).append("\n");
    // In the order of vertexOf: a vertex's normal is the number of its face.
    text += "vn -1 0 0\nvn 1 0 0\nvn 0 -1 0\nvn 0 1 0\nvn 0 0 -1\nvn 0 0 1\n";
    for (std::size_t index = 0; index < board.boxes.size(); ++index) {
        const std::string_view material = materialName(board.boxes[index].material);
        text.append("o ").append(material).append("_").append(std::to_string(index)).append("\n");
        appendVertices(board.boxes[index], text);
        text.append("usemtl ").append(material).append("\n");
        appendFaces(24 * index, text);
    }
    return text;
}

std::string meshMaterialFile() {
    std::string text;
    for (const MaterialRow &row : kMaterials) {
        if (!text.empty()) text += "\n";
        text.append("newmtl ").append(row.name).append("\n").append(row.colours).append("illum 2\n");
    }
    return text;
}

} // namespace mazes
