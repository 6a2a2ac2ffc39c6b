// SPDX-License-Identifier: MIT
// The reference: closed forms from event to event, model.md 8. Its error is rounding, amplified by the motion's
// sensitivity.
#include "base/text.h"
#include "discrete/requirements.h"
#include "exact/exact_step.h"
#include "exact/undisturbed.h"
#include "registry/built_in_steppers.h"
#include "registry/lanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace phys {

namespace {

/// The data of a stepper. What it caches between steps follows from the scene, so no result depends on it.
struct Exact {
    explicit Exact(const Scene &ofScene)
        : scene(ofScene)
        , regions(ofScene, FloorRegions::Beside::edges) {}

    const Scene &scene;
    FloorRegions regions;
};

phys_status create(const phys_scene_view *view, void **self, phys_error *) {
    *self = new Exact(*static_cast<const Scene *>(view->scene));
    return PHYS_OK;
}

void destroy(void *self) { delete static_cast<Exact *>(self); }

/// In the longest step, gravity smaller than this (m/s^2) moves no ball noticeably, and nothing moves in less time (s);
/// but their products with lengths underflow, and divisions by them overflow.
constexpr double kTooSmall = 0x1p-400;

bool isNegligible(double value) { return value != 0.0 && std::abs(value) < kTooSmall; }

bool hasNegligible(const phys_vec3 &gravity) {
    const auto &[x, y, z] = gravity;
    const bool hasSmall = std::min(std::min(std::abs(x), std::abs(y)), std::abs(z)) < kTooSmall; // or zero, as levels
    return hasSmall && (isNegligible(x) || isNegligible(y) || isNegligible(z));
}

phys_params withoutNegligibleGravity(phys_params params) {
    for (double *component : {&params.gravity.x, &params.gravity.y, &params.gravity.z}) {
        if (isNegligible(*component)) *component = 0.0;
    }
    return params;
}

phys_status advance(Exact &self, const phys_params &params, double dt, const phys_state &in, phys_state &out,
                    phys_report *report, phys_error *err) {
    return stepExactly(self.scene, self.regions, params, dt, in, out, report, err);
}

phys_status stepExact(void *self, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                      phys_report *report, phys_error *err) {
    Exact &exact = *static_cast<Exact *>(self);
    const double duration = isNegligible(dt) ? 0.0 : dt;
    if (hasNegligible(params->gravity)) [[unlikely]] {
        return advance(exact, withoutNegligibleGravity(*params), duration, *in, *out, report, err);
    }
    return advance(exact, *params, duration, *in, *out, report, err);
}

/// The most frequent steps, without the copies and checks of a step in full.
bool stepUndisturbed(void *self, const phys_params &params, double dt, const phys_state &in, phys_state &out,
                     phys_report *report) {
    Exact &exact = *static_cast<Exact *>(self);
    if (report || dt < kTooSmall || hasNegligible(params.gravity)) return false;
    return moveUndisturbed(exact.regions, exact.scene, params, dt, in, out);
}

/// Only single balls: their motions have too many forms to compute them side by side.
const void *extensionOfExact(void *, const char *id) {
    static constexpr LaneSteps kSteps{
        [](void *, const phys_params &, double, Lanes &) {},
        [](void *, const phys_params &, const phys_state &, Lanes &, uint32_t) { return false; },
        [](Lanes &) { return 0U; },
        [](void *, const phys_params &, double) {},
        stepUndisturbed,
        [](const phys_params &, const Lanes &, uint32_t, phys_state &) {}};
    return std::strcmp(id, kLanesId) == 0 ? &kSteps : nullptr;
}

phys_status requirementsOfExact(void *self, const phys_params *params, double dt, const phys_state *state,
                                phys_requirements *out, phys_error *) {
    const PlanInput input{static_cast<const Exact *>(self)->scene, *params, dt, *state};
    describePlan(input, planStep(input, true), *out);
    char(&substeps)[120] = out->reasons[std::countr_zero(static_cast<uint32_t>(PHYS_STAGE_SUBSTEPS))];
    if (out->stages & PHYS_STAGE_SUBSTEPS) return PHYS_OK;
    writeText(substeps, sizeof substeps, "not needed: every event is found at its own time, whatever the step");
    return PHYS_OK;
}

} // namespace

constinit const phys_stepper_api kExact = {
    .struct_size = sizeof(phys_stepper_api),
    .flags = PHYS_STEPPER_EXACT_IN_DT | PHYS_STEPPER_BITS_EVERYWHERE,
    .id = "exact",
    .name = "Exact",
    .version = "22",
    .summary = "The reference: every event in its place, closed forms between; error = rounding, any step.",
    .rows = nullptr,
    .row_count = 0,
    .reserved = 0,
    .create = create,
    .destroy = destroy,
    .step = stepExact,
    .requirements = requirementsOfExact,
    .extension = extensionOfExact,
};

} // namespace phys
