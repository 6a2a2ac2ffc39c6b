// SPDX-License-Identifier: MIT
#include "generator/files.h"

#include "generator/writers.h"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace mazes {

namespace fs = std::filesystem;

namespace {

fs::path withSuffix(fs::path path, const char *suffix) { return path += suffix; }

// Beside the file, because renaming is only atomic within one file system.
fs::path temporaryOf(const OutputFile &file) { return withSuffix(file.path, ".part"); }

// Whether what has the file's name, if anything, is of its kind, which the first bytes tell.
bool isReplaceable(const OutputFile &file) {
    constexpr std::size_t kMark = 9;
    std::error_code error;
    if (!fs::is_regular_file(file.path, error)) return true; // renaming tells
    std::string mark(kMark, '\0');
    std::ifstream stream(file.path, std::ios::binary);
    stream.read(mark.data(), static_cast<std::streamsize>(mark.size()));
    return stream.gcount() == 0 || mark == file.content.substr(0, kMark);
}

void writeTemporary(const OutputFile &file) {
    errno = 0;
    std::ofstream stream(temporaryOf(file), std::ios::binary | std::ios::trunc);
    stream.write(file.content.data(), static_cast<std::streamsize>(file.content.size()));
    stream.close();
    if (!stream) throw FileError(file.path.string() + ": cannot write: " + std::generic_category().message(errno));
}

void moveIntoPlace(const OutputFile &file) {
    std::error_code error;
    fs::rename(temporaryOf(file), file.path, error);
    if (error) throw FileError(file.path.string() + ": cannot replace: " + error.message());
}

void removeTemporaries(const std::vector<OutputFile> &files) {
    std::error_code ignored; // the failure that led here is the one to report
    for (const OutputFile &file : files) fs::remove(temporaryOf(file), ignored);
}

} // namespace

std::vector<OutputFile> mazeFiles(const Recipe &recipe, const Maze &maze, const fs::path &prefix) {
    const std::string generator = generatorLine(recipe);
    const fs::path material = withSuffix(prefix, ".mtl");
    return {{withSuffix(prefix, ".obj"), meshFile(maze.board, generator, material.filename().string())},
            {material, meshMaterialFile()},
            {withSuffix(prefix, ".scad"), scadFile(maze.board, generator)},
            {withSuffix(prefix, ".txt"), textFile(maze.board, generator)}};
}

std::vector<OutputFile> ballFiles(const fs::path &folder) {
    return {{folder / "ball.obj", ballMeshFile("ball.mtl")}, {folder / "ball.mtl", ballMaterialFile()}};
}

void writeFiles(const std::vector<OutputFile> &files) {
    for (const OutputFile &file : files)
        if (!isReplaceable(file)) throw FileError(file.path.string() + ": there is another file of this name already");
    try {
        for (const OutputFile &file : files) writeTemporary(file);
        for (const OutputFile &file : files) moveIntoPlace(file);
    } catch (...) {
        removeTemporaries(files);
        throw;
    }
}

} // namespace mazes
