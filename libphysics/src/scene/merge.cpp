// SPDX-License-Identifier: MIT
#include "scene/merge.h"

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace phys {

namespace {

constexpr uint32_t kGone = 0xffffffffU;

double lowEnd(const phys_box &box, int axis) { return (&box.min.x)[axis]; }
double highEnd(const phys_box &box, int axis) { return (&box.max.x)[axis]; }

/// What two boxes must share to be flush along `axis`: their extents along the other two axes.
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
    bool hasGrown; // consists of several boxes
};

struct Entry {
    uint64_t section; // hash of the piece's cross-section
    double low;
    uint32_t piece;

    bool operator<(const Entry &other) const {
        return std::tie(section, low, piece) < std::tie(other.section, other.low, other.piece);
    }
};

Entry entryOf(const std::vector<Piece> &pieces, uint32_t number, int axis) {
    const Piece &piece = pieces[number];
    return {hashCrossSection(piece.box, axis), lowEnd(piece.box, axis), number};
}

size_t bucketOf(const Entry &entry, size_t buckets) { return static_cast<size_t>(entry.section) & (buckets - 1); }

/// Orders the pieces so that those that may be flush along `axis` are adjacent. Distributing them to buckets by hash
/// first leaves little to sort.
std::vector<Entry> lineUp(int axis, const std::vector<Piece> &pieces) {
    const size_t buckets = std::bit_ceil(pieces.size());
    std::vector<Entry> entries(pieces.size()), sorted(pieces.size());
    std::vector<uint32_t> first(buckets + 1);
    for (uint32_t i = 0; i < pieces.size(); ++i) {
        entries[i] = entryOf(pieces, i, axis);
        ++first[bucketOf(entries[i], buckets) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<uint32_t> next(first.begin(), first.end() - 1);
    for (const Entry &entry : entries) sorted[next[bucketOf(entry, buckets)]++] = entry;
    for (size_t bucket = 0; bucket < buckets; ++bucket) {
        if (first[bucket + 1] - first[bucket] < 2) continue;
        std::sort(sorted.begin() + first[bucket], sorted.begin() + first[bucket + 1]);
    }
    return sorted;
}

/// Whether the second of two pieces, in the entries' order, continues the first along `axis`.
bool isFlush(const phys_box &lower, const phys_box &upper, int axis) {
    return lowEnd(upper, axis) <= highEnd(lower, axis) && sameCrossSection(lower, upper, axis);
}

/// Merges pieces until no more are flush. New possibilities that arise from a merge are found at its place, so each
/// merge costs the logarithm of the number of pieces, whatever the order in which merges enable each other.
class Merger {
public:
    Merger(std::vector<Piece> pieces, size_t numbers)
        : m_pieces(std::move(pieces))
        , m_parent(numbers) {
        for (const Piece &piece : m_pieces) m_parent[piece.root] = piece.root;
    }

    void run() {
        // One pass over everything; in most scenes nothing more is needed.
        const size_t before = m_pieces.size();
        for (int axis = 0; axis < 3; ++axis) joinLines(axis);
        if (m_pieces.size() > 1 && m_pieces.size() < before) joinWhatChanged();
        dropGone();
    }

    size_t pieceCount() const { return m_pieces.size(); }
    std::vector<Piece> takePieces() { return std::move(m_pieces); }
    /// For each number of a given box a lower one of the same piece, or itself.
    std::vector<uint32_t> takeParents() { return std::move(m_parent); }

private:
    using Line = std::set<Entry>;

    /// Merges two pieces that are flush along `axis` into the one with the lower number.
    void grow(Piece &lower, Piece &upper, int axis) {
        (&lower.box.max.x)[axis] = std::max(highEnd(lower.box, axis), highEnd(upper.box, axis));
        const uint32_t root = std::min(lower.root, upper.root);
        m_parent[lower.root] = root;
        m_parent[upper.root] = root;
        lower.root = root;
        upper.root = kGone;
        lower.hasGrown = true;
    }

    /// Merges all pieces that are flush along `axis`.
    void joinLines(int axis) {
        const std::vector<Entry> line = lineUp(axis, m_pieces);
        uint32_t last = line.front().piece;
        for (size_t i = 1; i < line.size(); ++i) {
            const uint32_t piece = line[i].piece;
            if (line[i].section == line[i - 1].section && isFlush(m_pieces[last].box, m_pieces[piece].box, axis)) {
                grow(m_pieces[last], m_pieces[piece], axis);
            } else {
                last = piece;
            }
        }
        dropGone();
    }

    void dropGone() {
        std::erase_if(m_pieces, [](const Piece &piece) { return piece.root == kGone; });
    }

    void joinWhatChanged() {
        for (int axis = 0; axis < 3; ++axis) {
            m_places[axis].resize(m_pieces.size());
            for (const Entry &entry : lineUp(axis, m_pieces)) {
                m_places[axis][entry.piece] = m_lines[axis].insert(m_lines[axis].end(), entry);
                if (m_pieces[entry.piece].hasGrown) m_changed[axis].push_back(entry.piece);
            }
        }
        // It ends after a round of all three axes without a change.
        for (int axis = 0, quiet = 0; quiet < 3; axis = (axis + 1) % 3) {
            quiet = m_changed[axis].empty() ? quiet + 1 : 0;
            for (const uint32_t piece : std::exchange(m_changed[axis], {})) {
                if (m_pieces[piece].root != kGone) joinNeighbours(piece, axis);
            }
        }
    }

    /// Merges everything that is flush along `axis` into a piece.
    void joinNeighbours(uint32_t piece, int axis) {
        const Line &line = m_lines[axis];
        bool any = false;
        for (;; any = true) {
            const Line::iterator self = m_places[axis][piece];
            const Line::iterator next = std::next(self);
            if (self != line.begin() && areFlush(std::prev(self)->piece, piece, axis)) {
                const uint32_t lower = std::prev(self)->piece;
                join(lower, piece, axis);
                piece = lower;
            } else if (next != line.end() && areFlush(piece, next->piece, axis)) {
                join(piece, next->piece, axis);
            } else {
                break;
            }
        }
        if (!any) return;
        m_changed[(axis + 1) % 3].push_back(piece);
        m_changed[(axis + 2) % 3].push_back(piece);
    }

    bool areFlush(uint32_t lower, uint32_t upper, int axis) const {
        return isFlush(m_pieces[lower].box, m_pieces[upper].box, axis);
    }

    /// Along `axis` the lower piece keeps its place in the order; along the others its cross-section has changed.
    void join(uint32_t lower, uint32_t upper, int axis) {
        for (int i = 0; i < 3; ++i) {
            m_lines[i].erase(m_places[i][upper]);
            if (i != axis) m_lines[i].erase(m_places[i][lower]);
        }
        grow(m_pieces[lower], m_pieces[upper], axis);
        for (int i = 0; i < 3; ++i) {
            if (i != axis) m_places[i][lower] = m_lines[i].insert(entryOf(m_pieces, lower, i)).first;
        }
    }

    std::vector<Piece> m_pieces;
    std::vector<uint32_t> m_parent;
    Line m_lines[3];                         ///< all pieces, in the order along each axis
    std::vector<Line::iterator> m_places[3]; ///< position of each piece in these orders
    std::vector<uint32_t> m_changed[3];      ///< pieces to be examined along each axis
};

/// Nothing was flush: each box is its own only part.
Merged eachItself(std::span<const phys_box> given, std::span<const uint32_t> members) {
    Merged merged;
    merged.boxes.reserve(members.size());
    for (const uint32_t member : members) merged.boxes.push_back(given[member]);
    merged.parts.assign(members.begin(), members.end());
    merged.first.resize(members.size() + 1);
    std::iota(merged.first.begin(), merged.first.end(), 0U);
    return merged;
}

/// The pieces and their parts, both in ascending order. parent: for each number a lower one of the same piece, or
/// itself.
Merged gather(std::vector<Piece> pieces, std::vector<uint32_t> parent, std::span<const uint32_t> members) {
    std::sort(pieces.begin(), pieces.end(), [](const Piece &a, const Piece &b) { return a.root < b.root; });
    std::vector<std::pair<uint32_t, uint32_t>> rootAndPart;
    rootAndPart.reserve(members.size());
    for (const uint32_t member : members) {
        // Parents are lower than their children and numbers ascend, so the parent's root is already known.
        parent[member] = parent[parent[member]];
        rootAndPart.emplace_back(parent[member], member);
    }
    std::sort(rootAndPart.begin(), rootAndPart.end());
    Merged merged;
    merged.boxes.reserve(pieces.size());
    for (const Piece &piece : pieces) merged.boxes.push_back(piece.box);
    merged.parts.reserve(members.size());
    for (const auto &[root, part] : rootAndPart) {
        if (root == part) merged.first.push_back(static_cast<uint32_t>(merged.parts.size()));
        merged.parts.push_back(part);
    }
    merged.first.push_back(static_cast<uint32_t>(merged.parts.size()));
    return merged;
}

} // namespace

Merged mergeFlush(std::span<const phys_box> given, std::span<const uint32_t> members) {
    if (members.empty()) return {{}, {0}, {}};
    std::vector<Piece> pieces;
    pieces.reserve(members.size());
    for (const uint32_t member : members) pieces.push_back({given[member], member, false});
    Merger merger(std::move(pieces), given.size());
    merger.run();
    if (merger.pieceCount() == members.size()) return eachItself(given, members);
    return gather(merger.takePieces(), merger.takeParents(), members);
}

} // namespace phys
