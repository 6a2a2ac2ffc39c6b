// SPDX-License-Identifier: MIT
// Measures all engines in all scenes and writes the comparison into a folder.
#include "peers/report.h"

#include <cstdio>
#include <exception>

namespace {

using namespace bench;

void showProgress(const std::string &what) { std::fprintf(stderr, "\r\033[K%s", what.c_str()); }

void compare(const std::filesystem::path &folder) {
    std::filesystem::create_directories(folder);
    const std::vector<SceneGroup> groups = allGroups();
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
    if (count != 2) {
        std::fprintf(stderr, "usage: bench_peers FOLDER\n");
        return 2;
    }
    try {
        compare(arguments[1]);
    } catch (const std::exception &problem) {
        std::fprintf(stderr, "bench_peers: %s\n", problem.what());
        return 1;
    }
}
