// SPDX-License-Identifier: MIT
#include "exact/undisturbed.h"

#include "base/numbers.h"
#include "contact/modes.h"
#include "exact/floor_pull.h"
#include "scene/nearest.h"
#include "shared/closed_form.h"

#include <cmath>

namespace phys {

namespace {

/// The motion seen from above.
struct Plane {
    Vec2 place, velocity;
};

/// Whether a ball meets nothing along an axis.
bool isFree(const FloorRegion &region, int axis, const Plane &ball, double dt, double acceleration) {
    const double bend = 0.5 * dt * dt * acceleration;
    return region.along[static_cast<size_t>(axis)].isFreeOnWay(ball.place[axis], dt * ball.velocity[axis], bend);
}

/// False if the ball may stop.
bool moveFreely(const FloorPull &pull, double dt, Plane &ball) {
    ResistedLaw::Point point;
    const double B = pull.resistance();
    if (B == 0.0) {
        const Vec2 v = ball.velocity, a = pull.drive();
        ball = {ball.place + dt * (v + 0.5 * dt * a), v + dt * a};
        return true;
    }
    if (!pull.turns(ball.velocity, B) || !ResistedLaw::goesOn(ball.velocity, pull.drive(), B, dt, point)) return false;
    ball = {ball.place + point.x, point.v};
    return true;
}

/// Along a face that the ball touches. across: axis of the face's normal.
bool moveAlong(int across, const FloorRegion &region, const FloorPull &pull, double dt, const Vec3 &spin, Plane &ball) {
    const FloorRegion::Range &range = region.along[static_cast<size_t>(across)];
    const int along = 1 - across;
    if (!range.isFace(ball.place[across]) || ball.velocity[across] != 0.0) return false;
    const bool isLow = ball.place[across] == range.lowFace;
    if (!pull.presses(across, isLow ? 1 : -1, ball.velocity, spin)) return false;
    const double v = ball.velocity[along], a = pull.accelerationAlong(along, v);
    if (!pull.keepsAcceleration(v, a, dt)) return false;
    ball.place[across] = isLow ? range.lowFace : range.highFace; // a zero may have the opposite sign
    ball.place[along] += dt * (v + 0.5 * dt * a);
    ball.velocity[across] = 0.0;
    ball.velocity[along] = v + dt * a;
    return true;
}

bool move(const FloorRegion &region, const FloorPull &pull, double dt, const Vec3 &spin, Plane &ball) {
    const double most = pull.mostAcceleration();
    const bool isFreeAlongX = isFree(region, 0, ball, dt, most), isFreeAlongY = isFree(region, 1, ball, dt, most);
    if (isFreeAlongX && isFreeAlongY) return moveFreely(pull, dt, ball);
    if (!isFreeAlongX && !isFreeAlongY) return false;
    return moveAlong(isFreeAlongX ? 1 : 0, region, pull, dt, spin, ball);
}

/// False, and nothing is written, if the numbers are beyond those of a valid state.
inline bool store(const Vec3 &place, const Vec3 &velocity, const Vec3 &spin, uint32_t flags, const phys_state &in,
                  phys_state &out) {
    if (!isModerate(fromVec(place)) || !isModerate(fromVec(velocity)) || !isModerate(fromVec(spin))) return false;
    if (&out != &in) out = in;
    // One by one, as a processor stalls if it loads together what was just stored separately.
    out.position.x = place.x;
    out.position.y = place.y;
    out.position.z = place.z;
    out.velocity = fromVec(velocity);
    out.spin = fromVec(spin);
    out.flags = flags;
    return true;
}

/// Far from all boxes.
bool fall(const Scene &scene, const phys_params &params, double dt, const phys_state &in, phys_state &out) {
    const Vec3 place = toVec(in.position), v = toVec(in.velocity), g = toVec(params.gravity);
    const double way = dt * (glm::length(v) + dt * glm::length(g)), reach = 2.0 * scene.radius + way;
    if (!(squaredDistance(scene.bounds, place) > reach * reach)) return false;
    const Vec3 spin = toVec(in.spin) + dt * Vec3(0.0); // a zero may have the opposite sign
    const Vec3 end = place + dt * (v + 0.5 * dt * g);
    const uint32_t isOut = scene.isOut(fromVec(end)) ? PHYS_OUT : 0;
    return store(end, v + dt * g, spin, PHYS_AIRBORNE | isOut, in, out);
}

/// Whether a ball that glides slips. Most do by far more than what the law takes for rounding.
bool slipsGliding(const FloorPull &pull, const Moment &moment) {
    const double R = moment.radius;
    const Vec3 &v = moment.velocity, &spin = moment.spin;
    const Vec2 slip = inPlane(v) - spinSpeed(spin, R);
    const double scale = glm::dot(v, v) + R * R * glm::dot(spin, spin) + R * pull.gravity();
    return glm::dot(slip, slip) > kUnsure * scale || !isNoSlip(moment, slipAt(moment, Vec3(0.0, 0.0, 1.0)));
}

bool moveOnFloor(FloorRegions &regions, const Scene &scene, const phys_params &params, double dt, const phys_state &in,
                 phys_state &out) {
    if (!(params.gravity.z < 0.0)) return false;
    const FloorPull pull(scene, params);
    const Vec3 spin = toVec(in.spin);
    Plane ball{inPlane(in.position), inPlane(in.velocity)};
    if (!pull.goesOn(ball.velocity, spin)) return false;
    // Of a ball that rolls, the loop's sums may change its sign.
    if (!pull.glides() && spin.z == 0.0 && std::signbit(spin.z)) return false;
    const FloorRegion *region = regions.around(in.position, inPlane(in.velocity), dt);
    for (bool isSecond = false; region && !move(*region, pull, dt, spin, ball); isSecond = true) {
        region = isSecond ? nullptr : regions.another(region->foundAt, in.position, inPlane(in.velocity), dt);
    }
    if (!region) return false;
    const double height = scene.boxes[region->floor].max.z + scene.radius;
    Vec3 turning = rollingSpin(ball.velocity, scene.radius);
    if (pull.isRigid()) turning.z = spin.z;
    if (pull.glides()) turning = spin;
    const Moment end{Vec3(ball.velocity, 0.0), turning, toVec(params.gravity), scene.radius, 0.0};
    const bool slips = pull.glides() && slipsGliding(pull, end);
    return store(Vec3(ball.place, height), end.velocity, turning, slips ? PHYS_SLIPPING : 0, in, out);
}

} // namespace

bool moveUndisturbed(FloorRegions &regions, const Scene &scene, const phys_params &params, double dt,
                     const phys_state &in, phys_state &out) {
    if (params.options != 0) return false;
    return in.velocity.z == 0.0 ? moveOnFloor(regions, scene, params, dt, in, out) : fall(scene, params, dt, in, out);
}

} // namespace phys
