// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace inspector {

namespace {

/// A box that rises above the ball's lowest point by less than this, in radii, is flush with the floor.
constexpr double kFlush = 1e-3;

} // namespace

std::optional<phys_contact> nearestWall(const phys_scene *scene, const phys_vec3 &centre, double reach) {
    std::array<phys_contact, 64> few;
    std::vector<phys_contact> many; // used if `few` is too small
    std::span<phys_contact> contacts = few;
    uint32_t count = 0;
    phys_scene_contacts(scene, &centre, reach, few.data(), uint32_t(few.size()), &count);
    if (count > few.size()) {
        many.resize(count);
        phys_scene_contacts(scene, &centre, reach, many.data(), count, &count);
        contacts = many;
    }
    const double flush = centre.z - (1.0 - kFlush) * phys_scene_radius(scene);
    std::optional<phys_contact> nearest;
    for (const phys_contact &contact : contacts.first(count)) {
        const bool isWall = contact.normal.z < 1.0 && contact.point.z > flush;
        if (isWall && (!nearest || contact.gap < nearest->gap)) nearest = contact;
    }
    return nearest;
}

/// Moving sideways keeps the nearest point of the wall.
void pushOut(const phys_contact &wall, double radius, phys_vec3 &centre) {
    constexpr double kSlack = 1e-9; // of the distance, against rounding
    const double aside = std::hypot(wall.normal.x, wall.normal.y);
    if (!(wall.gap < 0.0) || !(aside > 0.0)) return;
    const double above = std::min(std::abs(centre.z - wall.point.z), radius);
    const double distance = std::sqrt(radius * radius - above * above) * (1.0 + kSlack);
    centre.x = wall.point.x + distance * wall.normal.x / aside;
    centre.y = wall.point.y + distance * wall.normal.y / aside;
}

} // namespace inspector
