// SPDX-License-Identifier: MIT
// A stepper in its scene, and one step whose arguments were checked.
#pragma once

#include "registry/lanes.h"
#include "scene/scene.h"

#include <physics/plugin.h>

#include <cstddef>
#include <cstring>

namespace phys {

/// The last step that left a ball at rest as it was. What a built-in stepper answers follows from what it is given, so
/// the same step needn't be made again: the cheapest that there is.
class KnownRest {
public:
    /// Whether this is the known step, but for time and number.
    bool holds(const phys_params &params, double dt, const phys_state &state) const {
        return dt == m_dt && isSameBall(state, m_state) && std::memcmp(&params, &m_params, sizeof params) == 0;
    }
    void keep(const phys_params &params, double dt, const phys_state &state) {
        m_params = params;
        m_dt = dt;
        m_state = state;
    }

    /// The same bytes but for time and number: a zero has a sign.
    static bool isSameBall(const phys_state &a, const phys_state &b) {
        constexpr size_t kBegin = offsetof(phys_state, position);
        const auto bytesOf = [](const phys_state &state) { return reinterpret_cast<const char *>(&state) + kBegin; };
        return std::memcmp(bytesOf(a), bytesOf(b), sizeof a - kBegin) == 0;
    }

private:
    phys_params m_params{};
    double m_dt = 0.0; ///< s; 0: none is known
    phys_state m_state{};
};

} // namespace phys

struct phys_stepper {
    const phys_stepper_api *api;
    void *self;
    const phys::Scene *scene;
    phys_scene_view view;
    bool isPlugin;
    const phys::LaneSteps *lanes; ///< its ability to move balls in lanes, or nullptr
    phys::KnownRest rest;
};

namespace phys {

/// Time and step of a state after so many more steps of dt.
void advanceClock(double dt, uint64_t steps, phys_state &state);

/// As phys_step with checked arguments: `out` may be `in`, and is written on success only. report: a fresh one, or
/// nullptr.
phys_status makeStep(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                     phys_state &out, phys_report *report, phys_error *err);

/// One step of dt > 0 from `in` to `next`, which are not the same; `next` means something only after PHYS_OK. A plugin
/// is not trusted: neither what it returns nor what it writes goes on unchecked.
phys_status advance(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                    phys_state &next, phys_report *report, phys_error *err);

} // namespace phys
