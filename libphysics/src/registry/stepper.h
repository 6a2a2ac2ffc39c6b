// SPDX-License-Identifier: MIT
// A stepper in its scene, and one step with checked arguments.
#pragma once

#include "registry/lanes.h"
#include "scene/scene.h"

#include <physics/plugin.h>

#include <cmath>
#include <cstddef>
#include <cstring>

namespace phys {

/// Compares bytes, apart from time and number, because zeros have a sign.
inline bool isSameBall(const phys_state &a, const phys_state &b) {
    constexpr size_t kBegin = offsetof(phys_state, position);
    const auto bytesOf = [](const phys_state &state) { return reinterpret_cast<const char *>(&state) + kBegin; };
    return std::memcmp(bytesOf(a), bytesOf(b), sizeof a - kBegin) == 0;
}

/// Parameters and length of the last step. Most steps have the same: these needn't be checked again.
struct KnownStep {
    phys_params params{};
    double dt = NAN;                  ///< s; NaN: no step yet
    const LaneSteps *lanes = nullptr; ///< those of the stepper, unless the step is too long for shortcuts
    phys_state rest{};                ///< of a ball that such a step left unchanged
    bool hasRest = false;

    bool is(const phys_params &others, double length) const {
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): no padding
        return length == dt && std::memcmp(&others, &params, sizeof params) == 0;
    }
    /// Whether such a step leaves the ball unchanged, apart from time and step number: a built-in stepper's result
    /// depends only on its inputs.
    bool leaves(const phys_state &ball) const { return hasRest && isSameBall(ball, rest); }
};

} // namespace phys

struct phys_stepper {
    const phys_stepper_api *api;
    void *self;
    const phys::Scene *scene;
    phys_scene_view view;
    bool isPlugin;
    const phys::LaneSteps *lanes; ///< its ability to move balls in lanes, or nullptr
    phys::KnownStep known;
};

namespace phys {

/// Time and step of a state after this many further steps of dt.
void advanceClock(double dt, uint64_t steps, phys_state &state);

/// Like phys_step, for checked arguments: `out` may be `in`, and is written on success only. report: a fresh one, or
/// nullptr.
phys_status makeStep(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in, phys_state &out,
                     phys_report *report, phys_error *err);

/// One step of dt > 0 from `in` to `next`, which must differ; `next` is valid only after PHYS_OK. A plugin isn't
/// trusted: its status and its outputs are checked.
phys_status advance(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in, phys_state &next,
                    phys_report *report, phys_error *err);

} // namespace phys
