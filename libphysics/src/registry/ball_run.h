// SPDX-License-Identifier: MIT
// The run of one ball in a batch.
#pragma once

#include "registry/stepper.h"

#include <cstring>
#include <type_traits>

namespace phys {

/// Element `index` of an array whose elements are `stride` bytes apart; 0: one element for all.
template<class T>
T *at(T *first, size_t stride, uint64_t index) {
    using Byte = std::conditional_t<std::is_const_v<T>, const char, char>;
    return reinterpret_cast<T *>(reinterpret_cast<Byte *>(first) + stride * index);
}

/// Whether their bits are the same: zeros have a sign.
inline bool areSame(const phys_vec3 &a, const phys_vec3 &b) {
    return std::memcmp(static_cast<const void *>(&a), static_cast<const void *>(&b), sizeof a) == 0;
}

/// Number of states in a ball's path.
inline uint64_t pathLength(const phys_batch &batch) { return batch.path ? batch.step_count / batch.path_every : 0; }

/// Whether a batch asks for more about its balls than their states.
inline bool wantsTally(const phys_batch &batch) { return batch.impacts || batch.energy_lost; }

/// Parameters of the present size, whatever version of the struct the caller has.
phys_params wholeParams(const phys_params &given);

class BallRun {
public:
    BallRun() = default;
    /// Checks the ball's initial data. paramsAreChecked: except for gravity, if the batch has its own.
    BallRun(phys_stepper &stepper, const phys_batch &batch, uint64_t ball, bool paramsAreChecked);

    uint64_t number() const { return m_number; }
    /// Whether it is neither done nor failed.
    bool isRunning() const { return m_isRunning; }
    phys_status status() const { return m_status; }
    uint64_t stepsDone() const { return m_done; }
    const phys_params &params() const { return m_params; }
    const phys_state &state() const { return m_states[m_now]; }
    phys_state &state() { return m_states[m_now]; }

    /// Gravity of a step, m/s^2.
    const phys_vec3 &gravity(uint64_t step) const {
        return m_gravity ? *at(m_gravity, m_batch->gravity_step_stride, step) : m_params.gravity;
    }

    /// The number of steps after which its path continues, or its run ends.
    uint64_t nextStop() const;
    /// Makes the step of this number, and those until the next stop that leave the ball at rest. Returns how many steps
    /// are then behind it. make: `advance` if the shortcut is known not to apply.
    uint64_t advance(uint64_t step, decltype(&makeStep) make = makeStep);
    /// What happens to a running ball at a stop.
    void stop(const phys_state &state);
    /// Why the ball failed: what phys_step says of that step.
    void explain(phys_error &reason) const;
    /// Stores the ball after the last step. A ball that was done earlier keeps its state.
    void finish();

private:
    phys_status check(bool paramsAreChecked) const;
    phys_status tryStep(decltype(&makeStep) make, phys_state &next);
    phys_status stepAndTally(phys_state &next);
    bool wasUnchanged() const;
    uint64_t stepsOfSameGravity(uint64_t step) const;
    uint64_t stepsWithinTime() const;

    phys_stepper *m_stepper = nullptr;
    const phys_batch *m_batch = nullptr;
    uint64_t m_number = 0; ///< in the batch
    phys_params m_params{};
    const phys_vec3 *m_gravity = nullptr; ///< gravity in this ball's first step; nullptr: that of the parameters
    phys_state *m_path = nullptr;         ///< this ball's row, or nullptr
    phys_state *m_result = nullptr;       ///< the caller's
    phys_state m_states[2]{};             ///< alternately the last good state and the next one
    int m_now = 0;                        ///< index of the last good state
    bool m_isRunning = false;
    bool m_tallyIsUnchanged = true; ///< by the last step
    phys_status m_status = PHYS_OK;
    uint64_t m_done = 0;
    uint64_t m_pathCount = 0;
};

} // namespace phys
