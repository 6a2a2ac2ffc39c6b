// SPDX-License-Identifier: MIT
// What a ball touches at one moment, and how overlaps are resolved: definition D of model.md 10.
#pragma once

#include "contact/response.h"
#include "registry/report.h"
#include "scene/nearest.h"
#include "scene/scene.h"

#include <cmath>

namespace phys {

/// How a stepper answers an overlap.
enum class Bounce {
    Plain,        ///< definition D as it stands
    RestRule,     ///< slow bounces against a pressing force end in contact: cure (b) of model.md 10.3
    EnergyCorrect ///< and the speed gained inside the box is taken back: cures (a) and (b)
};

/// What stays the same during one step.
struct StepContext {
    const Scene &scene;
    const phys_params &params;
    Reporter &report;
    Bounce bounce;
    bool rigid;   ///< model RIGID
    bool useGrid; ///< look boxes up in the grid
    double h;     ///< length of a substep, s
};

/// The walls that a supported ball leans on, model.md 6.3.
struct Pressing {
    static constexpr int kMost = 4;
    Vec2 normals[kMost];
    int count = 0;

    bool any() const { return count > 0; }
    void add(const Vec2 &normal) {
        if (count < kMost) normals[count++] = normal;
    }
    /// Removes from `drive` what the walls take: its projection onto the cone of free directions.
    Vec2 freePart(const Vec2 &drive) const;
};

/// The candidates that one substep can touch, and how near the nearest is.
struct Surroundings {
    std::span<const uint32_t> candidates;
    double nearestSquared; ///< square of the centre's distance to the nearest solid, m^2
};

/// Looks around a ball.
inline Surroundings lookAround(const StepContext &context, const Vec3 &position) {
    const Scene &scene = context.scene;
    Surroundings around{scene.solidsNear(position.x, position.y, context.useGrid), INFINITY};
    for (const uint32_t solid : around.candidates) {
        around.nearestSquared = std::min(around.nearestSquared, squaredDistance(scene.solids[solid], position));
    }
    return around;
}

/// Walls in contact with a supported ball, not receding, that `drive` (m/s^2) presses it against.
Pressing findPressing(const StepContext &context, const Surroundings &around, const Ball &ball, const Vec2 &drive);

/// Whether a solid's flat top (not the floor) carries a ball at this place.
bool carriedBySolid(const StepContext &context, const Surroundings &around, const Vec3 &position);

/// Restitution of the surface with this normal: a floor's or a wall's.
double restitutionOf(const phys_params &params, const Vec3 &normal);

/// Gives the ball `speedAfter` (m/s, >= 0) along the contact's normal, with friction in the rigid model, and reports
/// it.
void bounce(const StepContext &context, const Nearest &contact, uint32_t box, uint32_t kind, double speedAfter,
            double after, Ball &ball);

/// A push with a vertical part lifts a supported ball; the floor answers a push downwards.
void settleSupport(const StepContext &context, Ball &ball);

/// Pushes the ball out of what it overlaps, deepest first, and reflects it. `before`: the ball at the substep's start;
/// `drive`: its acceleration (m/s^2); `after`: seconds into the step. False if it can't be freed.
bool resolveOverlaps(const StepContext &context, const Ball &before, const Vec3 &drive, double after, Ball &ball);

/// A ball whose bounces ended at two walls or more keeps only the velocity that they leave it: between two edges, none.
void stopBetween(const Pressing &ended, Ball &ball);

/// Vertical speed after a landing at `approach` (m/s, >= 0) under the rest rule, which every stepper applies here: the
/// floor is a support, not a contact that bounces in each step.
double landingSpeed(const StepContext &context, double approach);

/// The floor stops a falling ball: it goes on upwards with speedAfter (m/s, >= 0), or stays if that is 0.
void land(const StepContext &context, double speedAfter, double after, Ball &ball);

} // namespace phys
