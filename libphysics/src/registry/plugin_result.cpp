// SPDX-License-Identifier: MIT
#include "registry/plugin_result.h"

#include "base/error.h"
#include "registry/arguments.h"
#include "registry/plugin_call.h"

namespace phys {

namespace {

phys_status checkPluginState(const phys_stepper_api &api, const phys_state &expected, const phys_state &result,
                             phys_error *err) {
    char whose[96];
    writeText(whose, sizeof whose, "the result of plugin stepper '%s'", api.id);
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

} // namespace

phys_status stepPlugin(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                       phys_state &next, phys_report *report, phys_error *err) {
    const phys_stepper_api &api = *stepper.api;
    const phys_state copy = in;
    const phys_state expected = next;
    const phys_report given = report ? *report : phys_report{};
    const phys_status status = callPlugin(api, "step", err, [&](phys_error &own) {
        return api.step(stepper.self, &params, dt, &copy, &next, report, &own);
    });
    if (status) return status;
    if (report) {
        if (const phys_status bad = checkPluginReport(api, given, *report, err)) return bad;
    }
    return checkPluginState(api, expected, next, err);
}

} // namespace phys
