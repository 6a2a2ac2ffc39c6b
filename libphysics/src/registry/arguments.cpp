// SPDX-License-Identifier: MIT
#include "registry/arguments.h"

#include "base/error.h"
#include "base/numbers.h"

#include <cmath>

namespace phys {

namespace {

/// A ball that falls onto the floor isn't supported yet: it bounces first.
bool isCarried(const Scene &scene, const phys_state &state) {
    return scene.hasFloor && std::abs(state.position.z - scene.supportedZ) <= scene.tolerance &&
           state.velocity.z == 0.0 && scene.overFloor(state.position.x, state.position.y);
}

} // namespace

phys_status explainState(const phys_state &state, phys_status status, const char *whose, phys_error *err) {
    const phys_vec3 &p = state.position;
    const phys_vec3 &v = state.velocity;
    const phys_vec3 &s = state.spin;
    const double(&q)[4] = state.orientation;
    if (!isModerate(p) || !isModerate(v) || !isModerate(s)) {
        return fail(err, status,
                    "%s has a number that isn't finite or beyond 2^100: position (%.9g, %.9g, %.9g), velocity (%.9g, "
                    "%.9g, %.9g), spin (%.9g, %.9g, %.9g)",
                    whose, p.x, p.y, p.z, v.x, v.y, v.z, s.x, s.y, s.z);
    }
    if (!isModerate(state.time)) {
        return fail(err, status, "%s has the time %.17g s; expected a number within +-2^100", whose, state.time);
    }
    if (!isUnit(q)) {
        return fail(err, status, "%s has the orientation (%.17g, %.17g, %.17g, %.17g); expected a unit quaternion",
                    whose, q[0], q[1], q[2], q[3]);
    }
    return fail(err, status, "%s has the flags 0x%llx; known bits are 0x%x", whose,
                static_cast<unsigned long long>(state.flags), PHYS_STATE_FLAGS);
}

phys_status refuseDt(double dt, phys_error *err) {
    return fail(err, PHYS_ERROR_ARGUMENT, "dt is %.17g s; expected a number from 0 to 2^100", dt);
}

phys_status checkUpwardPull(const Scene &scene, const phys_params &params, const phys_state &state, phys_error *err) {
    if (!isCarried(scene, state)) return PHYS_OK;
    return fail(err, PHYS_ERROR_RANGE, "gravity_z is %.17g m/s^2; while the floor carries the ball it must be below 0",
                params.gravity.z);
}

} // namespace phys
