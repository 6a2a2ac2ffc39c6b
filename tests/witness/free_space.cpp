// SPDX-License-Identifier: MIT
#include "free_space.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace witness {

namespace {

constexpr double kMargin = 1e-9; // of the radius

} // namespace

FreeSpace::FreeSpace(std::span<const phys_box> boxes, double radius) {
    for (const phys_box &box : boxes) {
        for (unsigned axes = 1; axes < 8; ++axes) {
            const int count = static_cast<int>((axes & 1U) + (axes >> 1U & 1U) + (axes >> 2U & 1U));
            const double swell = radius * (1 - kMargin) / std::sqrt(count);
            const auto along = [&](unsigned axis) { return axes >> axis & 1U ? swell : -kMargin * radius; };
            const Block block = {{box.min.x - along(0), box.min.y - along(1), box.min.z - along(2)},
                                 {box.max.x + along(0), box.max.y + along(1), box.max.z + along(2)}};
            const bool isEmpty =
                block.low[0] >= block.high[0] || block.low[1] >= block.high[1] || block.low[2] >= block.high[2];
            if (!isEmpty) m_blocks.push_back(block);
        }
    }
}

bool FreeSpace::isReachable(const phys_vec3 &a, const phys_vec3 &b, double reach) const {
    const Triple from = {a.x, a.y, a.z};
    const Triple to = {b.x, b.y, b.z};
    return isStraightWayFree(from, to) || isFlooded(from, to, reach);
}

bool FreeSpace::isStraightWayFree(const Triple &a, const Triple &b) const {
    return std::none_of(m_blocks.begin(), m_blocks.end(), [&](const Block &block) {
        double enter = 0;
        double leave = 1;
        for (int i = 0; i < 3; ++i) {
            const double way = b[i] - a[i];
            if (way == 0 && (a[i] <= block.low[i] || a[i] >= block.high[i])) return false;
            if (way == 0) continue;
            const double s = (block.low[i] - a[i]) / way;
            const double t = (block.high[i] - a[i]) / way;
            enter = std::max(enter, std::min(s, t));
            leave = std::min(leave, std::max(s, t));
        }
        return enter < leave;
    });
}

/// Cells between the planes of all blocks within `reach`; flood-filled from the cell of a.
bool FreeSpace::isFlooded(const Triple &a, const Triple &b, double reach) const {
    std::array<std::vector<double>, 3> planes;
    for (int i = 0; i < 3; ++i) {
        const double low = a[i] - reach;
        const double high = a[i] + reach;
        if (b[i] <= low || b[i] >= high) return false;
        planes[i] = {low, high};
        for (const Block &block : m_blocks) {
            for (const double plane : {block.low[i], block.high[i]}) {
                if (plane > low && plane < high) planes[i].push_back(plane);
            }
        }
        std::sort(planes[i].begin(), planes[i].end());
        planes[i].erase(std::unique(planes[i].begin(), planes[i].end()), planes[i].end());
    }
    const std::array<size_t, 3> size = {planes[0].size() - 1, planes[1].size() - 1, planes[2].size() - 1};
    const auto indexOf = [&](size_t x, size_t y, size_t z) { return (x * size[1] + y) * size[2] + z; };
    const auto slot = [&](int axis, double value) {
        const auto after = std::upper_bound(planes[axis].begin(), planes[axis].end(), value);
        const size_t index = static_cast<size_t>(after - planes[axis].begin());
        return std::clamp<size_t>(index, 1, size[axis]) - 1;
    };
    enum : uint8_t { kFree, kBlocked, kReached };
    std::vector<uint8_t> cells(size[0] * size[1] * size[2], kFree);
    for (const Block &block : m_blocks) {
        std::array<size_t, 3> first{};
        std::array<size_t, 3> last{};
        bool isNear = true;
        for (int i = 0; i < 3; ++i) {
            isNear = isNear && block.low[i] < planes[i].back() && block.high[i] > planes[i].front();
            first[i] = slot(i, std::max(block.low[i], planes[i].front()));
            const auto end = std::lower_bound(planes[i].begin(), planes[i].end(), block.high[i]);
            last[i] = std::min<size_t>(static_cast<size_t>(end - planes[i].begin()), size[i]);
        }
        for (size_t x = first[0]; isNear && x < last[0]; ++x) {
            for (size_t y = first[1]; y < last[1]; ++y) {
                std::fill_n(cells.begin() + static_cast<std::ptrdiff_t>(indexOf(x, y, first[2])),
                            last[2] > first[2] ? last[2] - first[2] : 0, kBlocked);
            }
        }
    }
    const std::array<size_t, 3> from = {slot(0, a[0]), slot(1, a[1]), slot(2, a[2])};
    const size_t goal = indexOf(slot(0, b[0]), slot(1, b[1]), slot(2, b[2]));
    if (cells[indexOf(from[0], from[1], from[2])] == kBlocked || cells[goal] == kBlocked) return true; // undecidable
    std::vector<std::array<size_t, 3>> open = {from};
    cells[indexOf(from[0], from[1], from[2])] = kReached;
    while (!open.empty()) {
        const std::array<size_t, 3> cell = open.back();
        open.pop_back();
        for (int i = 0; i < 3; ++i) {
            for (const bool isUp : {false, true}) {
                if (isUp ? cell[i] + 1 == size[i] : cell[i] == 0) continue;
                std::array<size_t, 3> next = cell;
                isUp ? ++next[i] : --next[i];
                uint8_t &state = cells[indexOf(next[0], next[1], next[2])];
                if (state != kFree) continue;
                state = kReached;
                open.push_back(next);
            }
        }
    }
    return cells[goal] == kReached;
}

} // namespace witness
