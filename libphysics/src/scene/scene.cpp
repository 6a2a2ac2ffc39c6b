// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include "base/error.h"
#include "scene/merge.h"
#include "scene/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace phys {

namespace {

constexpr double kLargestCoordinate = 1e9;
constexpr double kSmallestRadius = 1e-9;
constexpr double kLargestRadius = 1e6;
constexpr uint32_t kMostBoxes = 1'000'000;

/// Relative to a coordinate larger than its radius by this factor a ball is negligible: steps would be lost in
/// rounding.
constexpr double kMostRadii = 1e12;

/// Width of the grid's cells in radii. Finer cells list fewer boxes, but steps don't gain by that, and scenes take
/// longer to make: `scene/2011 walls` of tests/bench/run --rows.
constexpr double kCellSize = 6.0;

bool isCoordinate(double value) { return std::abs(value) <= kLargestCoordinate; } // false for NaN
bool isPoint(const phys_vec3 &p) { return isCoordinate(p.x) && isCoordinate(p.y) && isCoordinate(p.z); }

phys_status checkDescription(const phys_scene_desc &desc, phys_error *err) {
    if (desc.box_count > kMostBoxes) {
        return fail(err, PHYS_ERROR_SCENE, "box_count is %u; at most %u are allowed", desc.box_count, kMostBoxes);
    }
    if (desc.box_count > 0 && !desc.boxes) {
        return fail(err, PHYS_ERROR_ARGUMENT, "boxes is NULL, but box_count is %u", desc.box_count);
    }
    if (const phys_status status = checkRadius(desc.radius, err)) return status;
    if (const phys_status status = checkStart(desc.start, err)) return status;
    for (uint32_t number = 0; number < desc.box_count; ++number) {
        if (const phys_status status = checkBox(desc.boxes[number], number, err)) return status;
    }
    return PHYS_OK;
}

double largestCoordinate(const phys_box &box) {
    return std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.min.z), std::abs(box.max.x),
                     std::abs(box.max.y), std::abs(box.max.z)});
}

phys_status measure(Scene &scene, phys_error *err) {
    double largest =
        std::max({std::abs(scene.start.x), std::abs(scene.start.y), std::abs(scene.start.z), scene.radius});
    for (const phys_box &box : scene.given) largest = std::max(largest, largestCoordinate(box));
    if (largest > kMostRadii * scene.radius) {
        return fail(err, PHYS_ERROR_SCENE,
                    "radius is %.17g m beside a coordinate of %.17g m; expected at least %.17g m", scene.radius,
                    largest, largest / kMostRadii);
    }
    scene.tolerance = 4.0 * kRounding * largest;
    return PHYS_OK;
}

void findBounds(Scene &scene) {
    if (scene.given.empty()) return;
    scene.bounds = scene.given.front();
    for (const phys_box &box : scene.given) {
        scene.bounds.min = fromVec(glm::min(toVec(scene.bounds.min), toVec(box.min)));
        scene.bounds.max = fromVec(glm::max(toVec(scene.bounds.max), toVec(box.max)));
    }
}

/// The floor's plane is the highest top below the start that isn't above the ball's centre.
void findFloor(Scene &scene) {
    scene.floorTop = -std::numeric_limits<double>::infinity();
    const Vec3 &p = scene.start;
    for (const phys_box &box : scene.boxes) {
        const bool under = p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
        if (!under || box.max.z > p.z) continue;
        if (!scene.hasFloor || box.max.z > scene.floorTop) scene.floorTop = box.max.z;
        scene.hasFloor = true;
    }
    scene.supportedZ = scene.floorTop + scene.radius;
}

void merge(Scene &scene) {
    std::vector<uint32_t> all(scene.given.size());
    std::iota(all.begin(), all.end(), 0U);
    Merged merged = mergeFlush(scene.given, all);
    scene.boxes = std::move(merged.boxes);
    scene.firstPart = std::move(merged.first);
    scene.parts = std::move(merged.parts);
    all.resize(scene.boxes.size());
    scene.allBoxes = std::move(all);
    scene.hasManyBoxes = scene.boxes.size() > kHandful;
}

/// model.md 0: a solid that a supported ball can touch must reach up to its equator.
void checkPlanar(Scene &scene) {
    if (!scene.hasFloor) return;
    const double top = scene.supportedZ + scene.radius;
    for (uint32_t i = 0; i < scene.boxes.size(); ++i) {
        const phys_box &box = scene.boxes[i];
        const bool withinReach = box.max.z > scene.floorTop + scene.tolerance && box.min.z < top - scene.tolerance;
        if (!withinReach || (box.min.z <= scene.supportedZ && box.max.z >= scene.supportedZ)) continue;
        char text[200];
        const bool low = box.max.z < scene.supportedZ;
        writeText(text, sizeof text, "box %u %s at z = %.9g m, %s the ball's centre at %.9g m: the ball would %s",
                  scene.parts[scene.firstPart[i]], low ? "ends" : "begins", low ? box.max.z : box.min.z,
                  low ? "below" : "above", scene.supportedZ, low ? "climb it" : "be pressed down by it");
        scene.nonPlanarReason = text;
        return;
    }
}

uint32_t nearestPart(const Scene &scene, std::span<const uint32_t> parts, const Vec3 &point) {
    const auto distance = [&](uint32_t part) { return squaredDistance(scene.given[part], point); };
    return *std::min_element(parts.begin(), parts.end(),
                             [&](uint32_t a, uint32_t b) { return distance(a) < distance(b); });
}

} // namespace

phys_status checkRadius(double radius, phys_error *err) {
    if (radius >= kSmallestRadius && radius <= kLargestRadius) return PHYS_OK; // false for NaN
    return fail(err, PHYS_ERROR_SCENE, "radius is %.17g m; allowed is %g .. %g m", radius, kSmallestRadius,
                kLargestRadius);
}

phys_status checkStart(const phys_vec3 &start, phys_error *err) {
    if (isPoint(start)) return PHYS_OK;
    return fail(err, PHYS_ERROR_SCENE, "start is (%.17g, %.17g, %.17g); each must be within +-%g m", start.x, start.y,
                start.z, kLargestCoordinate);
}

phys_status checkBox(const phys_box &box, uint32_t number, phys_error *err) {
    for (int axis = 0; axis < 3; ++axis) {
        const char name = "xyz"[axis];
        const double low = (&box.min.x)[axis], high = (&box.max.x)[axis];
        if (!isCoordinate(low) || !isCoordinate(high)) {
            return fail(err, PHYS_ERROR_SCENE, "box %u: %s.%c is %.17g m; expected a number within +-%g m", number,
                        isCoordinate(low) ? "max" : "min", name, isCoordinate(low) ? high : low, kLargestCoordinate);
        }
        if (low <= high) continue;
        return fail(err, PHYS_ERROR_SCENE, "box %u: min.%c = %.17g is above max.%c = %.17g", number, name, low, name,
                    high);
    }
    return PHYS_OK;
}

uint32_t Scene::givenBox(uint32_t box, const Vec3 &point) const { return nearestPart(*this, partsOf(box), point); }

bool Scene::overFloor(double x, double y, double reach) const {
    const std::span<const uint32_t> candidates = boxesNear(x, y, hasManyBoxes);
    return std::any_of(candidates.begin(), candidates.end(), [&](uint32_t i) {
        return std::abs(boxes[i].max.z - floorTop) <= tolerance && isOver(boxes[i], x - reach, y - reach) &&
               isOver(boxes[i], x + reach, y + reach);
    });
}

phys_status makeScene(const phys_scene_desc &desc, Scene &out, phys_error *err) {
    if (const phys_status status = checkDescription(desc, err)) return status;
    if (desc.box_count > 0) out.given.assign(desc.boxes, desc.boxes + desc.box_count);
    out.radius = desc.radius;
    out.start = toVec(desc.start);
    if (const phys_status status = measure(out, err)) return status;
    findBounds(out);
    merge(out);
    out.grid.build(out.boxes, kCandidateReach * out.radius + out.tolerance, kCellSize * out.radius);
    findFloor(out);
    checkPlanar(out);
    return PHYS_OK;
}

} // namespace phys
