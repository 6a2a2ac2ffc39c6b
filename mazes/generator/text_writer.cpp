// SPDX-License-Identifier: MIT
#include "generator/numbers.h"
#include "generator/writers.h"

namespace mazes {

namespace {

std::string spaced(const Point &point) {
    return " " + metres(point[0]) + " " + metres(point[1]) + " " + metres(point[2]);
}

} // namespace

std::string textFile(const Board &board, std::string_view generator) {
    std::string text = "physics-maze 1\nunits m\ngenerator ";
    text.append(generator).append("\n");
    text += "ball " + metres(board.dimensions.ballRadius) + "\n";
    text += "start" + spaced(board.start) + "\n";
    for (const Box &box : board.boxes) text += "box" + spaced(box.min) + spaced(box.max) + "\n";
    return text;
}

} // namespace mazes
