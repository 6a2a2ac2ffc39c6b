// SPDX-License-Identifier: MIT
#include "generator/command_line.h"

#include "generator/numbers.h"

#include <algorithm>
#include <array>
#include <map>

namespace mazes {

namespace {

constexpr int kLargestSide = 200; // cells
constexpr std::string_view kDefaultPrefix = "maze";

struct OptionRow {
    std::string_view name;
    std::string_view value;
    std::string_view help;
};

constexpr OptionRow kSeed = {"--seed", "N", "the maze's number, a whole number below 2^64; required"};
constexpr OptionRow kCells = {"--cells", "WxH", "columns x rows, each from 2 to 200; required"};
constexpr OptionRow kAlgorithm = {"--algorithm", "NAME", "how passages are chosen; default backtracker"};
constexpr OptionRow kLoops = {"--loops", "FRACTION", "share of inner walls to open besides, from 0 to 1; default 0"};
constexpr OptionRow kOut = {"--out", "PREFIX",
                            "writes PREFIX.txt .obj .mtl .scad; its name without white space; default maze"};
constexpr OptionRow kLevels = {"--levels", "FOLDER", "writes the game's levels there instead"};
constexpr OptionRow kBall = {"--ball", "FOLDER", "writes the ball's mesh there, ball.obj and ball.mtl"};

constexpr OptionRow kHelp = {"-h, --help", "", "prints this help"};
constexpr OptionRow kVersion = {"-v, --version", "", "prints the version"};

struct LengthRow {
    std::string_view name;
    Length Dimensions::*member;
    Length min;
    Length max;
    std::string_view help;
};

constexpr std::array<LengthRow, 5> kLengths = {{
    {"--ball-radius", &Dimensions::ballRadius, kMillimetre / 2, 100 * kMillimetre, "radius of the ball"},
    {"--pitch", &Dimensions::pitch, 2 * kMillimetre, 1000 * kMillimetre, "of cells, more than a ball and a wall"},
    {"--wall-thickness", &Dimensions::wallThickness, kMillimetre / 2, 500 * kMillimetre, "of inner and outer walls"},
    {"--wall-height", &Dimensions::wallHeight, kMillimetre, 500 * kMillimetre, "above the floor, more than the radius"},
    {"--floor-thickness", &Dimensions::floorThickness, kMillimetre / 2, 500 * kMillimetre, "under the ball"},
}};

[[noreturn]] void refuse(std::string_view option, const std::string &expected, std::string_view found) {
    throw OptionError(std::string(option) + ": expected " + expected + ", found '" + std::string(found) + "'");
}

bool isMazeOption(std::string_view name) {
    const auto isNamed = [name](const auto &row) { return row.name == name; };
    return std::any_of(kLengths.begin(), kLengths.end(), isNamed) || isNamed(kSeed) || isNamed(kCells) ||
           isNamed(kAlgorithm) || isNamed(kLoops) || isNamed(kOut);
}

using Values = std::map<std::string_view, std::string_view>;

// Names with their values, `--seed 7` or `--seed=7`; each known and given once.
Values gather(const std::vector<std::string_view> &arguments) {
    Values values;
    for (std::size_t index = 0; index < arguments.size(); ++index) {
        const std::string_view argument = arguments[index];
        const std::size_t equals = argument.find('=');
        const std::string_view name = argument.substr(0, equals);
        if (!isMazeOption(name) && name != kLevels.name && name != kBall.name)
            throw OptionError("expected an option of mazegen --help, found '" + std::string(argument) + "'");
        const bool isSeparate = equals == std::string_view::npos;
        if (isSeparate && ++index == arguments.size())
            throw OptionError(std::string(name) + ": expected a value, found nothing");
        if (!values.emplace(name, isSeparate ? arguments[index] : argument.substr(equals + 1)).second)
            throw OptionError(std::string(name) + ": expected once, found twice");
    }
    return values;
}

std::optional<std::string_view> valueOf(const Values &values, std::string_view name) {
    const auto found = values.find(name);
    if (found == values.end()) return std::nullopt;
    return found->second;
}

std::string_view requiredValueOf(const Values &values, std::string_view name, const std::string &expected) {
    const auto value = valueOf(values, name);
    if (!value) throw OptionError(std::string(name) + ": expected " + expected + ", found nothing");
    return *value;
}

std::uint64_t parseSeed(const Values &values) {
    const std::string expected = "a whole number from 0 to 18446744073709551615";
    const std::string_view text = requiredValueOf(values, kSeed.name, expected);
    const auto seed = parseWhole(text);
    if (!seed) refuse(kSeed.name, expected, text);
    return *seed;
}

void parseCells(const Values &values, Recipe &recipe) {
    const std::string expected = "WxH with W and H from 2 to " + std::to_string(kLargestSide);
    const std::string_view text = requiredValueOf(values, kCells.name, expected);
    const std::size_t cross = std::min(text.find('x'), text.size());
    const auto width = parseWhole(text.substr(0, cross));
    const auto height = parseWhole(text.substr(std::min(cross + 1, text.size())));
    const auto isAllowed = [](const auto &side) { return side && *side >= 2 && *side <= kLargestSide; };
    if (!isAllowed(width) || !isAllowed(height)) refuse(kCells.name, expected, text);
    recipe.width = static_cast<int>(*width);
    recipe.height = static_cast<int>(*height);
}

Algorithm parseAlgorithm(std::string_view text) {
    std::string names;
    for (const AlgorithmRow &row : kAlgorithms) {
        if (row.name == text) return row.algorithm;
        names.append(names.empty() ? "" : " or ").append(row.name);
    }
    refuse(kAlgorithm.name, names, text);
}

std::int64_t parseLoops(std::string_view text) {
    const auto loops = parseMillionths(text);
    if (!loops || *loops > 1'000'000) refuse(kLoops.name, "a fraction from 0 to 1 with at most six decimals", text);
    return *loops;
}

Length parseLength(const LengthRow &row, std::string_view text) {
    const auto count = parseMillionths(text);
    const Length length = count.value_or(-1) * kMicrometre;
    if (length < row.min || length > row.max)
        refuse(row.name, "metres from " + metres(row.min) + " to " + metres(row.max) + " with at most six decimals",
               text);
    return length;
}

Recipe parseRecipe(const Values &values) {
    Recipe recipe;
    recipe.seed = parseSeed(values);
    parseCells(values, recipe);
    if (const auto text = valueOf(values, kAlgorithm.name)) recipe.algorithm = parseAlgorithm(*text);
    if (const auto text = valueOf(values, kLoops.name)) recipe.loopMillionths = parseLoops(*text);
    for (const LengthRow &row : kLengths)
        if (const auto text = valueOf(values, row.name)) recipe.dimensions.*row.member = parseLength(row, *text);
    const std::string reason = impossibility(recipe.dimensions);
    if (!reason.empty()) throw OptionError(reason);
    return recipe;
}

// The .obj names its .mtl, and white space ends a name there.
std::filesystem::path parsePrefix(std::string_view text) {
    std::filesystem::path prefix(text);
    const std::string name = prefix.filename().string();
    if (name.empty() || name.find_first_of(" \t\r\n\v\f") != std::string::npos)
        refuse(kOut.name, "a path that ends in a name without white space", text);
    return prefix;
}

std::filesystem::path parseFolder(std::string_view option, std::string_view text) {
    std::error_code ignored; // can't be looked at: no folder to write to either
    if (!std::filesystem::is_directory(text, ignored)) refuse(option, "an existing folder", text);
    return text;
}

void appendHelp(const OptionRow &row, std::string &text) {
    std::string left = "  " + std::string(row.name) + " " + std::string(row.value);
    left.resize(std::max<std::size_t>(left.size() + 1, 28), ' ');
    text.append(left).append(row.help).append("\n");
}

void appendHelp(const LengthRow &row, std::string &text) {
    const std::string help = std::string(row.help) + ", from " + metres(row.min) + " to " + metres(row.max) +
                             " m; default " + metres(Dimensions{}.*row.member);
    appendHelp(OptionRow{row.name, "METRES", help}, text);
}

} // namespace

Command parseCommandLine(const std::vector<std::string_view> &arguments) {
    Command command;
    const auto isGiven = [&](std::string_view name) {
        return std::find(arguments.begin(), arguments.end(), name) != arguments.end();
    };
    command.help = isGiven("--help") || isGiven("-h");
    command.version = !command.help && (isGiven("--version") || isGiven("-v"));
    if (command.help || command.version) return command;

    const Values values = gather(arguments);
    if (const auto folder = valueOf(values, kLevels.name)) command.levelsFolder = parseFolder(kLevels.name, *folder);
    if (const auto folder = valueOf(values, kBall.name)) command.ballFolder = parseFolder(kBall.name, *folder);

    const auto mazeOption =
        std::find_if(values.begin(), values.end(), [](const auto &given) { return isMazeOption(given.first); });
    const bool isFixed = command.levelsFolder || command.ballFolder;
    if (isFixed && mazeOption == values.end()) return command;
    if (isFixed)
        throw OptionError("--levels and --ball: expected no option of a single maze beside them, found " +
                          std::string(mazeOption->first));
    command.maze = parseRecipe(values);
    command.prefix = parsePrefix(valueOf(values, kOut.name).value_or(kDefaultPrefix));
    return command;
}

std::string helpText() {
    std::string text = "Makes a maze for one rolling ball: boxes as text, as mesh and as OpenSCAD program.\n"
                       "The same options give the same bytes on every machine.\n\n"
                       "  mazegen --seed N --cells WxH [options]\n"
                       "  mazegen --levels FOLDER --ball FOLDER\n\n";
    for (const OptionRow &row : {kSeed, kCells, kAlgorithm}) appendHelp(row, text);
    for (const AlgorithmRow &row : kAlgorithms)
        appendHelp(OptionRow{"", "", std::string(row.name) + ": " + std::string(row.character)}, text);
    appendHelp(kLoops, text);
    for (const LengthRow &row : kLengths) appendHelp(row, text);
    for (const OptionRow &row : {kOut, kLevels, kBall}) appendHelp(row, text);
    for (const OptionRow &row : {kHelp, kVersion}) appendHelp(row, text);
    text += "\nMETRES and FRACTION have at most six decimals and no exponent; --seed=7 is the same as --seed 7.\n"
            "Exit status: 0 done, 1 a file could not be written, 2 a wrong option; nothing is written then.\n";
    return text;
}

} // namespace mazes
