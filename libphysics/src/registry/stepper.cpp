// SPDX-License-Identifier: MIT
// The boundary of a step: everything that goes in is checked, and nothing comes out unless all went well.
#include "base/appendable.h"
#include "base/error.h"
#include "base/pairs.h"
#include "registry/params.h"
#include "registry/plugin_call.h"
#include "registry/registry.h"
#include "scene/scene_view.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>

struct phys_stepper {
    const phys_stepper_api *api;
    void *self;
    const phys::Scene *scene;
    phys_scene_view view;
    bool isPlugin;
    /// The last that passed the checks: the same bytes pass again. struct_size 0: none yet.
    alignas(16) mutable phys_params accepted;
};

namespace phys {

namespace {

/// Each of them: told where the glance below is not enough, or to say what is wrong.
bool numbersAreModerate(const phys_state &state) {
    const double(&q)[4] = state.orientation;
    return isModerate(state.position) && isModerate(state.velocity) && isModerate(state.spin) &&
           isModerate({q[0], q[1], q[2]}) && isModerate({q[3], state.time, 0.0});
}

inline bool isUnit(const double (&q)[4]) {
    return std::abs(sumOfSquares<4>(q) - 1.0) <= 1e-6; // false for NaN
}

/// With a unit quaternion behind them, the squares of the others say in half the time that they are all moderate.
inline bool numbersAreModerateAtAGlance(const phys_state &state) {
    const double squares = sumOfSquares(&state.position.x, &state.velocity.x, &state.spin.x, state.time);
    return squares <= kLargestNumber * kLargestNumber;
}

inline bool stateIsValid(const phys_state &state) {
    return isUnit(state.orientation) && (numbersAreModerateAtAGlance(state) || numbersAreModerate(state)) &&
           (state.flags & ~static_cast<uint64_t>(PHYS_STATE_FLAGS)) == 0;
}

phys_status explainState(const phys_state &state, phys_status status, const char *whose, phys_error *err) {
    if (!numbersAreModerate(state)) {
        return fail(err, status,
                    "%s has a number that isn't finite or beyond 2^100: position (%.9g, %.9g, %.9g), velocity (%.9g, "
                    "%.9g, %.9g), "
                    "spin (%.9g, %.9g, %.9g)",
                    whose, state.position.x, state.position.y, state.position.z, state.velocity.x, state.velocity.y,
                    state.velocity.z, state.spin.x, state.spin.y, state.spin.z);
    }
    if (!isUnit(state.orientation)) {
        const double(&q)[4] = state.orientation;
        return fail(err, status, "%s has the orientation (%.9g, %.9g, %.9g, %.9g); expected a unit quaternion", whose,
                    q[0], q[1], q[2], q[3]);
    }
    return fail(err, status, "%s has the flags 0x%llx; known bits are 0x%x", whose,
                static_cast<unsigned long long>(state.flags), PHYS_STATE_FLAGS);
}

/// Only such a ball may be pulled upwards: a floor carries it only while gravity presses it on.
bool isOffTheFloor(const Scene &scene, const phys_state &state) {
    const bool onFloor = scene.hasFloor && std::abs(state.position.z - scene.supportedZ) <= scene.tolerance &&
                         state.velocity.z <= 0.0 && scene.overFloor(state.position.x, state.position.y);
    return !onFloor;
}

[[gnu::cold]] phys_status explainArguments(const phys_stepper &stepper, const phys_params &params, double dt,
                                           const phys_state &state, phys_error *err) {
    if (!(dt >= 0.0 && dt <= kLargestNumber)) {
        return fail(err, PHYS_ERROR_ARGUMENT, "dt is %.9g s; expected a number from 0 to 2^100", dt);
    }
    if (!paramsAreValid(params)) return explainParams(params, err);
    const std::span rows(stepper.api->rows, stepper.api->row_count);
    if (!ownRowsAreValid(params, rows)) return checkOwnRows(params, rows, err);
    if (!stateIsValid(state)) return explainState(state, PHYS_ERROR_STATE, "the given state", err);
    if (params.gravity.z >= 0.0 && !isOffTheFloor(*stepper.scene, state)) {
        return fail(err, PHYS_ERROR_RANGE,
                    "gravity_z is %.9g m/s^2; while the floor carries the ball it must be below 0", params.gravity.z);
    }
    return PHYS_OK;
}

inline bool checkAndRemember(const phys_stepper &stepper, const phys_params &params) {
    if (!paramsAreValid(params) || !ownRowsAreValid(params, {stepper.api->rows, stepper.api->row_count})) return false;
    stepper.accepted = params;
    return true;
}

/// The yes or no of checkArguments: what every step pays.
inline bool argumentsAreValid(const phys_stepper &stepper, const phys_params &params, double dt,
                              const phys_state &state) {
    const bool isKnown = params.struct_size == sizeof params && haveSameBytes(params, stepper.accepted);
    return (isKnown || checkAndRemember(stepper, params)) && dt >= 0.0 && dt <= kLargestNumber && stateIsValid(state) &&
           (params.gravity.z < 0.0 || isOffTheFloor(*stepper.scene, state));
}

inline phys_status checkArguments(const phys_stepper &stepper, const phys_params &params, double dt,
                                  const phys_state &state, phys_error *err) {
    if (argumentsAreValid(stepper, params, dt, state)) [[likely]]
        return PHYS_OK;
    return explainArguments(stepper, params, dt, state, err);
}

/// Steps are counted rather than summed as long as the time is what the count says: model.md 10.6.
double nextTime(const phys_state &state, double dt) {
    const double counted = static_cast<double>(static_cast<int64_t>(state.step)) * dt;
    const bool isCounted = std::abs(counted - state.time) <= 4.0 * kRounding * state.time;
    return isCounted ? (static_cast<double>(static_cast<int64_t>(state.step)) + 1.0) * dt : state.time + dt;
}

double energyOf(const Scene &scene, const phys_params &params, const phys_state &state) {
    const Vec3 velocity = toVec(state.velocity);
    const Vec3 spin = toVec(state.spin);
    return 0.5 * glm::dot(velocity, velocity) + 0.2 * scene.radius * scene.radius * glm::dot(spin, spin) -
           glm::dot(toVec(params.gravity), toVec(state.position));
}

phys_status checkPluginState(const phys_stepper_api &api, const phys_state &expected, const phys_state &result,
                             phys_error *err) {
    char whose[96];
    std::snprintf(whose, sizeof whose, "the result of plugin stepper '%s'", api.id);
    if (!stateIsValid(result)) return explainState(result, PHYS_ERROR_PLUGIN_RESULT, whose, err);
    if (result.time == expected.time && result.step == expected.step) return PHYS_OK;
    return fail(err, PHYS_ERROR_PLUGIN_RESULT, "%s has time %.17g s and step %llu; expected %.17g s and %llu", whose,
                result.time, static_cast<unsigned long long>(result.step), expected.time,
                static_cast<unsigned long long>(expected.step));
}

phys_status checkPluginReport(const phys_stepper_api &api, const phys_report &given, const phys_report &result,
                              phys_error *err) {
    const bool sameBuffer = result.struct_size == given.struct_size && result.events == given.events &&
                            result.event_capacity == given.event_capacity;
    if (!sameBuffer) {
        return fail(err, PHYS_ERROR_PLUGIN_RESULT,
                    "plugin stepper '%s' changed the report's size or its event buffer; expected them untouched",
                    api.id);
    }
    if (result.event_count > given.event_capacity) {
        return fail(err, PHYS_ERROR_PLUGIN_RESULT, "plugin stepper '%s' reports %u events; there is room for %u",
                    api.id, result.event_count, given.event_capacity);
    }
    const double sum = ((result.penetration - result.penetration) + (result.lost_impact - result.lost_impact)) +
                       ((result.lost_rolling - result.lost_rolling) + (result.lost_slip - result.lost_slip));
    if (sum == 0.0) return PHYS_OK; // x - x is 0 for a finite x
    return fail(err, PHYS_ERROR_PLUGIN_RESULT,
                "plugin stepper '%s' reports penetration %g, lost_impact %g, lost_rolling %g, lost_slip %g; expected "
                "finite numbers",
                api.id, result.penetration, result.lost_impact, result.lost_rolling, result.lost_slip);
}

/// A plugin's step works on copies, and nobody sees its result before it was checked.
[[gnu::noinline]] phys_status advancePlugin(const phys_stepper &stepper, const phys_params &params, double dt,
                                            const phys_state &in, phys_state &out, phys_report *report,
                                            phys_error *err) {
    const phys_stepper_api &api = *stepper.api;
    const phys_state copy = in;
    phys_state next = in;
    next.time = nextTime(in, dt);
    next.step = in.step + 1;
    const phys_state expected = next;
    const phys_report given = report ? *report : phys_report{};
    const phys_status status = callPlugin(api, "step", err, [&](phys_error &own) {
        return api.step(stepper.self, &params, dt, &copy, &next, report, &own);
    });
    if (status) return status;
    if (report) {
        if (const phys_status bad = checkPluginReport(api, given, *report, err)) return bad;
    }
    if (const phys_status bad = checkPluginState(api, expected, next, err)) return bad;
    out = next;
    return PHYS_OK;
}

phys_status createPlugin(phys_stepper &stepper, phys_error *err) {
    return callPlugin(*stepper.api, "create", err,
                      [&](phys_error &own) { return stepper.api->create(&stepper.view, &stepper.self, &own); });
}

phys_status requirementsOfPlugin(const phys_stepper &stepper, const phys_params &params, double dt,
                                 const phys_state &state, phys_requirements &out, phys_error *err) {
    const phys_status status = callPlugin(*stepper.api, "requirements", err, [&](phys_error &own) {
        return stepper.api->requirements(stepper.self, &params, dt, &state, &out, &own);
    });
    for (char(&reason)[120] : out.reasons) reason[sizeof reason - 1] = '\0';
    return status;
}

/// A built-in stepper writes `out` only on success, and in and out may be the same.
inline phys_status advance(phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                           phys_state &out, phys_report *report, phys_error *err) {
    if (dt == 0.0) [[unlikely]] {
        out = in;
        return PHYS_OK;
    }
    if (stepper.isPlugin) [[unlikely]]
        return advancePlugin(stepper, params, dt, in, out, report, err);
    const double time = nextTime(in, dt);
    const uint64_t step = in.step + 1;
    const phys_status status = stepper.api->step(stepper.self, &params, dt, &in, &out, report, err);
    if (status) return status;
    out.time = time;
    out.step = step;
    return PHYS_OK;
}

[[gnu::noinline]] phys_status stepAndReport(phys_stepper &stepper, const phys_params &params, double dt,
                                            const phys_state &in, phys_state &out, phys_report &report,
                                            phys_error *err) {
    const size_t size = report.struct_size;
    if (!isKnownSize<phys_report>(size)) {
        return fail(err, PHYS_ERROR_ARGUMENT, "report.struct_size is %u; expected %zu: call phys_report_init first",
                    report.struct_size, sizeof report);
    }
    phys_report fresh{};
    fresh.struct_size = sizeof fresh;
    fresh.event_capacity = report.events ? report.event_capacity : 0;
    fresh.events = report.events;
    fresh.energy_before = energyOf(*stepper.scene, params, in);
    if (const phys_status status = advance(stepper, params, dt, in, out, &fresh, err)) return status;
    fresh.energy_after = energyOf(*stepper.scene, params, out);
    fresh.energy_scheme =
        fresh.energy_after + fresh.lost_impact + fresh.lost_rolling + fresh.lost_slip - fresh.energy_before;
    store(fresh, size, &report);
    return PHYS_OK;
}

} // namespace

} // namespace phys

phys_status phys_stepper_create(const phys_registry *registry, const char *id, const phys_scene *scene,
                                phys_stepper **out, phys_error *err) try {
    if (!id || !scene || !out) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", !id ? "id" : !scene ? "scene" : "out");
    }
    const auto [api, isPlugin] = phys::findStepper(registry, id);
    if (!api) {
        phys_stepper_info unused;
        return phys_registry_find(registry, id, &unused, err); // says which ids there are
    }
    const phys_stepper fresh{api, nullptr, scene, phys::viewOf(*scene), isPlugin, phys_params{}};
    auto stepper = std::make_unique<phys_stepper>(fresh);
    const phys_status status =
        isPlugin ? phys::createPlugin(*stepper, err) : api->create(&stepper->view, &stepper->self, err);
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
    if (const phys_status status = phys::checkArguments(*stepper, *params, dt, *in, err)) return status;
    if (report) return phys::stepAndReport(*stepper, *params, dt, *in, *out, *report, err);
    return phys::advance(*stepper, *params, dt, *in, *out, nullptr, err);
}

phys_status phys_stepper_requirements(const phys_stepper *stepper, const phys_params *params, double dt,
                                      const phys_state *state, phys_requirements *out, phys_error *err) {
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
    if (const phys_status status = phys::checkArguments(*stepper, *params, dt, *state, err)) return status;
    if (!PHYS_HAS_SLOT(phys_stepper_api, stepper->api, requirements)) {
        return phys::fail(err, PHYS_ERROR_UNSUPPORTED, "stepper '%s' doesn't tell what it requires", stepper->api->id);
    }
    phys_requirements requirements{};
    const phys_status status = stepper->isPlugin
                                   ? phys::requirementsOfPlugin(*stepper, *params, dt, *state, requirements, err)
                                   : stepper->api->requirements(stepper->self, params, dt, state, &requirements, err);
    if (!status) *out = requirements;
    return status;
}

phys_status phys_energy(const phys_scene *scene, const phys_params *params, const phys_state *state, double *out) {
    if (!scene || !params || !state || !out) return PHYS_ERROR_ARGUMENT;
    if (!phys::numbersAreModerate(*state) || !phys::isModerate(params->gravity)) return PHYS_ERROR_ARGUMENT;
    *out = phys::energyOf(*scene, *params, *state);
    return PHYS_OK;
}

uint64_t phys_state_hash(const phys_state *state) {
    if (!state) return 0;
    unsigned char bytes[sizeof *state];
    std::memcpy(bytes, state, sizeof bytes);
    uint64_t hash = 0xcbf29ce484222325U; // FNV-1a
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3U;
    return hash;
}
