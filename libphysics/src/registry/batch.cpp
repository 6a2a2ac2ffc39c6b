// SPDX-License-Identifier: MIT
// Many balls, many steps: what phys_step does in a loop, with everything that stays the same looked at once.
#include "base/appendable.h"
#include "base/error.h"
#include "base/float_environment.h"
#include "registry/arguments.h"
#include "registry/params.h"
#include "registry/stepper.h"

#include <algorithm>

namespace phys {

namespace {

/// Element `index` of an array whose elements are `stride` bytes apart; 0: one element for all.
template<class T>
T *at(T *first, size_t stride, uint64_t index) {
    using Byte = std::conditional_t<std::is_const_v<T>, const char, char>;
    return reinterpret_cast<T *>(reinterpret_cast<Byte *>(first) + stride * index);
}

uint64_t pathLength(const phys_batch &batch) { return batch.path ? batch.step_count / batch.path_every : 0; }

phys_status refuseStride(const char *name, size_t stride, uint64_t least, phys_error *err) {
    return fail(err, PHYS_ERROR_ARGUMENT, "%s is %zu; expected a multiple of 8 and at least %llu", name, stride,
                static_cast<unsigned long long>(least));
}

phys_status checkStrides(const phys_batch &batch, phys_error *err) {
    // What is only read may be shared; two balls never write to one place.
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
    if (!batch.states || !batch.params) {
        return fail(err, PHYS_ERROR_ARGUMENT, "batch.%s is NULL", batch.states ? "params" : "states");
    }
    if (first > batch.ball_count || count > batch.ball_count - first) {
        return fail(err, PHYS_ERROR_ARGUMENT, "%llu balls from %llu on; the batch has %llu",
                    static_cast<unsigned long long>(count), static_cast<unsigned long long>(first),
                    static_cast<unsigned long long>(batch.ball_count));
    }
    if (const uint32_t unknown = batch.stop_flags & ~static_cast<uint32_t>(PHYS_STATE_FLAGS)) {
        return fail(err, PHYS_ERROR_ARGUMENT, "stop_flags has the unknown bits 0x%x; known bits are 0x%x", unknown,
                    PHYS_STATE_FLAGS);
    }
    if (batch.path && batch.path_every == 0) {
        return fail(err, PHYS_ERROR_ARGUMENT, "path_every is 0; expected 1 or more with a path");
    }
    if (const phys_status status = checkDt(batch.dt, err)) return status;
    return checkStrides(batch, err);
}

/// Parameters of one size, whatever version of the struct the caller has.
phys_params wholeParams(const phys_params &given) {
    return isOlder(given) ? completed(given, phys_params_init) : given;
}

/// One ball's way through the batch.
class BallRun {
public:
    BallRun(const phys_stepper &stepper, const phys_batch &batch, uint64_t ball)
        : m_stepper(stepper)
        , m_batch(batch)
        , m_gravity(batch.gravity ? at(batch.gravity, batch.gravity_ball_stride, ball) : nullptr)
        , m_path(batch.path ? at(batch.path, batch.path_ball_stride, ball) : nullptr)
        , m_result(*at(batch.states, batch.states_stride, ball))
        , m_states{m_result, {}}
        , m_pathSteps(batch.path_every) {}

    uint64_t stepsDone() const { return m_done; }

    /// paramsAreChecked: except for gravity, where the batch brings its own.
    phys_status run(phys_params params, bool paramsAreChecked) {
        phys_status status = PHYS_OK;
        if (!isOver()) status = start(params, paramsAreChecked);
        while (status == PHYS_OK && !isOver()) {
            if (m_gravity) params.gravity = *at(m_gravity, m_batch.gravity_step_stride, m_done);
            status = step(params, m_states[1 - m_now]);
            if (status == PHYS_OK) takeNext();
        }
        m_result = state();
        fillPath();
        return status;
    }

private:
    const phys_state &state() const { return m_states[m_now]; }
    bool isOver() const { return m_done == m_batch.step_count || (state().flags & m_batch.stop_flags); }

    phys_status start(phys_params &params, bool paramsAreChecked) const {
        if (m_gravity) params.gravity = *m_gravity;
        if (!paramsAreChecked) {
            if (const phys_status status = checkParams(*m_stepper.api, params, nullptr)) return status;
        }
        if (m_gravity && !gravityIsValid(params)) return PHYS_ERROR_RANGE; // as in phys_step before the state
        return checkState(state(), nullptr);
    }

    phys_status step(const phys_params &params, phys_state &next) const {
        if (m_gravity && !gravityIsValid(params)) return PHYS_ERROR_RANGE;
        if (const phys_status status = checkPull(*m_stepper.scene, params, state(), nullptr)) return status;
        if (m_batch.dt > 0.0) return advance(m_stepper, params, m_batch.dt, state(), next, nullptr, nullptr);
        next = state();
        return PHYS_OK;
    }

    void takeNext() {
        m_now = 1 - m_now;
        ++m_done;
        if (!m_path || --m_pathSteps > 0) return;
        m_pathSteps = m_batch.path_every;
        m_path[m_pathCount++] = state();
    }

    /// A ball that is done stays where it is.
    void fillPath() {
        const uint64_t length = pathLength(m_batch);
        if (m_pathCount < length) std::fill(m_path + m_pathCount, m_path + length, state());
    }

    const phys_stepper &m_stepper;
    const phys_batch &m_batch;
    const phys_vec3 *m_gravity; ///< of this ball's first step; nullptr: that of the parameters
    phys_state *m_path;         ///< this ball's row, or nullptr
    phys_state &m_result;       ///< the caller's
    phys_state m_states[2];     ///< by turns the last good one and the next
    int m_now = 0;              ///< which is the last good one
    uint64_t m_done = 0;
    uint64_t m_pathSteps; ///< until the next state of the path
    uint64_t m_pathCount = 0;
};

/// Parameters that all balls share are wrong for all of them.
phys_status checkSharedParams(const phys_stepper &stepper, const phys_batch &batch, phys_error *err) {
    phys_params params = wholeParams(*batch.params);
    if (batch.gravity) params.gravity = {0.0, 0.0, 0.0}; // another one counts
    return checkParams(*stepper.api, params, err);
}

phys_status runBalls(const phys_stepper &stepper, const phys_batch &batch, uint64_t first, uint64_t count,
                     phys_error *err) {
    const bool areShared = batch.params_stride == 0;
    if (areShared) {
        if (const phys_status status = checkSharedParams(stepper, batch, err)) return status;
    }
    phys_status worst = PHYS_OK;
    for (uint64_t ball = first; ball < first + count; ++ball) {
        BallRun run(stepper, batch, ball);
        const phys_status status = run.run(wholeParams(*at(batch.params, batch.params_stride, ball)), areShared);
        if (batch.steps_done) batch.steps_done[ball] = run.stepsDone();
        if (batch.statuses) batch.statuses[ball] = status;
        if (status == PHYS_OK || worst != PHYS_OK || batch.statuses) continue;
        worst = fail(err, status, "ball %llu fails in step %llu: %s", static_cast<unsigned long long>(ball),
                     static_cast<unsigned long long>(run.stepsDone()), phys_status_text(status));
    }
    return worst;
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
