// SPDX-License-Identifier: MIT
#include "generator/board.h"

#include "generator/numbers.h"
#include "generator/wall_runs.h"

namespace mazes {

namespace {

class BoardBuilder {
public:
    BoardBuilder(const CellMaze &maze, const Dimensions &dimensions)
        : m_maze(maze)
        , m_dimensions(dimensions)
        , m_halfWall(dimensions.wallThickness / 2) {}

    Point ballAt(Cell cell) const {
        const Length halfPitch = m_dimensions.pitch / 2;
        return {lineX(cell.x) + halfPitch, lineY(cell.y) + halfPitch, m_dimensions.ballRadius};
    }

    // Between the inner faces of the rim.
    Box floor() const {
        return {{lineX(0) + m_halfWall, lineY(0) + m_halfWall, -m_dimensions.floorThickness},
                {lineX(m_maze.width()) - m_halfWall, lineY(m_maze.height()) - m_halfWall, 0},
                Material::Floor};
    }

    // The floor of the opening: as wide as the corridor, as deep as the rim.
    Box exitTile(CellSide exit) const {
        const int beyondX = exit.side == Side::East ? 1 : 0;
        const int beyondY = exit.side == Side::North ? 1 : 0;
        const bool alongX = exit.side == Side::North || exit.side == Side::South;
        const WallRun opening = alongX ? WallRun{Axis::X, exit.cell.y + beyondY, exit.cell.x, exit.cell.x + 1}
                                       : WallRun{Axis::Y, exit.cell.x + beyondX, exit.cell.y, exit.cell.y + 1};
        return standing(opening, -m_dimensions.floorThickness, 0, Material::Exit);
    }

    // The rim holds the floor, so it begins at the floor's underside; inner walls stand on the floor.
    Box wall(const WallRun &run) const {
        if (run.isRim) return standing(run, -m_dimensions.floorThickness, m_dimensions.wallHeight, Material::Rim);
        return standing(run, 0, m_dimensions.wallHeight, Material::Wall);
    }

private:
    Length lineX(int line) const { return (2 * line - m_maze.width()) * m_dimensions.pitch / 2; }
    Length lineY(int line) const { return (2 * line - m_maze.height()) * m_dimensions.pitch / 2; }

    Box standing(const WallRun &run, Length bottom, Length top, Material material) const {
        const bool alongX = run.axis == Axis::X;
        const Length across = alongX ? lineY(run.line) : lineX(run.line);
        const Length begin =
            (alongX ? lineX(run.first) : lineY(run.first)) + (run.fillsFirst ? -m_halfWall : m_halfWall);
        const Length end = (alongX ? lineX(run.last) : lineY(run.last)) + (run.fillsLast ? m_halfWall : -m_halfWall);
        if (alongX) return {{begin, across - m_halfWall, bottom}, {end, across + m_halfWall, top}, material};
        return {{across - m_halfWall, begin, bottom}, {across + m_halfWall, end, top}, material};
    }

    const CellMaze &m_maze;
    const Dimensions &m_dimensions;
    Length m_halfWall;
};

} // namespace

std::string impossibility(const Dimensions &dimensions) {
    const Length corridor = dimensions.pitch - dimensions.wallThickness;
    const Length diameter = 2 * dimensions.ballRadius;
    if (corridor <= diameter)
        return "corridor (pitch less wall thickness): expected more than the ball's diameter of " + metres(diameter) +
               " m, found " + metres(corridor) + " m";
    if (dimensions.wallHeight <= dimensions.ballRadius)
        return "wall height: expected more than the ball's radius of " + metres(dimensions.ballRadius) + " m, found " +
               metres(dimensions.wallHeight) + " m";
    return {};
}

Board buildBoard(const CellMaze &maze, Cell entrance, CellSide exit, const Dimensions &dimensions) {
    const BoardBuilder builder(maze, dimensions);
    Board board{dimensions, builder.ballAt(entrance), {builder.floor(), builder.exitTile(exit)}};
    for (const WallRun &run : wallRuns(maze, exit)) board.boxes.push_back(builder.wall(run));
    return board;
}

} // namespace mazes
