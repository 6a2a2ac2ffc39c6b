// SPDX-License-Identifier: MIT
#include "overlap.h"

#include "contact/near.h"
#include "scene/nearest.h"

#include <cmath>

namespace phys {

namespace {

constexpr int kMostOverlapPasses = 8;

struct Overlap {
    Nearest nearest{{}, {}, INFINITY, 0};
    uint32_t box = PHYS_NO_BOX;
};

/// The deepest overlap; of equal ones the box with the lowest number.
Overlap deepestOverlap(const Scene &scene, const Vec3 &position) {
    Overlap deepest;
    const double touching = scene.radius - scene.tolerance;
    visitNear(scene, position, scene.radius, [&](const phys_box &box, uint32_t number) {
        if (squaredDistance(box, position) >= touching * touching) return;
        const Nearest candidate = nearest(box, position);
        if (candidate.distance < deepest.nearest.distance) deepest = {candidate, number};
    });
    return deepest;
}

/// The contact by which such an overlap is treated.
Contact contactOf(const StepContext &context, const Overlap &overlap) {
    const phys_params &params = context.params();
    Contact contact{};
    contact.point = overlap.nearest.point;
    contact.normal = overlap.nearest.normal;
    contact.isTop = contact.normal == Vec3(0.0, 0.0, 1.0);
    contact.restitution = contact.isTop ? params.restitution_floor : params.restitution_wall;
    contact.friction = !context.isRigid() ? 0.0 : contact.isTop ? params.sliding_friction : params.wall_friction;
    contact.box = overlap.box;
    return contact;
}

} // namespace

void collideAsReported(const StepContext &context, double h, double after, Ball &ball) {
    for (int pass = 0; pass < kMostOverlapPasses; ++pass) {
        const Overlap overlap = deepestOverlap(context.scene(), ball.position);
        if (overlap.box == PHYS_NO_BOX) return;
        context.report.penetration(context.radius() - overlap.nearest.distance);
        context.report.passes(pass + 1);
        ball.position = overlap.nearest.point + context.radius() * overlap.nearest.normal;

        // The floor supports what comes down on it slowly; walls respond to every overlap in the same way.
        Contact contact = contactOf(context, overlap);
        if (contact.isTop) contact.restSpeed = 2.0 * h * std::max(0.0, -context.params().gravity.z);
        Contacts contacts;
        contacts.add(contact);
        if (hit(context, contacts, after, 0.0, ball)) continue;
        if (contact.isTop && ball.velocity.z < 0.0) ball.velocity.z = 0.0;
    }
}

} // namespace phys
