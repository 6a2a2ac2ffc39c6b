// SPDX-License-Identifier: MIT
// A maze's text file as the suites read it, without the generator's code.
#pragma once

#include <QString>

#include <array>
#include <cstdint>
#include <vector>

using Nanometres = std::int64_t;

struct TextBox {
    std::array<Nanometres, 3> min{};
    std::array<Nanometres, 3> max{};

    bool isWall() const { return max[2] > 0; }
};

struct MazeText {
    QString problem; // why it can't be read; empty if it can
    Nanometres ballRadius = 0;
    std::array<Nanometres, 3> start{};
    std::vector<TextBox> boxes;

    TextBox bounds() const;
};

MazeText readMazeText(const QString &path);
