// SPDX-License-Identifier: MIT
#include "generator/numbers.h"
#include "generator/writers.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mazes {

namespace {

// The ball is a cube of kSquares x kSquares squares per face, projected onto the sphere. Neighbouring faces have their
// own copies of the vertices on common edges, with equal positions and normals, so no seam shows.
constexpr int kSquares = 12;
constexpr int kDotRadius = 3; // half squares from the middle of a face to the centres of its dot's outermost squares

using Direction = std::array<double, 3>;

// From the cube [-1, 1]^3 to the unit sphere, with squares of nearly equal size. Needs only + - * / and square root,
// which give the same bits everywhere.
Direction onSphere(const Direction &cube) {
    const double xx = cube[0] * cube[0];
    const double yy = cube[1] * cube[1];
    const double zz = cube[2] * cube[2];
    return {cube[0] * std::sqrt(1 - yy / 2 - zz / 2 + yy * zz / 3),
            cube[1] * std::sqrt(1 - zz / 2 - xx / 2 + zz * xx / 3),
            cube[2] * std::sqrt(1 - xx / 2 - yy / 2 + xx * yy / 3)};
}

// Six decimals of each coordinate.
std::string spaced(const Direction &direction) {
    std::string text;
    for (const double coordinate : direction) text.append(" ").append(millionths(std::llround(coordinate * 1e6)));
    return text;
}

enum class Pattern { Light, Dark, Dot };

constexpr std::array<std::string_view, 3> kPatternNames = {"ball_light", "ball_dark", "ball_dot"};

// Dark and light octants like a crash-test mark, and a dot at each of the six poles: rotation about any axis moves a
// border between colours.
Pattern patternAt(int side, int column, int row) {
    // From the middle of the face to the middle of the square, in half squares.
    const int right = 2 * column + 1 - kSquares;
    const int up = 2 * row + 1 - kSquares;
    if (right * right + up * up <= kDotRadius * kDotRadius + 1) return Pattern::Dot;
    const int octant = side + (right > 0 ? 1 : 0) + (up > 0 ? 1 : 0);
    return octant % 2 == 0 ? Pattern::Light : Pattern::Dark;
}

void appendVertices(int axis, int side, std::string &text) {
    for (int row = 0; row <= kSquares; ++row) {
        for (int column = 0; column <= kSquares; ++column) {
            Direction cube{};
            cube[axis] = 2.0 * side - 1;
            cube[(axis + 1) % 3] = 2.0 * column / kSquares - 1;
            cube[(axis + 2) % 3] = 2.0 * row / kSquares - 1;
            const std::string position = spaced(onSphere(cube));
            text.append("v").append(position).append("\nvn").append(position).append("\n");
        }
    }
}

// Counter-clockwise seen from outside.
std::string square(int axis, int side, int column, int row) {
    const int perRow = kSquares + 1;
    const int first = (axis * 2 + side) * perRow * perRow + row * perRow + column + 1;
    std::array<int, 4> corners = {first, first + 1, first + perRow + 1, first + perRow};
    if (side == 0) std::swap(corners[1], corners[3]);
    std::string text = "f";
    for (const int corner : corners) text += " " + std::to_string(corner) + "//" + std::to_string(corner);
    return text + "\n";
}

} // namespace

std::string ballMeshFile(std::string_view materialFile) {
    std::array<std::string, kPatternNames.size()> squares;
    std::string text = "# mazegen --ball: radius 1\nmtllib ";
    text.append(materialFile).append("\no ball\n");
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
            appendVertices(axis, side, text);
            for (int row = 0; row < kSquares; ++row)
                for (int column = 0; column < kSquares; ++column)
                    squares[static_cast<std::size_t>(patternAt(side, column, row))] += square(axis, side, column, row);
        }
    }
    for (std::size_t pattern = 0; pattern < squares.size(); ++pattern)
        text.append("usemtl ").append(kPatternNames[pattern]).append("\n").append(squares[pattern]);
    return text;
}

std::string ballMaterialFile() {
    return "newmtl ball_light\nKa 0.95 0.93 0.88\nKd 0.95 0.93 0.88\nKs 0.6 0.6 0.6\nNs 120\nillum 2\n\n"
           "newmtl ball_dark\nKa 0.80 0.10 0.12\nKd 0.80 0.10 0.12\nKs 0.6 0.6 0.6\nNs 120\nillum 2\n\n"
           "newmtl ball_dot\nKa 0.08 0.12 0.28\nKd 0.08 0.12 0.28\nKs 0.6 0.6 0.6\nNs 120\nillum 2\n";
}

} // namespace mazes
