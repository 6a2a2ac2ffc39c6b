// SPDX-License-Identifier: MIT
#include "surroundings.h"

#include <cmath>
#include <optional>

namespace phys {

namespace {

/// Passes after which overlaps that keep coming back are given up: model.md 5.7.
constexpr uint32_t kPassCap = 64;

/// Speeds along a normal below this share of the speed are rounding: model.md 5.5.
constexpr double kNoSpeed = 1e-14;

/// A normal this near to the vertical is a floor's.
constexpr double kFloorNormal = 0.70710678118654752;

bool isFloorNormal(const Vec3 &normal) { return normal.z > kFloorNormal; }

struct Overlap {
    Nearest nearest;
    uint32_t solid;
};

std::optional<Overlap> deepestOverlap(const StepContext &context, std::span<const uint32_t> candidates,
                                      const Vec3 &position) {
    const Scene &scene = context.scene;
    const double touching = scene.radius - scene.tolerance;
    std::optional<Overlap> deepest;
    for (const uint32_t solid : candidates) {
        if (squaredDistance(scene.solids[solid], position) >= touching * touching) continue;
        const Nearest candidate = nearest(scene.solids[solid], position);
        // The first of equals wins: the lowest number.
        if (!deepest || candidate.distance < deepest->nearest.distance) deepest = Overlap{candidate, solid};
    }
    return deepest;
}

/// Whether a bounce this slow against a pressing force ends in contact: the rest rule of model.md 10.3.
bool endsInContact(double bounced, double restitution, double pressing, double h) {
    return pressing > 0.0 && bounced <= 2.0 * restitution * pressing * h;
}

/// Normal speed, >= 0, with which the ball came to the face that it is now so deep behind: model.md 10.3, cure (a).
/// What it gained inside is no part of the impact.
double speedAtFace(const StepContext &context, double approach, double pressing, double depth) {
    if (context.bounce != Bounce::EnergyCorrect || !(pressing > 0.0)) return approach;
    return std::sqrt(std::max(0.0, approach * approach - 2.0 * pressing * depth));
}

/// Normal speed after a bounce, >= 0: model.md 10.3.
double bouncedSpeed(const StepContext &context, double restitution, double approach, double pressing) {
    const double bounced = restitution * approach;
    if (context.bounce == Bounce::Plain) return bounced;
    return endsInContact(bounced, restitution, pressing, context.h) ? 0.0 : bounced;
}

/// Definition D: an overlap that still approaches bounces at the step's end. Walls whose bounce ends are added to
/// `ended`.
void respond(const StepContext &context, const Nearest &contact, uint32_t box, double depth, const Vec3 &drive,
             double after, Ball &ball, Pressing &ended) {
    const double normalSpeed = glm::dot(ball.velocity, contact.normal);
    if (!(normalSpeed < 0.0)) return;
    const double pressing = -glm::dot(drive, contact.normal);
    const double approach = speedAtFace(context, -normalSpeed, pressing, depth);
    const double speed = bouncedSpeed(context, restitutionOf(context.params, contact.normal), approach, pressing);
    if (approach > 0.0) ball.velocity -= (normalSpeed + approach) * contact.normal;
    bounce(context, contact, box, PHYS_EVENT_IMPACT, speed, after, ball);
    if (speed == 0.0 && contact.normal.z == 0.0) ended.add(inPlane(contact.normal));
}

} // namespace

double restitutionOf(const phys_params &params, const Vec3 &normal) {
    return isFloorNormal(normal) ? params.restitution_floor : params.restitution_wall;
}

Vec2 Pressing::freePart(const Vec2 &drive) const {
    // The cone's nearest point lies inside, on one wall, or in its tip: try them in this order, model.md 6.3.
    const auto allowed = [this](const Vec2 &a, double size) {
        for (int i = 0; i < count; ++i) {
            if (glm::dot(a, normals[i]) < -1e-12 * size) return false;
        }
        return true;
    };
    const double size = std::abs(drive.x) + std::abs(drive.y);
    if (allowed(drive, 0.0)) return drive;
    for (int i = 0; i < count; ++i) {
        const double into = glm::dot(drive, normals[i]);
        if (into >= 0.0) continue;
        const Vec2 along = drive - into * normals[i];
        if (allowed(along, size)) return along;
    }
    return Vec2(0.0);
}

Pressing findPressing(const StepContext &context, const Surroundings &around, const Ball &ball, const Vec2 &drive) {
    Pressing pressing;
    const Scene &scene = context.scene;
    const double touching = scene.radius + scene.tolerance;
    if (around.nearestSquared > touching * touching) return pressing;
    for (const uint32_t solid : around.candidates) {
        if (squaredDistance(scene.solids[solid], ball.position) > touching * touching) continue;
        const Nearest contact = nearest(scene.solids[solid], ball.position);
        if (contact.normal.z != 0.0 || contact.distance < scene.radius - scene.tolerance) continue;
        const Vec2 normal = inPlane(contact.normal);
        const Vec2 velocity = inPlane(ball.velocity);
        const double speed = std::abs(velocity.x) + std::abs(velocity.y);
        const bool stays = std::abs(glm::dot(velocity, normal)) <= kNoSpeed * speed;
        if (!stays || glm::dot(drive, normal) >= 0.0) continue;
        // Round an edge the ball flies off unless it is pressed on harder than it turns: model.md 6.2.
        const bool rounds = contact.feature != PHYS_FEATURE_FACE;
        if (rounds && glm::dot(velocity, velocity) >= -glm::dot(drive, normal) * scene.radius) continue;
        pressing.add(normal);
    }
    return pressing;
}

bool carriedBySolid(const StepContext &context, const Surroundings &around, const Vec3 &position) {
    const Scene &scene = context.scene;
    for (const uint32_t solid : around.candidates) {
        const phys_box &box = scene.solids[solid];
        const bool over =
            position.x >= box.min.x && position.x <= box.max.x && position.y >= box.min.y && position.y <= box.max.y;
        if (over && std::abs(position.z - (box.max.z + scene.radius)) <= scene.tolerance) return true;
    }
    return false;
}

void settleSupport(const StepContext &context, Ball &ball) {
    if (!ball.supported) return;
    if (ball.velocity.z < 0.0) ball.velocity.z = 0.0;
    if (context.scene.hasFloor && ball.position.z < context.scene.supportedZ) {
        ball.position.z = context.scene.supportedZ;
    }
    const bool lifted = ball.velocity.z > 0.0 || ball.position.z > context.scene.supportedZ;
    if (lifted) ball.supported = false;
}

void stopBetween(const Pressing &ended, Ball &ball) {
    if (ended.count < 2) return;
    ball.velocity = Vec3(ended.freePart(inPlane(ball.velocity)), ball.velocity.z);
}

bool resolveOverlaps(const StepContext &context, const Ball &before, const Vec3 &drive, double after, Ball &ball) {
    const Scene &scene = context.scene;
    Pressing ended;
    for (uint32_t pass = 0; pass < kPassCap; ++pass) {
        const auto candidates = scene.solidsNear(ball.position.x, ball.position.y, context.useGrid);
        const auto overlap = deepestOverlap(context, candidates, ball.position);
        if (!overlap) {
            stopBetween(ended, ball);
            return true;
        }
        const Nearest &contact = overlap->nearest;
        const double depth = scene.radius - contact.distance;
        context.report.penetration(depth);
        context.report.passes(pass + 1);
        const uint32_t box = context.report.wanted() ? scene.givenSolid(overlap->solid, contact.point) : 0;
        ball.position = contact.point + scene.radius * contact.normal;
        respond(context, contact, box, depth, drive, after, ball, ended);
        settleSupport(context, ball);
    }
    // It doesn't fit where it was going. Where it came from it did, unless it started inside something.
    const auto candidates = scene.solidsNear(before.position.x, before.position.y, context.useGrid);
    if (deepestOverlap(context, candidates, before.position)) return false;
    ball = before;
    ball.velocity = Vec3(0.0);
    ball.spin = Vec3(0.0);
    return true;
}

void bounce(const StepContext &context, const Nearest &contact, uint32_t box, uint32_t kind, double speedAfter,
            double after, Ball &ball) {
    const phys_params &params = context.params;
    const double speedBefore = glm::dot(ball.velocity, contact.normal);
    Loss loss;
    if (context.rigid) {
        const double friction = isFloorNormal(contact.normal) ? params.sliding_friction : params.wall_friction;
        loss = reflectWithFriction(ball, contact.normal, speedAfter, friction, context.scene.radius);
    } else {
        loss = reflect(ball, contact.normal, speedAfter);
    }
    context.report.lostImpact(loss.impact);
    context.report.lostSlip(loss.slip);
    context.report.event(kind, after, contact.point, contact.normal, speedBefore, speedAfter, box);
}

double landingSpeed(const StepContext &context, double approach) {
    const double restitution = context.params.restitution_floor;
    const double bounced = restitution * approach;
    return endsInContact(bounced, restitution, -context.params.gravity.z, context.h) ? 0.0 : bounced;
}

void land(const StepContext &context, double speedAfter, double after, Ball &ball) {
    const Vec3 point{ball.position.x, ball.position.y, context.scene.floorTop};
    ball.position.z = context.scene.supportedZ;
    const Nearest contact{point, {0, 0, 1}, context.scene.radius, PHYS_FEATURE_FACE};
    const uint32_t box = context.report.wanted() ? context.scene.givenFloorAt(point.x, point.y) : PHYS_NO_BOX;
    bounce(context, contact, box, PHYS_EVENT_LANDING, speedAfter, after, ball);
    if (ball.velocity.z > 0.0) return;
    ball.velocity.z = 0.0;
    ball.supported = context.params.gravity.z < 0.0;
    if (context.rigid || !ball.supported) return;
    // The rolling model knows no spin of its own: the floor gives the ball the one that rolls.
    const double radius = context.scene.radius;
    const Vec3 rolling = rollingSpin(inPlane(ball.velocity), radius);
    const double spinBefore = glm::dot(ball.spin, ball.spin);
    context.report.lostSlip(0.2 * radius * radius * (spinBefore - glm::dot(rolling, rolling)));
    ball.spin = rolling;
}

} // namespace phys
