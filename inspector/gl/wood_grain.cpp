// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/wood_grain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace inspector::gl {

namespace {

double latticeValue(int x, int y, unsigned salt) {
    unsigned hash =
        static_cast<unsigned>(x) * 0x27D4EB2DU + static_cast<unsigned>(y) * 0x165667B1U + salt * 0x9E3779B9U;
    hash = (hash ^ (hash >> 15)) * 0x85EBCA77U;
    hash = (hash ^ (hash >> 13)) * 0xC2B2AE3DU;
    return ((hash ^ (hash >> 16)) & 0xFFFFU) / 65535.0;
}

double smooth(double t) { return t * t * (3.0 - 2.0 * t); }

/// Value noise in 0..1 with period 1 in u and v, on a lattice of columns x rows cells.
double noise(double u, double v, int columns, int rows, unsigned salt) {
    const double x = u * columns;
    const double y = v * rows;
    const int column = static_cast<int>(std::floor(x));
    const int row = static_cast<int>(std::floor(y));
    const auto corner = [&](int dx, int dy) {
        const int wrappedX = ((column + dx) % columns + columns) % columns;
        const int wrappedY = ((row + dy) % rows + rows) % rows;
        return latticeValue(wrappedX, wrappedY, salt);
    };
    const double s = smooth(x - column);
    return std::lerp(std::lerp(corner(0, 0), corner(1, 0), s), std::lerp(corner(0, 1), corner(1, 1), s),
                     smooth(y - row));
}

/// Growth rings cut lengthwise, distorted by low-frequency noise, with fine fibres and dark pores. About -0.5..0.5.
double fibre(double u, double v) {
    const double bend = 0.10 * (noise(u, v, 3, 4, 1) - 0.5) + 0.05 * (noise(u, v, 6, 9, 2) - 0.5);
    const double phase = (v + bend) * 9.0 + 0.6 * noise(u, v, 2, 18, 3);
    const double ring = phase - std::floor(phase); // soft early wood, then a hard dark line
    const double rings = smooth(std::min(ring / 0.8, (1.0 - ring) / 0.2)) - 0.5;
    const double fibres = noise(u, v, 6, 128, 4) - 0.5;
    const double pores = std::max(0.0, noise(u, v, 24, 200, 5) - 0.78);
    return 0.38 * rings + 0.40 * fibres - 1.1 * pores;
}

/// Each texel is the mean of four; size is that of the result.
std::vector<std::uint8_t> halved(const std::vector<std::uint8_t> &pixels, int size) {
    std::vector<std::uint8_t> result;
    result.reserve(static_cast<std::size_t>(size) * size);
    for (int y = 0; y < size; ++y) {
        const std::uint8_t *above = &pixels[static_cast<std::size_t>(4) * y * size];
        const std::uint8_t *below = above + 2 * size;
        for (int x = 0; x < size; ++x) {
            const int sum = above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1];
            result.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
        }
    }
    return result;
}

} // namespace

std::vector<std::uint8_t> woodGrain(int size) {
    std::vector<std::uint8_t> pixels;
    pixels.reserve(static_cast<std::size_t>(size) * size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double value = 128.0 + 127.0 * fibre((x + 0.5) / size, (y + 0.5) / size);
            pixels.push_back(static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)));
        }
    }
    return pixels;
}

std::vector<std::vector<std::uint8_t>> mipmapsOf(std::vector<std::uint8_t> pixels, int size) {
    std::vector<std::vector<std::uint8_t>> levels{std::move(pixels)};
    while (size > 1) {
        size /= 2;
        levels.push_back(halved(levels.back(), size));
    }
    return levels;
}

} // namespace inspector::gl
