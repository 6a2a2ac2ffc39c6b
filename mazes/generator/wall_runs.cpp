// SPDX-License-Identifier: MIT
#include "generator/wall_runs.h"

namespace mazes {

namespace {

class WallGrid {
public:
    WallGrid(const CellMaze &maze, CellSide exit)
        : m_maze(maze)
        , m_exit(fromBelow(exit)) {}

    int lastLine(Axis axis) const { return axis == Axis::X ? m_maze.height() : m_maze.width(); }
    int lastPost(Axis axis) const { return axis == Axis::X ? m_maze.width() : m_maze.height(); }
    bool isRim(Axis axis, int line) const { return line == 0 || line == lastLine(axis); }

    // Whether there is a wall on this line between the posts `post` and `post + 1`.
    bool hasWall(Axis axis, int line, int post) const {
        if (post < 0 || post >= lastPost(axis)) return false;
        const Side side = axis == Axis::X ? Side::North : Side::East;
        const CellSide wall{axis == Axis::X ? Cell{post, line - 1} : Cell{line - 1, post}, side};
        return wall != m_exit && !m_maze.isOpen(wall);
    }

    // A post belongs to the walls along the axis with more walls there, so that a straight wall stays in one piece.
    bool fillsPost(Axis axis, int line, int post) const {
        const int own = wallsAtPost(axis, line, post);
        const int crossing = wallsAtPost(axis == Axis::X ? Axis::Y : Axis::X, post, line);
        return axis == Axis::X ? own >= crossing : own > crossing;
    }

private:
    // On the rim only the rim's own walls count: inner walls end at its inner face.
    int wallsAtPost(Axis axis, int line, int post) const {
        const bool endsAtRim = post == 0 || post == lastPost(axis);
        if (endsAtRim && !isRim(axis, line)) return 0;
        return int{hasWall(axis, line, post - 1)} + int{hasWall(axis, line, post)};
    }

    // The same side as east or north side; at the near and left rim that of a cell outside the maze.
    static CellSide fromBelow(CellSide wall) {
        if (wall.side == Side::West) return {neighbour(wall.cell, Side::West), Side::East};
        if (wall.side == Side::South) return {neighbour(wall.cell, Side::South), Side::North};
        return wall;
    }

    const CellMaze &m_maze;
    CellSide m_exit;
};

void appendRuns(const WallGrid &grid, Axis axis, int line, std::vector<WallRun> &runs) {
    for (int post = 0; post < grid.lastPost(axis); ++post) {
        if (!grid.hasWall(axis, line, post)) continue;
        int last = post + 1;
        while (grid.hasWall(axis, line, last) && grid.fillsPost(axis, line, last)) ++last;
        runs.push_back({axis, line, post, last, grid.fillsPost(axis, line, post), grid.fillsPost(axis, line, last),
                        grid.isRim(axis, line)});
        post = last - 1;
    }
}

} // namespace

std::vector<WallRun> wallRuns(const CellMaze &maze, CellSide exit) {
    const WallGrid grid(maze, exit);
    std::vector<WallRun> runs;
    for (const Axis axis : {Axis::X, Axis::Y})
        for (int line = 0; line <= grid.lastLine(axis); ++line) appendRuns(grid, axis, line, runs);
    return runs;
}

} // namespace mazes
