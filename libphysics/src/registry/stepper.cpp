// SPDX-License-Identifier: MIT
// The C boundary of a step: all inputs are checked, and outputs are written only on success.
#include "registry/stepper.h"

#include "base/appendable.h"
#include "base/error.h"
#include "base/float_environment.h"
#include "base/text.h"
#include "registry/arguments.h"
#include "registry/clock.h"
#include "registry/energy.h"
#include "registry/plugin_call.h"
#include "registry/plugin_result.h"
#include "registry/registry.h"
#include "registry/report.h"
#include "scene/scene_view.h"

#include <cmath>
#include <cstring>
#include <memory>
#include <new>

namespace phys {

namespace {

void know(phys_stepper &stepper, const phys_params &params, double dt) {
    if (stepper.lanes) stepper.lanes->prepare(stepper.self, params, dt);
    // Shortcuts don't check the time after the step.
    stepper.known.lanes = dt <= kLongestHarmlessStep ? stepper.lanes : nullptr;
    stepper.known.params = params;
    stepper.known.dt = dt;
    stepper.known.hasRest = false;
}

phys_status checkStep(const phys_stepper_api &api, const phys_params &params, double dt, phys_error *err) {
    if (const phys_status status = checkDt(dt, err)) return status;
    return checkParams(api, params, err);
}

inline phys_status checkBall(const phys_stepper &stepper, const phys_params &params, const phys_state &state,
                             phys_error *err) {
    if (const phys_status status = checkState(state, err)) return status;
    return checkPull(*stepper.scene, params, state, err);
}

/// Checks all arguments of a step, and makes ready for it.
inline phys_status begin(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &state,
                         phys_error *err) {
    if (!stepper.known.is(params, dt)) {
        if (const phys_status status = checkStep(*stepper.api, params, dt, err)) return status;
        know(stepper, params, dt);
    }
    return checkBall(stepper, params, state, err);
}

/// A step for which the stepper has no shortcut.
phys_status stepInFull(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                       phys_state &out, phys_report *report, phys_error *err) {
    phys_state next;
    if (const phys_status status = advance(stepper, params, dt, in, next, report, err)) return status;
    out = next;
    return PHYS_OK;
}

/// A step of known parameters and length.
inline phys_status step(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                        phys_state &out, phys_report *report, phys_error *err) {
    if (dt == 0.0) {
        out = in;
        return PHYS_OK;
    }
    if (!stepper.known.lanes || !stepper.known.lanes->one(stepper.self, params, dt, in, out, report)) {
        return stepInFull(stepper, params, dt, in, out, report, err);
    }
    out.time = nextTime(in, dt); // from `in` even if that is `out`: the shortcut leaves the clock unchanged
    out.step = in.step + 1;
    return PHYS_OK;
}

phys_status stepAndReport(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                          phys_state &out, phys_report &report, phys_error *err) {
    if (!isKnownSize<phys_report>(report.struct_size)) {
        return fail(err, PHYS_ERROR_ARGUMENT, "report.struct_size is %u; expected %zu: call phys_report_init first",
                    report.struct_size, sizeof report);
    }
    phys_report fresh{};
    fresh.struct_size = sizeof fresh;
    fresh.event_capacity = report.events ? report.event_capacity : 0;
    fresh.events = report.events;
    const double before = energyOf(*stepper.scene, params, in); // `out` may be `in`
    if (const phys_status status = step(stepper, params, dt, in, out, &fresh, err)) return status;
    fresh.energy_before = before; // a plugin may have written there
    fresh.energy_after = energyOf(*stepper.scene, params, out);
    fresh.energy_scheme =
        fresh.energy_after + fresh.lost_impact + fresh.lost_rolling + fresh.lost_slip - fresh.energy_before;
    handOver(fresh, report);
    return PHYS_OK;
}

/// A step of a ball at rest, by a built-in stepper and without a report.
phys_status stepAtRest(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                       phys_state &out, phys_error *err) {
    if (dt > 0.0 && isModerate(in.time) && stepper.known.leaves(in) && stepper.known.is(params, dt)) {
        const double time = nextTime(in, dt);
        const uint64_t number = in.step + 1;
        if (&out != &in) out = in;
        out.time = time;
        out.step = number;
        return PHYS_OK;
    }
    if (const phys_status status = begin(stepper, params, dt, in, err)) return status;
    const phys_state before = in;
    if (const phys_status status = step(stepper, params, dt, in, out, nullptr, err)) return status;
    stepper.known.hasRest = dt <= kLongestHarmlessStep && isSameBall(before, out); // likewise
    if (stepper.known.hasRest) stepper.known.rest = out;
    return PHYS_OK;
}

phys_status createPlugin(phys_stepper &stepper, phys_error *err) {
    return callPlugin(*stepper.api, "create", err,
                      [&](phys_error &own) { return stepper.api->create(&stepper.view, &stepper.self, &own); });
}

} // namespace

phys_status makeStep(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in, phys_state &out,
                     phys_report *report, phys_error *err) {
    if (!stepper.known.is(params, dt)) know(stepper, params, dt);
    return step(stepper, params, dt, in, out, report, err);
}

void advanceClock(double dt, uint64_t steps, phys_state &state) {
    constexpr uint64_t kEnd = uint64_t{1} << 63; // step numbers from here on count as negative
    if (dt == 0.0) return;
    for (; steps > 0; --steps) {
        // Counted times stay counted, so the remaining steps are made at once; the time is that after the last one.
        if (isCounted(state, dt) && state.step < kEnd && steps <= kEnd - state.step) {
            state.step += steps - 1;
            state.time = (stepsOf(state) + 1.0) * dt;
            ++state.step;
            return;
        }
        state.time = nextTime(state, dt);
        ++state.step;
    }
}

phys_status advance(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in, phys_state &next,
                    phys_report *report, phys_error *err) {
    if (stepper.isPlugin) next = in; // the built-in steppers fill in the rest themselves
    next.time = nextTime(in, dt);
    next.step = in.step + 1;
    if (stepper.isPlugin) return stepPlugin(stepper, params, dt, in, next, report, err);
    if (const phys_status status = stepper.api->step(stepper.self, &params, dt, &in, &next, report, err)) return status;
    return stateIsValid(next) ? PHYS_OK : explainState(next, PHYS_ERROR_STATE, "the state after this step", err);
}

} // namespace phys

phys_status phys_stepper_create(const phys_registry *registry, const char *id, const phys_scene *scene,
                                phys_stepper **out, phys_error *err) try {
    const phys::FloatEnvironment environment;
    if (!id || !scene || !out) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", !id ? "id" : !scene ? "scene" : "out");
    }
    const auto [api, isPlugin] = phys::findStepper(registry, id);
    if (!api) {
        phys_stepper_info unused;
        return phys_registry_find(registry, id, &unused, err); // reports which ids exist
    }
    const phys_stepper fresh{api, nullptr, scene, phys::viewOf(*scene), isPlugin, nullptr, {}};
    auto stepper = std::make_unique<phys_stepper>(fresh);
    const phys_status status =
        isPlugin ? phys::createPlugin(*stepper, err) : api->create(&stepper->view, &stepper->self, err);
    if (!isPlugin && api->extension && !status) {
        stepper->lanes = static_cast<const phys::LaneSteps *>(api->extension(stepper->self, phys::kLanesId));
    }
    if (!status) *out = stepper.release();
    return status;
} catch (const std::bad_alloc &) {
    return phys::fail(err, PHYS_ERROR_MEMORY, "out of memory for a stepper");
}

void phys_stepper_destroy(phys_stepper *stepper) {
    if (!stepper) return;
    phys::callPlugin(*stepper->api, "destroy", nullptr, [stepper](phys_error &) {
        stepper->api->destroy(stepper->self);
        return PHYS_OK;
    });
    delete stepper;
}

phys_status phys_step(phys_stepper *stepper, const phys_params *params, double dt, const phys_state *in,
                      phys_state *out, phys_report *report, phys_error *err) {
    const phys::FloatEnvironment environment;
    if (!stepper || !params || !in || !out) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL",
                          !stepper  ? "stepper"
                          : !params ? "params"
                          : !in     ? "in"
                                    : "out");
    }
    if (phys::isOlder(*params)) {
        const phys_params whole = phys::completed(*params, phys_params_init);
        return phys_step(stepper, &whole, dt, in, out, report, err);
    }
    if ((in->flags & PHYS_AT_REST) && !report && !stepper->isPlugin)
        return phys::stepAtRest(*stepper, *params, dt, *in, *out, err);
    if (const phys_status status = phys::begin(*stepper, *params, dt, *in, err)) return status;
    return report ? phys::stepAndReport(*stepper, *params, dt, *in, *out, *report, err)
                  : phys::step(*stepper, *params, dt, *in, *out, nullptr, err);
}

phys_status phys_stepper_requirements(const phys_stepper *stepper, const phys_params *params, double dt,
                                      const phys_state *state, phys_requirements *out, phys_error *err) {
    const phys::FloatEnvironment environment;
    if (!stepper || !params || !state || !out) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL",
                          !stepper  ? "stepper"
                          : !params ? "params"
                          : !state  ? "state"
                                    : "out");
    }
    if (phys::isOlder(*params)) {
        const phys_params whole = phys::completed(*params, phys_params_init);
        return phys_stepper_requirements(stepper, &whole, dt, state, out, err);
    }
    if (const phys_status status = phys::checkStep(*stepper->api, *params, dt, err)) return status;
    if (const phys_status status = phys::checkBall(*stepper, *params, *state, err)) return status;
    if (!PHYS_HAS_SLOT(phys_stepper_api, stepper->api, requirements)) {
        return phys::fail(err, PHYS_ERROR_UNSUPPORTED, "stepper '%s' doesn't tell what it requires", stepper->api->id);
    }
    phys_requirements requirements{};
    if (dt == 0.0) {
        for (char(&reason)[120] : requirements.reasons) phys::writeText(reason, sizeof reason, "not needed: dt is 0");
        *out = requirements;
        return PHYS_OK;
    }
    const phys_status status = stepper->isPlugin
                                   ? phys::requirementsOfPlugin(*stepper, *params, dt, *state, requirements, err)
                                   : stepper->api->requirements(stepper->self, params, dt, state, &requirements, err);
    if (!status) *out = requirements;
    return status;
}

uint64_t phys_state_hash(const phys_state *state) {
    if (!state) return 0;
    uint64_t words[sizeof *state / sizeof(uint64_t)];
    std::memcpy(words, state, sizeof words);
    uint64_t hash = 0xcbf29ce484222325U; // FNV-1a
    for (uint64_t word : words) {
        for (int byte = 0; byte < 8; ++byte, word >>= 8) hash = (hash ^ (word & 0xff)) * 0x100000001b3U;
    }
    return hash;
}
