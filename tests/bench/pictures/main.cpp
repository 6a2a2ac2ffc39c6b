// SPDX-License-Identifier: MIT
// Draws numerical stability into a folder.
#include "pictures/pictures.h"

#include <cstdio>
#include <exception>

namespace {

void draw(const std::filesystem::path &folder) {
    std::filesystem::create_directories(folder);
    const bool energy = bench::drawEnergy(folder);
    const bool tunnelling = bench::drawTunnelling(folder);
    const bool convergence = bench::drawConvergence(folder);
    const bool all = energy && tunnelling && convergence;
    std::printf("%s: energy, tunnelling, convergence_*%s\n", folder.string().c_str(),
                all ? " as .svg and .png" : "; no gnuplot, so .gp programs only");
}

} // namespace

int main(int count, char **arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: bench_pictures FOLDER\n");
        return 2;
    }
    try {
        draw(arguments[1]);
    } catch (const std::exception &problem) {
        std::fprintf(stderr, "bench_pictures: %s\n", problem.what());
        return 1;
    }
}
