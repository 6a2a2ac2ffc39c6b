// SPDX-License-Identifier: GPL-3.0-or-later
// The shortest path out of the maze from everywhere: for each cell of the free space the next one.
#pragma once

#include "core/pilot/free_space.h"

#include <vector>

namespace inspector {

class WayOut {
public:
    /// space must outlive this object.
    explicit WayOut(const FreeSpace &space);

    /// The next cell of the path; kNowhere at its end, and where there is no path out.
    FreeSpace::Cell next(FreeSpace::Cell cell) const { return m_next[size_t(cell)]; }
    bool exists(FreeSpace::Cell from) const;

private:
    void search();
    /// visit(FreeSpace::Cell, its distance in cells)
    template<typename Visit>
    void visitNeighbours(FreeSpace::Cell cell, const Visit &visit) const;
    std::vector<double> prices() const;

    const FreeSpace &m_space;
    std::vector<FreeSpace::Cell> m_next;
};

} // namespace inspector
