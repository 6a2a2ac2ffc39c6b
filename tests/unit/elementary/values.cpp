// SPDX-License-Identifier: MIT
// Reads pairs of doubles and writes the function's values; for `measure`. Usage: elementary_values FUNCTION
#include "functions.h"

#include <cstdio>

int main(int argc, char **argv) {
    const elementary::Function *function = argc == 2 ? elementary::find(argv[1]) : nullptr;
    if (!function) {
        std::fprintf(stderr, "elementary_values: expected the name of a function\n");
        return 2;
    }
    double arguments[2];
    while (std::fread(arguments, sizeof arguments, 1, stdin) == 1) {
        const double value = function->at(arguments[0], arguments[1]);
        std::fwrite(&value, sizeof value, 1, stdout);
    }
    return 0;
}
