// SPDX-License-Identifier: MIT
// Charts for a page of paper: a gnuplot program with its data, and what gnuplot draws from it as .svg and .png.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bench {

struct ChartPoint {
    double x, y;
};

enum class Look {
    Ours,     // full line, filled marks
    Peer,     // dashed line, open marks
    Front,    // broad and pale, behind everything
    Predicted // thin black line without marks
};

struct Curve {
    std::string title; // empty: not in the legend
    Look look = Look::Ours;
    std::vector<ChartPoint> points;
    bool hasMarks = true;
};

// Rectangles coloured by class.
struct ClassMap {
    std::vector<std::string> classes;
    std::vector<std::string> colours; // "#rrggbb", one for each class
    struct Cell {
        double x0, y0, x1, y1;
        int cls;
    };
    std::vector<Cell> cells;
};

struct Label {
    double x, y; // of the point it stands to the right of
    std::string text;
};

struct Axis {
    std::string label;
    bool logarithmic = false;
    double low = 0; // low == high: from the data
    double high = 0;
};

struct Chart {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
    std::vector<Label> labels;
    ClassMap map;
    bool hasLegend = true; // at the right of all panels: at most one panel should have it
};

// Draws the panels in rows of so many columns. Writes FILE.gp, FILE.svg and FILE.png side by side and leaves out the
// pictures if there is no gnuplot (returns false).
bool drawCharts(const std::vector<Chart> &panels, int columns, const std::filesystem::path &file);

} // namespace bench
