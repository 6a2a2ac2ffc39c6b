// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/option_table.h"

#include "core/setup/tables.h"
#include "core/track/fit_quantity.h"
#include "core/trade/unknowns.h"

#include <QCommandLineParser>

namespace inspector {

namespace {

QString valueName(const phys_param_row &row) {
    if (row.flags & PHYS_ROW_CHOICE) return choicesOf(row).join(QLatin1Char('|'));
    return row.unit[0] ? QString::fromUtf8(row.unit) : QStringLiteral("number");
}

QString utf8(const char *text) { return QString::fromUtf8(text); }

void addRunOptions(QCommandLineParser &parser) {
    parser.addOptions({
        {"level", utf8("Level to open: its number, or the path of a maze text file. Default 1, or the first."),
         utf8("number|file")},
        {"stepper", utf8("Stepper to compute with; --list-steppers shows them. Default " PHYS_STEPPER_DEFAULT "."),
         "id"},
        {"dt", utf8("Length of a step, 1e-6 to 10 s: as 0.01, 5ms, 20us or 1/60. Default 0.01."), QStringLiteral("s")},
        {"speed", utf8("Simulated seconds per second, 1/16 to 16; no effect with --headless. Default 1."), "factor"},
        {"plugin",
         utf8("Load the steppers of this plugin file; may be repeated. The plugins in the folders of PHYS_PLUGIN_PATH "
              "and in physics-1 beside the library are there without it."),
         "file"},
        {"parameters",
         utf8("Take parameters from this text file, as the window exports them: lines 'set rolling_friction 0.002'. "
              "Options of single parameters come after it."),
         "file"},
        {"autopilot", utf8("Let the autopilot tilt the board.")},
        {"duration",
         utf8("End after so many simulated seconds, with the first whole step that reaches them. Default with "
              "--headless: when the ball is out of the maze, after "
              "60 s at the latest, with --autopilot 600 s."),
         QStringLiteral("s")},
        {"headless", utf8("Run without a window, as fast as possible, and write a table of the steps (CSV).")},
    });
}

void addTableOptions(QCommandLineParser &parser) {
    parser.addOptions({
        {"csv",
         utf8("Write the table to this file, and beside it into FILE.txt the settings that made it; -: the table alone "
              "to "
              "standard output. Default with --headless: that."),
         "file"},
        {"csv-every", utf8("Write every so many-th step. Default 1."), "steps"},
        {"record",
         utf8("Record the run into this text file: inputs, versions and the hash of every state, through restarts and "
              "other levels until the program ends."),
         "file"},
        {"replay",
         utf8("Open the window with this recording and play it; --headless: run its inputs again without a window and "
              "write the table; status 1 if a step differs."),
         "file"},
        {"check",
         utf8("With --replay, without a window: print 'same' or the first step that differs, instead of the table.")},
    });
}

void addComparisonOptions(QCommandLineParser &parser) {
    parser.addOptions({
        {"compare",
         utf8("Compare with a second ball, which this stepper moves under the same inputs: without a window by columns "
              "of the table, in the window as a ghost."),
         utf8("id")},
        {"compare-substeps",
         utf8(
             "With --compare: so many steps of the second ball, of dt over so many, for each of the first. Default 1."),
         utf8("number")},
        {"compare-set",
         utf8("With --compare: parameters of the second ball, as restitution_wall=0.6,rolling_friction=0.004; the "
              "others, and the tilts, are the first ball's."),
         utf8("list")},
    });
}

void addWindowOptions(QCommandLineParser &parser) {
    parser.addOptions({
        {"force",
         utf8("Let --csv, --record, --grab and --plot take the place of a file of another kind, or of a recording.")},
        {"grab",
         utf8("Save a picture of the window at the end of the run, and quit. With --replay: of the recording's end, or "
              "at --duration."),
         "file.png"},
        {"shaders",
         utf8("Draw with the GLSL files in this folder instead of the embedded ones of the same names; a file that is "
              "saved takes effect at once."),
         utf8("folder")},
        {"view",
         utf8("Draw the board by OpenGL, or flat, from above, without it. Default: 3d where there is OpenGL 3.3."),
         "3d|2d"},
        {"all-levels",
         utf8(
             "Play all levels without a window by the autopilot, print a line for each; status 1 unless all are won.")},
    });
}

void addTradeOptions(QCommandLineParser &parser) {
    parser.addOptions({
        {"trade",
         utf8("Measure what every stepper and step size costs on this level, what it is wrong by against stepper "
              "exact, and recommend a setting; without a window. Takes some seconds, and shows its progress on a "
              "terminal."),
         utf8("number|file")},
        {"schedule",
         utf8("With --trade, how the board tilts: autopilot (hardly meets a wall), busy (random tilts that lead to "
              "many walls), both of these, random:SEED, or a file: times and tilts, a table from --csv or a recording "
              "(its last run). Default both."),
         utf8("schedule")},
        {"steps",
         utf8(
             "With --trade: these step sizes (0.01, 5ms, 1/60), or with a + before them these besides the usual ones."),
         utf8("list")},
        {"under",
         utf8("With --trade: recommend the cheapest that keeps the position error at or under this. Default 1mm."),
         utf8("length, as 1mm or 0.1R")},
        {"unknown",
         utf8("With --trade: what isn't known exactly, tilt, start or a parameter by its name, and by how much; shows "
              "how far off the ball is by that alone, and recommends the cheapest setting whose error stays below a "
              "share of it. none: no such answer. Default ") +
             usualUnknowns() + QLatin1Char('.'),
         utf8("list")},
        {"share", utf8("With --unknown: that share, above 0 to 1. Default 0.25."), utf8("number")},
        {"with-orientation", utf8("With --trade: let steppers turn the ball, too, which only drawing needs.")},
        {"for",
         utf8("With --trade: ask for so long. Default with --unknown 1 s, with --under as long as can be compared."),
         QStringLiteral("s")},
        {"within", utf8("With --trade: recommend the most accurate that takes at most so long for a step."),
         utf8("ns")},
        {"plot", utf8("With --trade: draw the chart into this file."), utf8("file.svg|pdf|png")},
    });
}

void addTrackOptions(QCommandLineParser &parser) {
    parser.addOptions({
        {"fit",
         utf8(
             "Find the board on which the computed ball rolls like a measured one, with intervals and a verdict on the "
             "models; without a window. The file is a table with columns t, x, y and, if measured, tilt_x, tilt_y."),
         utf8("file.csv")},
        {"fit-for",
         utf8("With --fit: look for these; tilt is both offsets, frame is where the tracker's frame is on the board. "
              "Default ") +
             usualFitQuantities() + QLatin1Char('.'),
         utf8("list")},
        {"track", utf8("Open the window with this table of a measured ball, as --fit reads it, laid over the run."),
         utf8("file.csv")},
        {"track-units",
         utf8("With --fit or --track: what the columns' names don't say, as t=ms, x=mm, tilt=rad, px=0.25mm, fps=60, "
              "mirror=y."),
         utf8("list")},
        {"track-frame",
         utf8("With --fit or --track: the tracker's frame on the board: place of its origin [mm], angle [deg], scale. "
              "Default 0,0,0,1."),
         utf8("x,y,angle,scale")},
    });
}

void addListOptions(QCommandLineParser &parser) {
    parser.addOptions({
        {"list-steppers", utf8("Print the steppers that can be chosen.")},
        {"list-parameters", utf8("Print the parameters with unit, range and default.")},
    });
}

/// An option and others that depend on it, or exclude it.
struct OptionRule {
    QString option;
    QStringList others;
};

/// The others have no effect without the option.
const std::vector<OptionRule> &dependentOptions() {
    static const std::vector<OptionRule> rules{
        {"compare", {"compare-substeps", "compare-set"}},
        {"trade", {"schedule", "steps", "under", "for", "within", "plot", "unknown", "share", "with-orientation"}},
        {"fit", {"fit-for"}},
    };
    return rules;
}

/// The option decides what the others would set, or writes none of what they ask for.
const std::vector<OptionRule> &exclusiveOptions() {
    static const std::vector<OptionRule> rules{
        {"all-levels", {"csv", "csv-every", "level"}},
        {"compare", {"all-levels", "trade"}},
        {"record", {"all-levels", "trade"}},
        {"trade",
         {"level", "stepper", "dt", "speed", "all-levels", "autopilot", "csv-every", "grab", "shaders", "view"}},
        {"fit",
         {"trade", "replay", "record", "compare", "stepper", "dt", "speed", "duration", "all-levels", "autopilot",
          "csv-every", "grab", "shaders", "view", "track"}},
    };
    return rules;
}

} // namespace

QString dashed(QString id) { return id.replace(QLatin1Char('_'), QLatin1Char('-')); }

QString optionName(const phys_param_row &row) { return dashed(QString::fromUtf8(row.id)); }

void addOptions(QCommandLineParser &parser, const std::vector<const phys_param_row *> &rows) {
    addRunOptions(parser);
    addTableOptions(parser);
    addComparisonOptions(parser);
    addWindowOptions(parser);
    addTradeOptions(parser);
    addTrackOptions(parser);
    addListOptions(parser);
    parser.addVersionOption();
    parser.addOption({{"h", "help"}, utf8("Print this help.")});
    for (const phys_param_row *row : rows) parser.addOption({optionName(*row), utf8(row->help), valueName(*row)});
}

QString conflictOf(const QCommandLineParser &parser) {
    for (const auto &[option, others] : dependentOptions())
        for (const QString &other : others)
            if (parser.isSet(other) && !parser.isSet(option))
                return QStringLiteral("--%1: needs --%2").arg(other, option);
    for (const auto &[option, others] : exclusiveOptions())
        for (const QString &other : others)
            if (parser.isSet(other) && parser.isSet(option))
                return QStringLiteral("--%1: doesn't go with --%2").arg(option, other);
    const bool hasTable = parser.isSet("csv") || (parser.isSet("headless") && !parser.isSet("check"));
    if (parser.isSet("csv-every") && !hasTable) return QStringLiteral("--csv-every: no table is written without --csv");
    if (parser.isSet("within") && (parser.isSet("under") || parser.isSet("for")))
        return QStringLiteral("--within: takes neither --under nor --for");
    return {};
}

} // namespace inspector
