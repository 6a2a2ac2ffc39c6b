// SPDX-License-Identifier: MIT
#include "chart/chart.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace bench {

namespace {

constexpr int kPanelWidth = 520; // px
constexpr int kPanelHeight = 420;
constexpr int kLegendWidth = 275; // at the right of all panels

// Colours that remain apart for the colour-blind and in grey.
constexpr std::array<const char *, 6> kOursColours = {"#9ecae1", "#08519c", "#4292c6", "#6a51a3", "#238b45", "#000000"};
constexpr std::array<const char *, 5> kPeerColours = {"#d94801", "#c51b8a", "#8c6d31", "#a50f15", "#737373"};

// 'quoted'; gnuplot doubles a quote inside.
std::string quoted(const std::string &text) {
    std::string result = "'";
    for (const char letter : text) result += letter == '\'' ? std::string("''") : std::string(1, letter);
    return result + "'";
}

std::string blockName(std::size_t panel, std::size_t curve) {
    return "$panel" + std::to_string(panel) + "_" + std::to_string(curve);
}

void writeData(std::ostream &out, const Chart &chart, std::size_t panel) {
    for (std::size_t curve = 0; curve < chart.curves.size(); ++curve) {
        out << blockName(panel, curve) << " << EOD\n";
        for (const ChartPoint &point : chart.curves[curve].points) out << point.x << " " << point.y << "\n";
        out << "EOD\n";
    }
    for (std::size_t cls = 0; cls < chart.map.classes.size(); ++cls) {
        out << blockName(panel, chart.curves.size() + cls) << " << EOD\n";
        for (const auto &cell : chart.map.cells)
            if (cell.cls == static_cast<int>(cls))
                out << cell.x0 << " " << cell.y0 << " " << cell.x0 << " " << cell.x1 << " " << cell.y0 << " " << cell.y1
                    << "\n";
        out << "EOD\n";
    }
}

struct Counters {
    std::size_t ours = 0;
    std::size_t peers = 0;
};

std::string lineOf(const char *width, const char *dashes, const char *colour, const Curve &curve, std::size_t mark) {
    const std::string line = std::string(" lw ") + width + dashes + " lc rgb '" + colour + "'";
    if (!curve.hasMarks) return "with lines" + line;
    return "with linespoints" + line + " ps 0.8 pt " + std::to_string(mark);
}

std::string styleOf(const Curve &curve, Counters &counters) {
    constexpr std::size_t kMarks = 5; // gnuplot's 4 to 13: open and filled in turn
    if (curve.look == Look::Ours) {
        const std::size_t index = counters.ours++;
        return lineOf("2.2", "", kOursColours[index % kOursColours.size()], curve, 5 + 2 * (index % kMarks));
    }
    if (curve.look == Look::Peer) {
        const std::size_t index = counters.peers++;
        return lineOf("1.4", " dt 2", kPeerColours[index % kPeerColours.size()], curve, 4 + 2 * (index % kMarks));
    }
    if (curve.look == Look::Front) return "with linespoints lw 9 pt 7 ps 2.2 lc rgb '#ffe082'";
    return "with lines lw 1.6 lc rgb '#000000'";
}

// Cells of one class; one that doesn't occur stays in the legend.
std::string plotOf(const Chart &chart, std::size_t cls, const std::string &block) {
    const bool occurs = std::any_of(chart.map.cells.begin(), chart.map.cells.end(),
                                    [cls](const ClassMap::Cell &cell) { return cell.cls == static_cast<int>(cls); });
    return (occurs ? block + " using 1:2:3:4:5:6" : std::string("keyentry")) +
           " with boxxyerror fs solid 1 noborder lc rgb '" + chart.map.colours[cls] + "' title " +
           quoted(chart.map.classes[cls]);
}

void writeAxis(std::ostream &out, const char *name, const Axis &axis) {
    out << "set " << name << "label " << quoted(axis.label) << "\n";
    out << (axis.logarithmic ? "set logscale " : "unset logscale ") << name << "\n";
    out << "set format " << name << (axis.logarithmic ? " '10^{%T}'\n" : " '%g'\n");
    if (axis.low < axis.high)
        out << "set " << name << "range [" << axis.low << ":" << axis.high << "]\n";
    else
        out << "set " << name << "range [*:*]\n";
}

void writePlot(std::ostream &out, const Chart &chart, std::size_t panel) {
    out << "set title " << quoted(chart.title) << "\n";
    out << (chart.hasLegend ? "set key at screen 0.995,0.97 right top reverse Left samplen 2\n" : "unset key\n");
    out << "unset label\n";
    for (const Label &label : chart.labels)
        out << "set label " << quoted(label.text) << " at " << label.x << "," << label.y
            << " offset character 1.5,0.8\n";
    writeAxis(out, "x", chart.x);
    writeAxis(out, "y", chart.y);
    std::vector<std::string> plots;
    for (std::size_t cls = 0; cls < chart.map.classes.size(); ++cls)
        plots.push_back(plotOf(chart, cls, blockName(panel, chart.curves.size() + cls)));
    Counters counters;
    for (std::size_t curve = 0; curve < chart.curves.size(); ++curve) {
        const Curve &drawn = chart.curves[curve];
        const std::string style = styleOf(drawn, counters);
        if (drawn.points.empty()) continue;
        const std::string title = drawn.title.empty() ? "notitle" : "title " + quoted(drawn.title);
        std::string plot = blockName(panel, curve);
        plot.append(" using 1:2 ").append(style).append(" ").append(title);
        plots.push_back(plot);
    }
    for (std::size_t plot = 0; plot < plots.size(); ++plot) out << (plot == 0 ? "plot " : ", \\\n     ") << plots[plot];
    out << "\n";
}

void writeProgram(std::ostream &out, const std::vector<Chart> &panels, int columns, const std::filesystem::path &file) {
    const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
    const int width = columns * kPanelWidth + kLegendWidth;
    const int height = rows * kPanelHeight;
    const std::string size = std::to_string(width) + "," + std::to_string(height);
    out << "# Draws " << file.filename().string() << ".svg and .png from the data below: gnuplot "
        << file.filename().string() << ".gp\n";
    for (std::size_t panel = 0; panel < panels.size(); ++panel) writeData(out, panels[panel], panel);
    out << "set grid lc rgb '#dddddd' lt 1\nset border 3 lc rgb '#444444'\nset tics nomirror\n";
    for (const char *terminal : {"svg", "pngcairo"}) {
        const std::string extension = terminal == std::string("svg") ? ".svg" : ".png";
        out << "set terminal " << terminal << " size " << size << " font 'DejaVu Sans,11' background rgb 'white'\n"
            << "set output " << quoted(file.filename().string() + extension) << "\n"
            << "set multiplot layout " << rows << "," << columns << " margins screen " << 90.0 / width << ","
            << 1 - (kLegendWidth + 15.0) / width << "," << 55.0 / height << "," << 1 - 45.0 / height
            << " spacing screen " << 90.0 / width << "," << 100.0 / height << "\n";
        for (std::size_t panel = 0; panel < panels.size(); ++panel) writePlot(out, panels[panel], panel);
        out << "unset multiplot\nset output\n";
    }
}

} // namespace

bool drawCharts(const std::vector<Chart> &panels, int columns, const std::filesystem::path &file) {
    std::filesystem::path program = file;
    program += ".gp";
    std::ofstream out(program);
    out.precision(9);
    writeProgram(out, panels, columns, file);
    out.close();
    if (!out) throw std::runtime_error(program.string() + ": can't be written");
    const std::string command =
        "cd '" + file.parent_path().string() + "' && gnuplot '" + program.filename().string() + "'";
    return std::system(command.c_str()) == 0;
}

} // namespace bench
