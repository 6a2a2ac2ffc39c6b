// SPDX-License-Identifier: MIT
#include "scene/merge.h"

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <numeric>
#include <tuple>

namespace phys {

namespace {

constexpr uint32_t kGone = 0xffffffffU;

double lowEnd(const phys_box &box, int axis) { return (&box.min.x)[axis]; }
double highEnd(const phys_box &box, int axis) { return (&box.max.x)[axis]; }

/// What two boxes must share to be flush along `axis`: their extents along the other two.
bool sameCrossSection(const phys_box &p, const phys_box &q, int axis) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    return lowEnd(p, a) == lowEnd(q, a) && highEnd(p, a) == highEnd(q, a) && lowEnd(p, b) == lowEnd(q, b) &&
           highEnd(p, b) == highEnd(q, b);
}

uint64_t hashCrossSection(const phys_box &box, int axis) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    uint64_t hash = 0;
    for (const double end : {lowEnd(box, a), highEnd(box, a), lowEnd(box, b), highEnd(box, b)}) {
        hash = (hash ^ std::bit_cast<uint64_t>(end + 0.0)) * 0x9e3779b97f4a7c15U; // + 0.0: -0 is 0
        hash ^= hash >> 29;
    }
    return hash;
}

struct Piece {
    phys_box box;
    uint32_t root; // lowest number of the given boxes in it
};

struct Entry {
    uint64_t section; // hash of the piece's cross-section
    double low;
    uint32_t root, piece;

    bool operator<(const Entry &other) const {
        return std::tie(section, low, root) < std::tie(other.section, other.low, other.root);
    }
};

/// The pieces in an order in which those that may be flush along `axis` follow each other. Spreading them over buckets
/// by their hash first leaves little to sort.
std::vector<Entry> lineUp(int axis, const std::vector<Piece> &pieces) {
    const size_t buckets = std::bit_ceil(pieces.size());
    std::vector<Entry> entries(pieces.size()), sorted(pieces.size());
    std::vector<uint32_t> first(buckets + 1);
    for (uint32_t i = 0; i < pieces.size(); ++i) {
        const phys_box &box = pieces[i].box;
        entries[i] = {hashCrossSection(box, axis), lowEnd(box, axis), pieces[i].root, i};
        ++first[(entries[i].section & (buckets - 1)) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<uint32_t> next(first.begin(), first.end() - 1);
    for (const Entry &entry : entries) sorted[next[entry.section & (buckets - 1)]++] = entry;
    for (size_t bucket = 0; bucket < buckets; ++bucket) {
        if (first[bucket + 1] - first[bucket] < 2) continue;
        std::sort(sorted.begin() + first[bucket], sorted.begin() + first[bucket + 1]);
    }
    return sorted;
}

/// Joins pieces that touch or overlap along one axis and share their cross-section. Returns whether any did.
bool mergeAlong(int axis, std::vector<Piece> &pieces, std::vector<uint32_t> &parent) {
    const std::vector<Entry> line = lineUp(axis, pieces);
    bool any = false;
    uint32_t last = line.front().piece;
    for (size_t i = 1; i < line.size(); ++i) {
        Piece &into = pieces[last];
        Piece &piece = pieces[line[i].piece];
        const bool flush = line[i].section == line[i - 1].section &&
                           lowEnd(piece.box, axis) <= highEnd(into.box, axis) &&
                           sameCrossSection(into.box, piece.box, axis);
        if (!flush) {
            last = line[i].piece;
            continue;
        }
        (&into.box.max.x)[axis] = std::max(highEnd(into.box, axis), highEnd(piece.box, axis));
        const uint32_t root = std::min(into.root, piece.root);
        parent[into.root] = root;
        parent[piece.root] = root;
        into.root = root;
        piece.root = kGone;
        any = true;
    }
    if (any) std::erase_if(pieces, [](const Piece &piece) { return piece.root == kGone; });
    return any;
}

/// Nothing was flush: each box has itself as its only part.
Merged eachItself(std::span<const phys_box> given, std::span<const uint32_t> members) {
    Merged merged;
    merged.boxes.reserve(members.size());
    for (const uint32_t member : members) merged.boxes.push_back(given[member]);
    merged.parts.assign(members.begin(), members.end());
    merged.first.resize(members.size() + 1);
    std::iota(merged.first.begin(), merged.first.end(), 0U);
    return merged;
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
    for (int axis = 0, quiet = 0; quiet < 3 && pieces.size() > 1; axis = (axis + 1) % 3) {
        quiet = mergeAlong(axis, pieces, parent) ? 0 : quiet + 1;
    }

    if (pieces.size() == members.size()) return eachItself(given, members);
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
