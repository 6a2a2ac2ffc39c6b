// SPDX-License-Identifier: MIT
// Measures all engines in all scenes and writes the comparison into a folder.
#include "peers/report.h"

#include <algorithm>
#include <cstdio>
#include <exception>

namespace {

using namespace bench;

void showProgress(const std::string &what) { std::fprintf(stderr, "\r\033[K%s", what.c_str()); }

// The scenes whose names begin with one of the words; all if there are no words.
std::vector<SceneGroup> chosenGroups(const std::vector<std::string> &words) {
    std::vector<SceneGroup> groups = allGroups();
    if (words.empty()) return groups;
    std::erase_if(groups, [&](const SceneGroup &group) {
        return std::none_of(words.begin(), words.end(),
                            [&](const std::string &word) { return group.name.starts_with(word); });
    });
    return groups;
}

void compare(const std::filesystem::path &folder, const std::vector<std::string> &words) {
    std::filesystem::create_directories(folder);
    const std::vector<SceneGroup> groups = chosenGroups(words);
    const std::vector<EngineKind> engines = allEngines();
    const std::vector<Trial> trials = measure(groups, engines, showProgress);
    showProgress("");
    writeCsv(trials, folder);
    writeMarkdown(groups, engines, trials, folder);
    const bool drawn = writeCharts(groups, trials, folder);
    std::printf("%s: peers.md, peers.csv%s\n", folder.string().c_str(),
                drawn ? ", charts as .svg and .png" : "; no gnuplot, so the charts are .gp programs only");
}

} // namespace

int main(int count, char **arguments) {
    if (count < 2) {
        std::fprintf(stderr, "usage: bench_peers FOLDER [SCENES...]\nscenes, by the beginning of their name:");
        for (const SceneGroup &group : allGroups()) std::fprintf(stderr, " '%s'", group.name.c_str());
        std::fprintf(stderr, "\n");
        return 2;
    }
    try {
        compare(arguments[1], {arguments + 2, arguments + count});
    } catch (const std::exception &problem) {
        std::fprintf(stderr, "bench_peers: %s\n", problem.what());
        return 1;
    }
}
