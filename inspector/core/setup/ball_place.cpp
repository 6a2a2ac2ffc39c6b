// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/ball_place.h"

#include "core/setup/walls.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace inspector {

namespace {

constexpr int kPushes = 64;       ///< several are needed in a corner
constexpr double kTouch = 1e-9;   ///< of the radius
constexpr double kOnFloor = 1e-3; ///< of the radius: a smaller gap to the floor isn't seen

bool isOver(const phys_box &box, const phys_vec3 &place) {
    return box.min.x <= place.x && place.x <= box.max.x && box.min.y <= place.y && place.y <= box.max.y;
}

/// Visits the boxes on whose tops a ball at the height of the start's floor could roll.
template<typename Visit>
void forFloors(const phys_scene *scene, Visit visit) {
    const double highest = startingFloor(scene) + 0.5 * phys_scene_radius(scene);
    const phys_box *boxes = phys_scene_boxes(scene);
    for (const phys_box *box = boxes; box != boxes + phys_scene_box_count(scene); ++box)
        if (box->max.z <= highest) visit(*box);
}

/// The height of a ball on the highest floor under its centre.
std::optional<double> heightOnFloor(const phys_scene *scene, const phys_vec3 &place) {
    std::optional<double> found;
    forFloors(scene, [&](const phys_box &floor) {
        const double height = floor.max.z + phys_scene_radius(scene);
        if (isOver(floor, place)) found = std::max(found.value_or(height), height);
    });
    return found;
}

/// The height of a ball that is lowered here until it touches a floor, possibly at an edge.
std::optional<double> heightOnRim(const phys_scene *scene, const phys_vec3 &place) {
    const double radius = phys_scene_radius(scene);
    std::optional<double> found;
    forFloors(scene, [&](const phys_box &floor) {
        const double aside = std::hypot(place.x - std::clamp(place.x, floor.min.x, floor.max.x),
                                        place.y - std::clamp(place.y, floor.min.y, floor.max.y));
        if (aside >= radius) return;
        const double height = floor.max.z + std::sqrt(radius * radius - aside * aside);
        found = std::max(found.value_or(height), height);
    });
    return found;
}

std::vector<phys_contact> contactsWithin(const phys_scene *scene, const phys_vec3 &centre, double reach) {
    std::vector<phys_contact> contacts(64);
    uint32_t count = 0;
    phys_scene_contacts(scene, &centre, reach, contacts.data(), uint32_t(contacts.size()), &count);
    contacts.resize(std::min(size_t(count), contacts.size()));
    return contacts;
}

} // namespace

phys_vec3 freePlace(const phys_scene *scene, const phys_vec3 &wanted) {
    const double radius = phys_scene_radius(scene);
    phys_vec3 place = wanted;
    for (int i = 0; i < kPushes; ++i) {
        const std::optional<double> onFloor = heightOnFloor(scene, place);
        place.z = onFloor ? *onFloor : heightOnRim(scene, place).value_or(wanted.z);
        const std::optional<phys_contact> wall = nearestWall(scene, place, 0.0);
        if (!wall || wall->gap >= -kTouch * radius) return place;
        pushOut(*wall, radius, place);
    }
    return place;
}

bool isCarried(const phys_scene *scene, const phys_vec3 &centre) {
    const std::vector<phys_contact> contacts = contactsWithin(scene, centre, kOnFloor * phys_scene_radius(scene));
    return std::ranges::any_of(contacts, [](const phys_contact &contact) { return contact.normal.z > 0.0; });
}

double overlapOf(const phys_scene *scene, const phys_vec3 &centre) {
    double deepest = 0.0;
    for (const phys_contact &contact : contactsWithin(scene, centre, 0.0)) deepest = std::max(deepest, -contact.gap);
    return deepest;
}

double startingFloor(const phys_scene *scene) {
    phys_state start;
    phys_scene_start(scene, &start);
    std::optional<double> found;
    const phys_box *boxes = phys_scene_boxes(scene);
    for (const phys_box *box = boxes; box != boxes + phys_scene_box_count(scene); ++box)
        if (box->max.z <= start.position.z && isOver(*box, start.position))
            found = std::max(found.value_or(box->max.z), box->max.z);
    return found.value_or(start.position.z - phys_scene_radius(scene));
}

bool hasFloorBelow(const phys_scene *scene, const phys_vec3 &centre) {
    const phys_box *boxes = phys_scene_boxes(scene);
    return std::any_of(boxes, boxes + phys_scene_box_count(scene),
                       [&centre](const phys_box &box) { return box.max.z <= centre.z && isOver(box, centre); });
}

/// v = spin x (R up): model.md 1.
phys_vec3 rollingSpin(const phys_vec3 &velocity, double radius) {
    return {-velocity.y / radius, velocity.x / radius, 0.0};
}

} // namespace inspector
