// SPDX-License-Identifier: MIT
#include "registry/plugin_result.h"

#include "base/error.h"
#include "base/text.h"
#include "registry/arguments.h"
#include "registry/plugin_call.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace phys {

namespace {

bool isZero(const phys_vec3 &v) { return v.x == 0.0 && v.y == 0.0 && v.z == 0.0; }

phys_status checkPluginState(const phys_stepper_api &api, const phys_params &params, const phys_state &expected,
                             const phys_state &result, phys_error *err) {
    char whose[96];
    writeText(whose, sizeof whose, "the result of plugin stepper '%s'", api.id);
    if (!stateIsValid(result)) return explainState(result, PHYS_ERROR_PLUGIN_RESULT, whose, err);
    if (result.time != expected.time || result.step != expected.step) {
        return fail(err, PHYS_ERROR_PLUGIN_RESULT, "%s has time %.17g s and step %llu; expected %.17g s and %llu",
                    whose, result.time, static_cast<unsigned long long>(result.step), expected.time,
                    static_cast<unsigned long long>(expected.step));
    }
    if ((result.flags & PHYS_AT_REST) && !(isZero(result.velocity) && isZero(result.spin))) {
        return fail(err, PHYS_ERROR_PLUGIN_RESULT,
                    "%s has the flag PHYS_AT_REST and a velocity or spin; expected none of them", whose);
    }
    if (!(params.options & PHYS_OPTION_ORIENTATION) &&
        !std::equal(result.orientation, std::end(result.orientation), expected.orientation)) {
        return fail(err, PHYS_ERROR_PLUGIN_RESULT,
                    "%s has another orientation; expected the same without PHYS_OPTION_ORIENTATION", whose);
    }
    return PHYS_OK;
}

constexpr uint32_t kStages = (1U << PHYS_STAGE_COUNT) - 1;

/// What physics.h promises of one member of a report or an event.
struct Promise {
    const char *member;
    double value;
    bool isKept;
    const char *expected;
};

/// 2^300, which no ball has within the limits of speeds, spins and radii; the sum of a report's three stays finite.
constexpr double kLargestEnergy = 0x1p300;
constexpr const char *kEnergy = "a number within +-2^300";
constexpr const char *kLoss = "a number from 0 to 2^300";
constexpr const char *kModerate = "a number within +-2^100";

bool isEnergy(double value) { return std::abs(value) <= kLargestEnergy; } // false for NaN
bool isWithin(uint32_t count, uint32_t cap) { return cap == 0 || count <= cap; }
bool isUpTo(double value, double most) { return value >= 0.0 && value <= most; }

phys_status checkPromises(const phys_stepper_api &api, const char *where, std::span<const Promise> promises,
                          phys_error *err) {
    const auto broken = std::find_if(promises.begin(), promises.end(), [](const Promise &p) { return !p.isKept; });
    if (broken == promises.end()) return PHYS_OK;
    return fail(err, PHYS_ERROR_PLUGIN_RESULT, "plugin stepper '%s' reports %s%s %.12g; expected %s", api.id, where,
                broken->member, broken->value, broken->expected);
}

phys_status checkFigures(const phys_stepper_api &api, const phys_report &report, phys_error *err) {
    const Promise promises[] = {
        {"event_count", double(report.event_count), report.event_count <= report.event_capacity,
         "at most event_capacity"},
        {"substeps", double(report.substeps), isWithin(report.substeps, report.substep_cap), "at most substep_cap"},
        {"passes", double(report.passes), isWithin(report.passes, report.pass_cap), "at most pass_cap"},
        {"penetration", report.penetration, isUpTo(report.penetration, kLargestNumber), "a number from 0 to 2^100"},
        {"lost_impact", report.lost_impact, isUpTo(report.lost_impact, kLargestEnergy), kLoss},
        {"lost_rolling", report.lost_rolling, isUpTo(report.lost_rolling, kLargestEnergy), kLoss},
        {"lost_slip", report.lost_slip, isEnergy(report.lost_slip), kEnergy},
    };
    return checkPromises(api, "", promises, err);
}

struct Span {
    double begin, end; // s
};

/// within: the step's, or what the events so far leave of it.
phys_status checkEvent(const phys_stepper_api &api, uint32_t index, const phys_event &event, uint32_t boxCount,
                       Span within, phys_error *err) {
    const bool isImpact = event.kind == PHYS_EVENT_IMPACT || event.kind == PHYS_EVENT_LANDING;
    const bool isOfWall = event.kind == PHYS_EVENT_CONTACT || event.kind == PHYS_EVENT_RELEASE;
    const bool hasBox = event.box != PHYS_NO_BOX;
    const phys_vec3 &n = event.normal;
    const double square = n.x * n.x + n.y * n.y + n.z * n.z;
    const bool isNormal = hasBox ? std::abs(square - 1.0) <= 1e-6 : square == 0.0;
    const double before = isImpact ? -event.speed_before : event.speed_before;
    const Promise promises[] = {
        {"kind", double(event.kind), event.kind >= PHYS_EVENT_IMPACT && event.kind <= PHYS_EVENT_RELEASE, "1 .. 7"},
        {"box", double(event.box), hasBox ? event.box < boxCount && (isImpact || isOfWall) : !isImpact,
         isImpact   ? "one of the scene's"
         : isOfWall ? "one of the scene's or PHYS_NO_BOX"
                    : "PHYS_NO_BOX"},
        {"time", event.time, event.time >= within.begin && event.time <= within.end,
         "a moment of the step, after those of the events before"},
        {"point.x", event.point.x, isModerate(event.point.x), kModerate},
        {"point.y", event.point.y, isModerate(event.point.y), kModerate},
        {"point.z", event.point.z, isModerate(event.point.z), kModerate},
        {"|normal|^2", square, isNormal, hasBox ? "1" : "0 without a box"},
        {"speed_before", event.speed_before, isUpTo(before, kLargestNumber) && !(isImpact && before == 0.0),
         isImpact ? "a number below 0, from -2^100 on" : "a number from 0 to 2^100"},
        {"speed_after", event.speed_after, isUpTo(event.speed_after, kLargestNumber), "a number from 0 to 2^100"},
    };
    char where[32];
    writeText(where, sizeof where, "event %u with ", index);
    return checkPromises(api, where, promises, err);
}

/// step: its begin and end.
phys_status checkEvents(const phys_stepper &stepper, const phys_report &report, Span step, phys_error *err) {
    const double rounding = 4.0 * kRounding * std::max(std::abs(step.begin), std::abs(step.end));
    Span left{step.begin - rounding, step.end + rounding};
    for (uint32_t i = 0; i < report.event_count; ++i) {
        const phys_event &event = report.events[i];
        if (const phys_status status = checkEvent(*stepper.api, i, event, stepper.view.box_count, left, err))
            return status;
        left.begin = event.time;
    }
    return PHYS_OK;
}

phys_status checkPluginReport(const phys_stepper &stepper, const phys_report &given, const phys_report &result,
                              Span step, phys_error *err) {
    const bool sameBuffer = result.struct_size == given.struct_size && result.events == given.events &&
                            result.event_capacity == given.event_capacity;
    if (!sameBuffer) {
        return fail(err, PHYS_ERROR_PLUGIN_RESULT,
                    "plugin stepper '%s' changed the report's size or its event buffer; expected them untouched",
                    stepper.api->id);
    }
    if (const phys_status status = checkFigures(*stepper.api, result, err)) return status;
    return checkEvents(stepper, result, step, err);
}

} // namespace

phys_status stepPlugin(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                       phys_state &next, phys_report *report, phys_error *err) {
    const phys_stepper_api &api = *stepper.api;
    const phys_state copy = in;
    const phys_params obeyed = params;
    const phys_state expected = next;
    const phys_report given = report ? *report : phys_report{};
    const phys_status status = callPlugin(api, "step", err, [&](phys_error &own) {
        return api.step(stepper.self, &obeyed, dt, &copy, &next, report, &own);
    });
    if (status) return status;
    if (report) {
        if (const phys_status bad = checkPluginReport(stepper, given, *report, {in.time, expected.time}, err))
            return bad;
    }
    return checkPluginState(api, params, expected, next, err);
}

phys_status requirementsOfPlugin(const phys_stepper &stepper, const phys_params &params, double dt,
                                 const phys_state &state, phys_requirements &out, phys_error *err) {
    const phys_stepper_api &api = *stepper.api;
    const phys_state copy = state;
    const phys_params obeyed = params;
    const phys_status status = callPlugin(api, "requirements", err, [&](phys_error &own) {
        return api.requirements(stepper.self, &obeyed, dt, &copy, &out, &own);
    });
    if (status) return status;
    for (char(&reason)[120] : out.reasons) {
        reason[sizeof reason - 1] = '\0';
        writeText(reason, sizeof reason, "%s", std::string(reason).c_str()); // one line of UTF-8
    }
    const uint32_t unknown = out.stages & ~kStages;
    if (!unknown) return PHYS_OK;
    return fail(err, PHYS_ERROR_PLUGIN_RESULT,
                "requirements of plugin stepper '%s' have the unknown stages 0x%x; known bits are 0x%x", api.id,
                unknown, kStages);
}

} // namespace phys
