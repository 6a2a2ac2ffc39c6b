// SPDX-License-Identifier: MIT
// Where a ball that lies on a floor meets nothing but that floor and faces to lean on, found once for many steps.
#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <memory>

namespace phys {

/// A rectangle of places for the centre of a ball at one height. It lies over one floor, and the same boxes as a
/// FloorView sees are clear of it.
struct FloorRegion {
    struct Range {
        double low = 1.0, high = -1.0; ///< m: between these no wall is near; nowhere yet
        /// m: where the centre is while the ball leans on a face at that end, which is upright and as long as the
        /// region; kNoFace if there is none.
        double lowFace = kNoFace, highFace = kNoFace;
        uint32_t lowBox = PHYS_NO_BOX, highBox = PHYS_NO_BOX; ///< whose faces those are

        bool isFree(double place) const { return place >= low && place <= high; }
        bool isFace(double place) const { return place == lowFace || place == highFace; }
        bool has(double place) const { return isFree(place) || isFace(place); }
        bool keeps(double place, double way, double bend) const {
            return isFace(place) ||
                   (isFree(place + std::min(way, 0.0) - bend) && isFree(place + std::max(way, 0.0) + bend));
        }
    };
    static constexpr double kNoFace = 0x1p200; ///< beyond all places

    std::array<Range, 2> along; ///< x, y
    double z = 0.0;             ///< m: height of the centre
    uint32_t floor = PHYS_NO_BOX;
    bool isEven = false; ///< that height is exactly where the floor carries a ball, and no other floor is near

    /// The axis across a face that a ball in the region leans on.
    int leansAlong(const Vec3 &place) const {
        return place.x == along[0].lowFace || place.x == along[0].highFace ? 0 : 1;
    }
    bool has(const phys_vec3 &place) const { return place.z == z && along[0].has(place.x) && along[1].has(place.y); }
    /// Whether a ball in it stays in it for a time, unless it leaves a face that it leans on. acceleration: at most.
    bool keeps(const Vec3 &place, const Vec3 &velocity, double time, double acceleration) const {
        const double bend = 0.5 * time * time * acceleration;
        return along[0].keeps(place.x, time * velocity.x, bend) && along[1].keeps(place.y, time * velocity.y, bend);
    }
};

/// Regions found so far. They follow from the scene alone, and no step depends on which of them it is made in.
class FloorRegions {
public:
    explicit FloorRegions(const Scene &scene);

    /// A region that has the place, or nullptr. isLeaning: which of two to keep.
    const FloorRegion *around(const phys_vec3 &place, bool isLeaning) {
        return m_last->has(place) ? m_last : find(place, isLeaning);
    }
    /// The one that was found last.
    const FloorRegion &last() const { return *m_last; }
    /// As around, without asking the last one first.
    const FloorRegion *find(const phys_vec3 &place, bool isLeaning);

private:
    static constexpr uint32_t kKept = 1024; ///< a power of two

    const Scene &m_scene;
    std::unique_ptr<std::array<FloorRegion, kKept>> m_regions;
    const FloorRegion *m_last; ///< one of them
};

} // namespace phys
