// SPDX-License-Identifier: MIT
#include "generator/command_line.h"
#include "generator/levels.h"

#include <chrono>
#include <csignal>
#include <exception>
#include <iostream>

namespace {

using Clock = std::chrono::steady_clock;

std::string milliseconds(Clock::duration duration) {
    const auto tenths = std::chrono::duration_cast<std::chrono::microseconds>(duration).count() / 100;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " ms";
}

// Names may contain line breaks and terminal control characters, which are shown as \x1b.
std::string oneLine(const std::string &text) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < ' ' || byte == 0x7f)
            line += {'\\', 'x', kDigits[byte / 16], kDigits[byte % 16]};
        else
            line += c;
    }
    return line;
}

void report(const std::string &what, Clock::time_point begin) {
    std::cout << "mazegen: " << oneLine(what) << ", " << milliseconds(Clock::now() - begin) << "\n";
}

int fail(const std::exception &error, int status) {
    std::cerr << "mazegen: " << oneLine(error.what()) << "\n";
    return status;
}

void writeMaze(const mazes::Recipe &recipe, const std::filesystem::path &prefix) {
    const auto begin = Clock::now();
    const mazes::Maze maze = mazes::makeMaze(recipe);
    mazes::writeFiles(mazes::mazeFiles(recipe, maze, prefix));
    report(prefix.string() + ".txt .obj .mtl .scad: " + std::to_string(recipe.width) + "x" +
               std::to_string(recipe.height) + " cells, " + std::to_string(maze.board.boxes.size()) +
               " boxes, way out " + std::to_string(mazes::wayLength(maze)) + " cells",
           begin);
}

void writeLevels(const std::filesystem::path &folder) {
    const auto begin = Clock::now();
    mazes::writeFiles(mazes::levelFiles(folder));
    const std::string count = std::to_string(mazes::levelRecipes().size());
    report((folder / "01").string() + " to " + count + ".txt .obj .mtl .scad", begin);
}

void writeBall(const std::filesystem::path &folder) {
    const auto begin = Clock::now();
    mazes::writeFiles(mazes::ballFiles(folder));
    report((folder / "ball").string() + ".obj .mtl", begin);
}

void run(const mazes::Command &command) {
    if (command.help) std::cout << mazes::helpText();
    if (command.version) std::cout << "mazegen " MAZEGEN_VERSION "\n";
    if (command.maze) writeMaze(*command.maze, command.prefix);
    if (command.levelsFolder) writeLevels(*command.levelsFolder);
    if (command.ballFolder) writeBall(*command.ballFolder);
}

} // namespace

int main(int argc, char **argv) {
#ifdef SIGXFSZ
    std::signal(SIGXFSZ, SIG_IGN); // exceeding the file size limit is a write error
#endif
    try {
        run(mazes::parseCommandLine({argv + 1, argv + argc}));
        if (std::cout.flush()) return 0;
        std::cerr << "mazegen: standard output: can't be written\n";
        return 1;
    } catch (const mazes::OptionError &error) {
        return fail(error, 2);
    } catch (const std::exception &error) {
        return fail(error, 1);
    }
}
