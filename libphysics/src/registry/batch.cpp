// SPDX-License-Identifier: MIT
// Many balls, many steps: the same as phys_step in a loop, with checks of constant arguments made once.
#include "base/appendable.h"
#include "base/error.h"
#include "base/float_environment.h"
#include "registry/arguments.h"
#include "registry/clock.h"
#include "registry/side_by_side.h"

namespace phys {

namespace {

phys_status refuseStride(const char *name, size_t stride, uint64_t least, phys_error *err) {
    return fail(err, PHYS_ERROR_ARGUMENT, "%s is %zu; expected a multiple of 8 and at least %llu", name, stride,
                static_cast<unsigned long long>(least));
}

phys_status checkStrides(const phys_batch &batch, phys_error *err) {
    // Inputs may be shared; the outputs of two balls must not overlap.
    const uint64_t own = batch.ball_count > 1 ? 1 : 0;
    const struct {
        const char *name;
        size_t stride;
        uint64_t least;
    } strides[] = {{"params_stride", batch.params_stride, 0},
                   {"gravity_ball_stride", batch.gravity_ball_stride, 0},
                   {"gravity_step_stride", batch.gravity_step_stride, 0},
                   {"states_stride", batch.states_stride, own * sizeof(phys_state)},
                   {"path_ball_stride", batch.path_ball_stride, own * pathLength(batch) * sizeof(phys_state)}};
    for (const auto &[name, stride, least] : strides) {
        if (stride % 8 != 0 || stride < least) return refuseStride(name, stride, least, err);
    }
    return PHYS_OK;
}

phys_status checkBatch(const phys_batch &batch, uint64_t first, uint64_t count, phys_error *err) {
    if (!batch.states && batch.ball_count > 0) return fail(err, PHYS_ERROR_ARGUMENT, "batch.states is NULL");
    if (!batch.params) return fail(err, PHYS_ERROR_ARGUMENT, "batch.params is NULL");
    if (first > batch.ball_count || count > batch.ball_count - first) {
        return fail(err, PHYS_ERROR_ARGUMENT, "%llu balls from %llu on; the batch has %llu",
                    static_cast<unsigned long long>(count), static_cast<unsigned long long>(first),
                    static_cast<unsigned long long>(batch.ball_count));
    }
    if (const uint32_t unknown = batch.stop_flags & ~static_cast<uint32_t>(PHYS_STATE_FLAGS)) {
        return fail(err, PHYS_ERROR_ARGUMENT, "stop_flags has the unknown bits 0x%x; known bits are 0x%x", unknown,
                    PHYS_STATE_FLAGS);
    }
    if (batch.step_count > kCountedSteps) {
        return fail(err, PHYS_ERROR_ARGUMENT, "step_count is %llu; expected at most 2^53 = %llu",
                    static_cast<unsigned long long>(batch.step_count), static_cast<unsigned long long>(kCountedSteps));
    }
    if (batch.path && batch.path_every == 0) {
        return fail(err, PHYS_ERROR_ARGUMENT, "path_every is 0; expected 1 or more with a path");
    }
    if (const phys_status status = checkDt(batch.dt, err)) return status;
    return checkStrides(batch, err);
}

/// Invalid shared parameters fail for all balls.
phys_status checkSharedParams(const phys_stepper &stepper, const phys_batch &batch, phys_error *err) {
    phys_params params = wholeParams(*batch.params);
    if (batch.gravity) params.gravity = {0.0, 0.0, 0.0}; // the batch's gravity is used
    return checkParams(*stepper.api, params, err);
}

phys_status runBalls(phys_stepper &stepper, const phys_batch &batch, uint64_t first, uint64_t count, phys_error *err) {
    const bool areShared = batch.params_stride == 0;
    if (areShared) {
        if (const phys_status status = checkSharedParams(stepper, batch, err)) return status;
    }
    Outcome outcome(batch, err);
    // A ball that slides in a lane needs no test for slipping.
    const bool mayUseLanes =
        batch.dt > 0.0 && batch.dt <= kLongestHarmlessStep && !(batch.stop_flags & PHYS_SLIPPING) && !wantsTally(batch);
    SideBySide(stepper, batch, mayUseLanes ? stepper.lanes : nullptr, areShared, outcome).run(first, first + count);
    return outcome.status();
}

} // namespace

} // namespace phys

phys_status phys_batch_init(phys_batch *batch, size_t size) {
    if (!batch || !phys::isKnownSize<phys_batch>(size)) return PHYS_ERROR_ARGUMENT;
    phys::store(phys_batch{}, size, batch);
    return PHYS_OK;
}

phys_status phys_batch_run(phys_stepper *stepper, const phys_batch *batch, uint64_t first, uint64_t count,
                           phys_error *err) {
    const phys::FloatEnvironment environment;
    if (!stepper || !batch) return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", stepper ? "batch" : "stepper");
    if (phys::isOlder(*batch)) {
        const phys_batch whole = phys::completed(*batch, phys_batch_init);
        return phys_batch_run(stepper, &whole, first, count, err);
    }
    if (batch->struct_size != sizeof *batch) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT, "batch.struct_size is %u; expected %zu: call phys_batch_init first",
                          batch->struct_size, sizeof *batch);
    }
    if (const phys_status status = phys::checkBatch(*batch, first, count, err)) return status;
    return phys::runBalls(*stepper, *batch, first, count, err);
}
