// SPDX-License-Identifier: MIT
#include "merge.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace phys {

namespace {

double lowEnd(const phys_box &box, int axis) { return (&box.min.x)[axis]; }
double highEnd(const phys_box &box, int axis) { return (&box.max.x)[axis]; }

/// What two boxes must share to be flush along `axis`: their extents along the other two.
std::array<double, 4> crossSection(const phys_box &box, int axis) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    return {lowEnd(box, a), highEnd(box, a), lowEnd(box, b), highEnd(box, b)};
}

struct Piece {
    phys_box box;
    uint32_t root; // lowest number of the given boxes in it
};

/// Joins pieces that touch or overlap along one axis and share their cross-section. Returns whether any did.
bool mergeAlong(int axis, std::vector<Piece> &pieces, std::vector<uint32_t> &parent) {
    std::sort(pieces.begin(), pieces.end(), [axis](const Piece &a, const Piece &b) {
        const auto sectionA = crossSection(a.box, axis);
        const auto sectionB = crossSection(b.box, axis);
        if (sectionA != sectionB) return sectionA < sectionB;
        return std::tuple(lowEnd(a.box, axis), a.root) < std::tuple(lowEnd(b.box, axis), b.root);
    });
    size_t last = 0;
    for (size_t i = 1; i < pieces.size(); ++i) {
        Piece &into = pieces[last];
        const Piece &piece = pieces[i];
        const bool flush = crossSection(into.box, axis) == crossSection(piece.box, axis) &&
                           lowEnd(piece.box, axis) <= highEnd(into.box, axis);
        if (!flush) {
            pieces[++last] = piece;
            continue;
        }
        (&into.box.max.x)[axis] = std::max(highEnd(into.box, axis), highEnd(piece.box, axis));
        const uint32_t root = std::min(into.root, piece.root);
        parent[into.root] = parent[piece.root] = root;
        into.root = root;
    }
    const bool any = last + 1 < pieces.size();
    pieces.resize(last + 1);
    return any;
}

} // namespace

Merged mergeFlush(std::span<const phys_box> given, std::span<const uint32_t> members) {
    Merged merged;
    merged.first.push_back(0);
    if (members.empty()) return merged;

    std::vector<Piece> pieces;
    std::vector<uint32_t> parent(given.size());
    pieces.reserve(members.size());
    for (const uint32_t member : members) {
        pieces.push_back({given[member], member});
        parent[member] = member;
    }
    // A round of all three axes in which nothing merges is the end.
    for (int axis = 0, quiet = 0; quiet < 3; axis = (axis + 1) % 3) {
        quiet = mergeAlong(axis, pieces, parent) ? 0 : quiet + 1;
    }

    std::sort(pieces.begin(), pieces.end(), [](const Piece &a, const Piece &b) { return a.root < b.root; });
    std::vector<std::pair<uint32_t, uint32_t>> rootAndPart;
    rootAndPart.reserve(members.size());
    for (const uint32_t member : members) {
        // Parents are lower than their children and members ascend: the parent's own root is known by now.
        parent[member] = parent[parent[member]];
        rootAndPart.emplace_back(parent[member], member);
    }
    std::sort(rootAndPart.begin(), rootAndPart.end());
    for (const auto &[root, part] : rootAndPart) {
        if (merged.parts.empty() || root != parent[merged.parts.back()]) {
            merged.boxes.push_back(pieces[merged.boxes.size()].box);
            if (!merged.parts.empty()) merged.first.push_back(static_cast<uint32_t>(merged.parts.size()));
        }
        merged.parts.push_back(part);
    }
    merged.first.push_back(static_cast<uint32_t>(merged.parts.size()));
    return merged;
}

} // namespace phys
