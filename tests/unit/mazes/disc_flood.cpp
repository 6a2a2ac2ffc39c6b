// SPDX-License-Identifier: MIT
#include "disc_flood.h"

#include <algorithm>

DiscFlood::DiscFlood(const MazeText &maze, Nanometres radius, Nanometres step)
    : m_bounds(maze.bounds())
    , m_step(step)
    , m_columns((m_bounds.max[0] - m_bounds.min[0]) / step + 1)
    , m_rows((m_bounds.max[1] - m_bounds.min[1]) / step + 1)
    , m_places(static_cast<std::size_t>(m_columns * m_rows)) {
    for (const TextBox &box : maze.boxes)
        if (box.isWall()) block(box, radius);
    spreadFrom(indexOf((maze.start[0] - m_bounds.min[0]) / step, (maze.start[1] - m_bounds.min[1]) / step));
}

bool DiscFlood::reaches(Nanometres x, Nanometres y) const {
    return m_places[indexOf((x - m_bounds.min[0]) / m_step, (y - m_bounds.min[1]) / m_step)] == Place::Reached;
}

int DiscFlood::waysOut() const {
    const std::vector<std::size_t> places = outline();
    int ways = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t previous = places[(i + places.size() - 1) % places.size()];
        if (m_places[places[i]] == Place::Reached && m_places[previous] != Place::Reached) ++ways;
    }
    return ways;
}

std::size_t DiscFlood::indexOf(Nanometres column, Nanometres row) const {
    return static_cast<std::size_t>(row * m_columns + column);
}

// A disc may touch a wall; a point may be neither inside a wall nor on its edge.
void DiscFlood::block(const TextBox &wall, Nanometres radius) {
    const auto firstPlace = [&](std::size_t axis) {
        return std::max<Nanometres>((wall.min[axis] - radius - m_bounds.min[axis]) / m_step, 0);
    };
    const auto lastPlace = [&](std::size_t axis, Nanometres count) {
        return std::min((wall.max[axis] + radius - m_bounds.min[axis]) / m_step, count - 1);
    };
    for (Nanometres row = firstPlace(1); row <= lastPlace(1, m_rows); ++row) {
        for (Nanometres column = firstPlace(0); column <= lastPlace(0, m_columns); ++column) {
            const Nanometres x = m_bounds.min[0] + column * m_step;
            const Nanometres y = m_bounds.min[1] + row * m_step;
            const Nanometres dx = x - std::clamp(x, wall.min[0], wall.max[0]);
            const Nanometres dy = y - std::clamp(y, wall.min[1], wall.max[1]);
            const Nanometres square = dx * dx + dy * dy;
            if (square == 0 || square < radius * radius) m_places[indexOf(column, row)] = Place::Blocked;
        }
    }
}

void DiscFlood::spreadFrom(std::size_t start) {
    const auto columns = static_cast<std::size_t>(m_columns);
    const std::size_t count = m_places.size();
    Place *const places = m_places.data(); // millions of them are visited
    std::vector<std::size_t> open;
    const auto visit = [&](std::size_t place) {
        if (places[place] != Place::Open) return;
        places[place] = Place::Reached;
        open.push_back(place);
    };
    visit(start);
    while (!open.empty()) {
        const std::size_t here = open.back();
        open.pop_back();
        if (here % columns > 0) visit(here - 1);
        if (here % columns + 1 < columns) visit(here + 1);
        if (here >= columns) visit(here - columns);
        if (here + columns < count) visit(here + columns);
    }
}

// Visits the outline once, each place once.
std::vector<std::size_t> DiscFlood::outline() const {
    std::vector<std::size_t> places;
    for (Nanometres column = 0; column < m_columns - 1; ++column) places.push_back(indexOf(column, 0));
    for (Nanometres row = 0; row < m_rows - 1; ++row) places.push_back(indexOf(m_columns - 1, row));
    for (Nanometres column = m_columns - 1; column > 0; --column) places.push_back(indexOf(column, m_rows - 1));
    for (Nanometres row = m_rows - 1; row > 0; --row) places.push_back(indexOf(0, row));
    return places;
}
