// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/ball_place.h"

#include "core/setup/walls.h"

#include <optional>

namespace inspector {

namespace {

constexpr int kPushes = 64;     ///< several are needed in a corner
constexpr double kTouch = 1e-9; ///< of the radius

/// The height of the highest floor under this position: a top of a box that a ball at the start's height could roll on.
std::optional<double> floorBelow(const phys_scene *scene, const phys_vec3 &place) {
    phys_state start;
    phys_scene_start(scene, &start);
    const double highest = start.position.z - 0.5 * phys_scene_radius(scene);
    const phys_box *boxes = phys_scene_boxes(scene);
    std::optional<double> found;
    for (const phys_box *box = boxes; box != boxes + phys_scene_box_count(scene); ++box) {
        const bool isBelow = box->max.z <= highest && box->min.x <= place.x && place.x <= box->max.x &&
                             box->min.y <= place.y && place.y <= box->max.y;
        if (isBelow && (!found || box->max.z > *found)) found = box->max.z;
    }
    return found;
}

} // namespace

phys_vec3 freePlace(const phys_scene *scene, const phys_vec3 &wanted) {
    phys_vec3 place = wanted;
    for (int i = 0; i < kPushes; ++i) {
        if (const std::optional<double> floor = floorBelow(scene, place)) place.z = *floor + phys_scene_radius(scene);
        const std::optional<phys_contact> wall = nearestWall(scene, place, 0.0);
        if (!wall || wall->gap >= -kTouch * phys_scene_radius(scene)) break;
        pushOut(*wall, phys_scene_radius(scene), place);
    }
    return place;
}

/// v = spin x (R up): model.md 1.
phys_vec3 rollingSpin(const phys_vec3 &velocity, double radius) {
    return {-velocity.y / radius, velocity.x / radius, 0.0};
}

} // namespace inspector
