// SPDX-License-Identifier: MIT
#include "contact/push_out.h"

#include "contact/contact.h"
#include "contact/least_push.h"
#include "contact/near.h"
#include "scene/nearest.h"

#include <cmath>
#include <tuple>

namespace phys {

namespace {

/// After this many passes there is no room in this direction.
constexpr uint32_t kMostPasses = 32;

/// Pushes between two faces may be longer than either depth, by up to this factor.
constexpr double kAbout = 4.0;

/// Largest depth of the ball in a box at one position, m; 0 or less if it overlaps none.
double deepestAt(const Scene &scene, const Vec3 &position, Work &work) {
    const double touching = scene.radius - scene.tolerance;
    double depth = 0.0;
    visitNear(scene, position, scene.radius, [&](const phys_box &box, uint32_t) {
        work.add(Work::kBox);
        if (squaredDistance(box, position) >= touching * touching) return;
        depth = std::max(depth, scene.radius - nearest(box, position).distance); // distance is negative inside
    });
    return depth;
}

/// The boxes that a push must consider: those that the ball overlaps, and those that it would overlap after a push of
/// limited length.
struct Overlaps {
    std::array<Push, Contacts::kMost> pushes;
    uint32_t count = 0;
    bool isCentreInside = false;

    void add(const Nearest &nearest, double radius) {
        isCentreInside = isCentreInside || nearest.feature == PHYS_FEATURE_INSIDE;
        if (count < Contacts::kMost) pushes[count++] = {nearest.normal, radius - nearest.distance};
    }

    /// The shortest push out of all boxes. Reflections and the numbering of boxes must not change it: of boxes that are
    /// equally deep none comes first; the result is the mean of both orders.
    Vec3 leastPushOut(double negligible, Work &work) {
        const auto inOrder = [&](double direction) {
            std::sort(pushes.begin(), pushes.begin() + count, [direction](const Push &a, const Push &b) {
                const Vec3 first = direction * a.normal, second = direction * b.normal;
                return std::tie(b.wanted, first.x, first.y, first.z) < std::tie(a.wanted, second.x, second.y, second.z);
            });
            return leastPush({pushes.data(), count}, negligible, work);
        };
        return count < 2 ? inOrder(1.0) : 0.5 * (inOrder(1.0) + inOrder(-1.0));
    }
};

/// about: additional distance within which boxes are considered, m.
Overlaps overlapsAt(const Scene &scene, const Vec3 &position, double about, Work &work) {
    Overlaps overlaps;
    const double reach = scene.radius + about;
    visitNear(scene, position, reach, [&](const phys_box &box, uint32_t) {
        work.add(Work::kBox);
        if (squaredDistance(box, position) < reach * reach) overlaps.add(nearest(box, position), scene.radius);
    });
    return overlaps;
}

/// The displacement along one axis (in one direction) to the next place with room for the ball.
double wayOut(const Scene &scene, const Vec3 &start, int axis, double direction, Work &work) {
    const double touching = scene.radius - scene.tolerance;
    Vec3 position = start;
    // Each box in the way pushes the ball to its far side; none can do so twice.
    for (size_t i = 0; i <= scene.given.size() && !work.isTooMuch(); ++i) {
        double far = position[axis];
        visitNear(scene, position, scene.radius, [&](const phys_box &box, uint32_t) {
            work.add(Work::kBox);
            if (squaredDistance(box, position) >= touching * touching) return;
            Vec3 beside = position;
            beside[axis] = limited(position[axis], (&box.min.x)[axis], (&box.max.x)[axis]);
            const double across = squaredDistance(box, beside);
            const double room = std::sqrt(std::max(0.0, scene.radius * scene.radius - across));
            const double edge = direction > 0.0 ? (&box.max.x)[axis] + room : (&box.min.x)[axis] - room;
            if ((edge - far) * direction > 0.0) far = edge;
        });
        if (far == position[axis]) return std::abs(position[axis] - start[axis]);
        position[axis] = far;
    }
    return INFINITY;
}

/// Moves straight to the nearest place with room; order of ties: -x, +x, -y, +y, -z, +z.
bool escape(const Scene &scene, Vec3 &position, Work &work) {
    double nearest = INFINITY;
    Vec3 place = position;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double direction : {-1.0, 1.0}) {
            const double way = wayOut(scene, position, axis, direction, work);
            if (way >= nearest) continue;
            nearest = way;
            place = position;
            place[axis] += direction * way;
        }
    }
    if (work.isTooMuch()) return false;
    position = place;
    return nearest < INFINITY;
}

} // namespace

PushOut pushOut(const Scene &scene, Vec3 &position, Work &work) {
    PushOut result{true, 0, 0.0};
    Vec3 place = position;
    double farthest = 0.5 * scene.radius; // no substep moves a ball by more
    for (; result.passes < kMostPasses && !work.isTooMuch(); ++result.passes) {
        const double depth = deepestAt(scene, place, work);
        result.depth = std::max(result.depth, depth);
        if (result.passes == 0) farthest = std::max(farthest, 3.0 * depth);
        if (depth <= 0.0) {
            result.isFree = glm::distance(place, position) <= farthest;
            if (result.isFree) position = place;
            return result;
        }
        Overlaps overlaps = overlapsAt(scene, place, -scene.tolerance, work);
        if (overlaps.isCentreInside) {
            result.isFree = result.passes == 0 && escape(scene, position, work);
            result.passes = 1;
            return result;
        }
        const auto pushed = [&] { return place + overlaps.leastPushOut(0.5 * scene.tolerance, work); };
        Vec3 next = pushed();
        if (deepestAt(scene, next, work) > 0.0) { // boxes into which it would be pushed count as well
            overlaps = overlapsAt(scene, place, std::min(kAbout * depth, 0.25 * scene.radius), work);
            next = pushed();
        }
        place = next;
    }
    result.isFree = false;
    return result;
}

} // namespace phys
