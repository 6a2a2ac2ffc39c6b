// SPDX-License-Identifier: MIT
#include "generator/numbers.h"
#include "generator/writers.h"

namespace mazes {

namespace {

std::string vector(const Point &point) {
    return "[" + micrometres(point[0]) + ", " + micrometres(point[1]) + ", " + micrometres(point[2]) + "]";
}

} // namespace

// Micrometres inside the union because they, and the differences that box() takes, are exact in binary: faces that
// touch stay in one plane and the union is watertight.
std::string scadFile(const Board &board, std::string_view generator) {
    std::string text = "// ";
    text.append(generator).append("\n");
    text += "// Coordinates are micrometres, scaled to millimetres for printing.\n"
            "module box(from, to) { translate(from) cube(to - from); }\n\n"
            "scale(0.001) union() {\n";
    for (const Box &box : board.boxes) text += "    box(" + vector(box.min) + ", " + vector(box.max) + ");\n";
    text += "}\n";
    return text;
}

} // namespace mazes
