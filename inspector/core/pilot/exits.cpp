// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pilot/exits.h"

#include "core/pilot/free_space.h"
#include "core/setup/ball_place.h"

#include <algorithm>

namespace inspector {

using Cell = FreeSpace::Cell;

namespace {

constexpr uint32_t kMostBoxes = 100000;
constexpr double kThickness = 2e-4; ///< m

/// Cells of one exit are adjacent, or have one cell between them.
bool isNear(const phys_box &box, Point point, double distance) {
    return point.x >= box.min.x - distance && point.x <= box.max.x + distance && point.y >= box.min.y - distance &&
           point.y <= box.max.y + distance;
}

void addTo(std::vector<phys_box> &exits, Point point, const FreeSpace &space, double floor) {
    const double half = 0.5 * space.spacing();
    const auto isSame = [&](const phys_box &exit) { return isNear(exit, point, 3.0 * space.spacing()); };
    const auto found = std::find_if(exits.begin(), exits.end(), isSame);
    if (found == exits.end()) {
        exits.push_back(
            {{point.x - half, point.y - half, floor}, {point.x + half, point.y + half, floor + kThickness}});
        return;
    }
    found->min.x = std::min(found->min.x, point.x - half);
    found->min.y = std::min(found->min.y, point.y - half);
    found->max.x = std::max(found->max.x, point.x + half);
    found->max.y = std::max(found->max.y, point.y + half);
}

/// Widened by the ball: cells are positions of its centre.
phys_box widened(phys_box exit, double radius) {
    const bool runsAlongX = exit.max.x - exit.min.x > exit.max.y - exit.min.y;
    (runsAlongX ? exit.min.x : exit.min.y) -= radius;
    (runsAlongX ? exit.max.x : exit.max.y) += radius;
    (runsAlongX ? exit.min.y : exit.min.x) -= 0.5 * radius;
    (runsAlongX ? exit.max.y : exit.max.x) += 0.5 * radius;
    return exit;
}

} // namespace

std::optional<std::vector<phys_box>> exitsOf(const phys_scene *scene) {
    if (phys_scene_box_count(scene) > kMostBoxes) return std::nullopt;
    const FreeSpace space(scene);
    if (!space.isFine()) return std::nullopt;
    phys_state start;
    phys_scene_start(scene, &start);
    const Cell first = space.isMarked() ? space.nearestFree({start.position.x, start.position.y}) : FreeSpace::kNowhere;
    if (first == FreeSpace::kNowhere) return std::nullopt;

    // Flood-fill the maze from the start; where it touches the outside is an exit.
    std::vector<phys_box> exits;
    const double floor = startingFloor(scene);
    std::vector<bool> isSeen(size_t(space.cellCount()), false);
    std::vector<Cell> open{first};
    isSeen[size_t(first)] = true;
    while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        const int column = cell % space.columns();
        const int row = cell / space.columns();
        bool isAtExit = false;
        for (const auto &[dc, dr] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
            const int c = column + dc;
            const int r = row + dr;
            if (c < 0 || r < 0 || c >= space.columns() || r >= space.rows()) continue;
            const Cell other = r * space.columns() + c;
            if (!space.isFree(other)) continue;
            isAtExit = isAtExit || space.isOutside(other);
            if (space.isOutside(other) || isSeen[size_t(other)]) continue;
            isSeen[size_t(other)] = true;
            open.push_back(other);
        }
        if (isAtExit && !space.isOutside(cell)) addTo(exits, space.centre(cell), space, floor);
    }
    for (phys_box &exit : exits) exit = widened(exit, space.radius());
    return exits;
}

} // namespace inspector
