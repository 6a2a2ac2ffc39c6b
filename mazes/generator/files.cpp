// SPDX-License-Identifier: MIT
#include "generator/files.h"

#include "generator/writers.h"

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

namespace mazes {

namespace fs = std::filesystem;

namespace {

fs::path withSuffix(fs::path path, const char *suffix) { return path += suffix; }

// Beside the file, because renaming is only atomic within one file system.
fs::path temporaryOf(const OutputFile &file) { return withSuffix(file.path, ".part"); }

// Whether nothing has this name, or a file of the same kind, which its first bytes show. A link, a pipe or a device
// would be replaced by the renaming, not written.
bool isReplaceable(const OutputFile &file) {
    constexpr std::size_t kMark = 9;
    std::error_code error;
    const fs::file_type type = fs::symlink_status(file.path, error).type();
    if (type == fs::file_type::not_found || type == fs::file_type::directory) return true; // renaming reports a folder
    if (type != fs::file_type::regular) return false;
    std::string mark(kMark, '\0');
    std::ifstream stream(file.path, std::ios::binary);
    stream.read(mark.data(), static_cast<std::streamsize>(mark.size()));
    return stream.gcount() == 0 || mark == file.content.substr(0, kMark);
}

FileError cannotWrite(const OutputFile &file, int reason) {
    return FileError(file.path.string() + ": cannot write: " + std::generic_category().message(reason));
}

// Creates it, so that an existing file of this name, which another program may be writing, isn't changed.
std::FILE *openTemporary(const OutputFile &file) {
    const std::string name = temporaryOf(file).string();
    std::FILE *stream = std::fopen(name.c_str(), "wbx");
    if (!stream && errno == EEXIST) throw FileError(name + ": there is a file of this name already");
    if (!stream) throw cannotWrite(file, errno);
    return stream;
}

void writeTemporary(const OutputFile &file, std::FILE *stream) {
    const bool isWritten = std::fwrite(file.content.data(), 1, file.content.size(), stream) == file.content.size();
    const int reason = errno;
    if (std::fclose(stream) != 0) throw cannotWrite(file, errno);
    if (!isWritten) throw cannotWrite(file, reason);
}

void moveIntoPlace(const OutputFile &file) {
    std::error_code error;
    fs::rename(temporaryOf(file), file.path, error);
    if (error) throw FileError(file.path.string() + ": cannot replace: " + error.message());
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
    std::vector<fs::path> temporaries;
    try {
        for (const OutputFile &file : files) {
            std::FILE *stream = openTemporary(file);
            temporaries.push_back(temporaryOf(file));
            writeTemporary(file, stream);
        }
        for (const OutputFile &file : files) moveIntoPlace(file);
    } catch (...) {
        std::error_code ignored; // the failure that led here is the one to report
        for (const fs::path &temporary : temporaries) fs::remove(temporary, ignored);
        throw;
    }
}

} // namespace mazes
