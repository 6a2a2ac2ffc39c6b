// SPDX-License-Identifier: MIT
// Regions in which a ball on a floor meets only that floor and faces to lean on, found once for many steps.
#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <memory>

namespace phys {

/// A rectangle of positions for the centre of a ball at one height. It lies over one floor, and the boxes seen by a
/// FloorView have a clearance from it.
struct FloorRegion {
    struct Range {
        double low = 1.0, high = -1.0; ///< m: no wall is near between these; initially empty
        /// m: position of the centre while the ball leans on a vertical face at that end, which extends along the whole
        /// region; kNoFace if there is none.
        double lowFace = kNoFace, highFace = kNoFace;
        /// The boxes whose vertical faces bound it: those, or shorter ones, which the ball can be sure to meet only
        /// beside them; PHYS_NO_BOX if there is none.
        uint32_t lowBox = PHYS_NO_BOX, highBox = PHYS_NO_BOX;

        bool isFree(double place) const { return place >= low && place <= high; }
        bool isFace(double place) const { return place == lowFace || place == highFace; }
        bool has(double place) const { return isFree(place) || isFace(place); }
        /// Whether it ends before a place, but not at a face.
        bool endsOpenBefore(double place) const {
            return (place < low && lowFace == kNoFace) || (place > high && highFace == kNoFace);
        }
        /// Whether it ends before a place, but not at a box.
        bool endsOpen(double place) const {
            return (place < low && lowBox == PHYS_NO_BOX) || (place > high && highBox == PHYS_NO_BOX);
        }
        /// bend: how far the ball may be off the straight way, m.
        bool isFreeOnWay(double place, double way, double bend) const {
            return place + std::min(way, 0.0) - bend >= low && place + std::max(way, 0.0) + bend <= high;
        }
        bool keeps(double place, double way, double bend) const {
            return isFace(place) || isFreeOnWay(place, way, bend);
        }
    };
    static constexpr double kNoFace = 0x1p200; ///< beyond all positions

    std::array<Range, 2> along; ///< x, y
    double z = 0.0;             ///< m: height of the centre
    Vec2 foundAt{0.0};          ///< m: the position for which it was found
    uint32_t floor = PHYS_NO_BOX;
    bool isEven = false;    ///< that height is exactly where the floor carries a ball, and no other floor is near
    bool hasSlopes = false; ///< a box near it may touch the ball above or below its centre: a roof or a kerb

    bool has(const phys_vec3 &place) const { return place.z == z && along[0].has(place.x) && along[1].has(place.y); }
    /// Whether a straight way leads out of it where no box bounds it.
    bool endsOpenOn(const Vec2 &way, const phys_vec3 &place) const {
        return along[0].endsOpen(place.x + way.x) || along[1].endsOpen(place.y + way.y);
    }
    /// Whether a ball in the region stays in it for a time, unless it leaves a face on which it leans. acceleration:
    /// upper bound.
    bool keeps(const Vec3 &place, const Vec3 &velocity, double time, double acceleration) const {
        const double bend = 0.5 * time * time * acceleration;
        return along[0].keeps(place.x, time * velocity.x, bend) && along[1].keeps(place.y, time * velocity.y, bend);
    }
};

/// Cache of regions. They follow from the scene alone, and no step depends on which of them is used.
class FloorRegions {
public:
    /// Where regions may lie: at a box's faces only, or also at its upright edges. Steppers of fixed substeps round
    /// otherwise there than in a region.
    enum class Beside { faces, edges };

    FloorRegions(const Scene &scene, Beside beside);

    /// A region that contains the position, or nullptr. Of a ball that moves along an axis preferably one with a face
    /// on which it leans; time: for which it should stay there, if possible, s.
    const FloorRegion *around(const phys_vec3 &place, const Vec2 &velocity, double time = 0.0) {
        return m_last->has(place) ? m_last : find(place, velocity, time);
    }
    /// The region that was found last.
    const FloorRegion &last() const { return *m_last; }
    /// Like around, without trying the last one first.
    const FloorRegion *find(const phys_vec3 &place, const Vec2 &velocity, double time = 0.0);
    /// Like around, if the one that was found for `tried` ends near the ball; nullptr if there is no other: that of its
    /// own grid cell may extend further.
    const FloorRegion *another(Vec2 tried, const phys_vec3 &place, const Vec2 &velocity, double time) {
        const FloorRegion *region = find(place, velocity, time);
        return region && region->foundAt != tried ? region : nullptr;
    }

private:
    static constexpr uint32_t kKept = 1024; ///< a power of two

    const Scene &m_scene;
    Beside m_beside;
    std::unique_ptr<std::array<FloorRegion, kKept>> m_regions;
    const FloorRegion *m_last; ///< one of them
};

} // namespace phys
