// SPDX-License-Identifier: MIT
#include "maze_text.h"

#include <QFile>
#include <QStringList>

#include <algorithm>

namespace {

bool readNumbers(const QStringList &words, qsizetype first, std::vector<Nanometres> &numbers) {
    numbers.clear();
    for (qsizetype i = first; i < words.size(); ++i) {
        bool isNumber = false;
        numbers.push_back(qRound64(words[i].toDouble(&isNumber) * 1e9));
        if (!isNumber) return false;
    }
    return true;
}

bool readItem(const QStringList &words, MazeText &maze) {
    if (words[0] == "generator" || words == QStringList{"units", "m"}) return true;
    std::vector<Nanometres> numbers;
    if (!readNumbers(words, 1, numbers)) return false;
    if (words[0] == "ball" && numbers.size() == 1)
        maze.ballRadius = numbers[0];
    else if (words[0] == "start" && numbers.size() == 3)
        std::copy_n(numbers.begin(), 3, maze.start.begin());
    else if (words[0] == "box" && numbers.size() == 6)
        maze.boxes.push_back({{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}});
    else
        return false;
    return true;
}

} // namespace

TextBox MazeText::bounds() const {
    TextBox all = boxes.at(0);
    for (const TextBox &box : boxes) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            all.min[axis] = std::min(all.min[axis], box.min[axis]);
            all.max[axis] = std::max(all.max[axis], box.max[axis]);
        }
    }
    return all;
}

MazeText readMazeText(const QString &path) {
    MazeText maze;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {path + ": " + file.errorString(), 0, {}, {}};
    const QStringList lines = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
    if (lines.value(0) != "physics-maze 1") return {path + ": no header", 0, {}, {}};
    for (const QString &line : lines.mid(1))
        if (!readItem(line.split(' '), maze)) maze.problem = path + ": " + line;
    return maze;
}
