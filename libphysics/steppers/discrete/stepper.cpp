// SPDX-License-Identifier: MIT
#include "stepper.h"

#include "orientation.h"

namespace phys {

namespace {

constexpr phys_param_row kAsReported{"as_reported",
                                     "Without cures and substeps",
                                     "",
                                     "1 steps as games usually do: one substep whatever the speed, and a plain bounce "
                                     "in contact. It shows tunnelling and "
                                     "jitter. Default: 0.",
                                     "",
                                     0,
                                     1,
                                     0,
                                     1,
                                     0,
                                     1,
                                     static_cast<uint32_t>(offsetof(phys_params, stepper)),
                                     PHYS_ROW_SWITCH};

} // namespace

constinit const phys_param_row *const kDiscreteRows[1] = {&kAsReported};

Ball loadBall(const phys_state &state) {
    return {toVec(state.position), toVec(state.velocity), toVec(state.spin), false};
}

void storeBall(const Scene &scene, const phys_params &params, const Ball &ball, uint64_t flags, phys_state &out) {
    out.position = fromVec(ball.position);
    out.velocity = fromVec(ball.velocity);
    out.spin = fromVec(ball.spin);
    const phys_box &bounds = scene.bounds;
    const Vec3 &p = ball.position;
    const bool inside = p.x >= bounds.min.x && p.x <= bounds.max.x && p.y >= bounds.min.y && p.y <= bounds.max.y;
    if (!inside) flags |= PHYS_OUT;
    const bool onFloor = !(flags & PHYS_AIRBORNE);
    if (params.model == PHYS_MODEL_RIGID && onFloor && !rolls(ball, scene.radius)) flags |= PHYS_SLIPPING;
    out.flags = flags;
}

void turn(const phys_state &in, double dt, phys_state &out) {
    rotate(out.orientation, 0.5 * dt * (toVec(in.spin) + toVec(out.spin)));
}

void reportTransitions(Reporter &reporter, double dt, const phys_state &in, bool wasSupported, const phys_state &out) {
    const double before = glm::length(toVec(in.velocity));
    const double after = glm::length(toVec(out.velocity));
    const auto event = [&](uint32_t kind) {
        reporter.event(kind, dt, toVec(out.position), Vec3(0.0), before, after, PHYS_NO_BOX);
    };
    if (wasSupported && (out.flags & PHYS_AIRBORNE)) event(PHYS_EVENT_TAKEOFF);
    if (before > 0.0 && (out.flags & PHYS_AT_REST)) event(PHYS_EVENT_STOP);
}

phys_status keepScene(const phys_scene_view *view, void **self, phys_error *) {
    *self = const_cast<void *>(view->scene); // only ever read
    return PHYS_OK;
}

void forgetScene(void *) {}

phys_status refuseSubsteps(double substeps, phys_error *err) {
    return fail(err, PHYS_ERROR_SUBSTEP_CAP,
                "this step needs %.9g substeps of half a radius; at most %u are allowed: "
                "take a smaller dt",
                substeps, kSubstepCap);
}

phys_status refuseStuck(const phys_state &in, phys_error *err) {
    return fail(err, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) overlaps boxes with no room for it between them",
                in.position.x, in.position.y, in.position.z);
}

} // namespace phys
