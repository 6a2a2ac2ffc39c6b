// SPDX-License-Identifier: MIT
// The boundary of a step: everything that goes in is checked, and nothing comes out unless all went well.
#include "error.h"
#include "params.h"
#include "registry.h"
#include "scene.h"

#include <cmath>
#include <cstring>
#include <new>

struct phys_stepper {
    const phys_stepper_api *api;
    void *self;
    const phys::Scene *scene;
    phys_scene_view view;
    bool isPlugin;
};

namespace phys {

namespace {

uint32_t queryBoxes(const void *scene, const phys_box *region, uint32_t *out, uint32_t capacity) {
    const auto &given = static_cast<const Scene *>(scene)->given;
    uint32_t count = 0;
    for (uint32_t i = 0; i < given.size(); ++i) {
        const phys_box &box = given[i];
        const bool apart = box.max.x < region->min.x || box.min.x > region->max.x || box.max.y < region->min.y ||
                           box.min.y > region->max.y || box.max.z < region->min.z || box.min.z > region->max.z;
        if (apart) continue;
        if (count < capacity) out[count] = i;
        ++count;
    }
    return count;
}

uint32_t queryContacts(const void *scene, const phys_vec3 *centre, double reach, phys_contact *out, uint32_t capacity) {
    uint32_t count = 0;
    phys_scene_contacts(static_cast<const phys_scene *>(static_cast<const Scene *>(scene)), centre, reach, out,
                        capacity, &count);
    return count;
}

phys_scene_view viewOf(const Scene &scene) {
    return {sizeof(phys_scene_view),
            static_cast<uint32_t>(scene.given.size()),
            scene.given.empty() ? nullptr : scene.given.data(),
            scene.radius,
            scene.floorTop,
            &scene,
            queryBoxes,
            queryContacts};
}

/// All numbers of a state in a row: position, velocity, spin, orientation.
constexpr size_t kStateNumbers = 13;

bool allFinite(const phys_state &state) {
    double numbers[kStateNumbers];
    std::memcpy(numbers, &state.position, sizeof numbers);
    // x - x is 0 for a finite x and NaN otherwise.
    double sum = state.time - state.time;
    for (const double number : numbers) sum += number - number;
    return sum == 0.0;
}

bool isUnit(const double (&q)[4]) {
    const double square = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
    return std::abs(square - 1.0) <= 1e-6;
}

bool stateIsValid(const phys_state &state) {
    return allFinite(state) && isUnit(state.orientation) &&
           (state.flags & ~static_cast<uint64_t>(PHYS_STATE_FLAGS)) == 0;
}

phys_status explainState(const phys_state &state, phys_status status, const char *whose, phys_error *err) {
    if (!allFinite(state)) {
        return fail(err, status,
                    "%s has a number that isn't finite: position (%.9g, %.9g, %.9g), velocity (%.9g, %.9g, %.9g), "
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

/// A floor carries a ball only while gravity presses it on.
bool pressedOn(const Scene &scene, const phys_params &params, const phys_state &state) {
    if (params.gravity.z < 0.0 || !scene.hasFloor) return true;
    const bool onFloor = std::abs(state.position.z - scene.supportedZ) <= scene.tolerance && state.velocity.z <= 0.0 &&
                         scene.overFloor(state.position.x, state.position.y);
    return !onFloor;
}

phys_status checkArguments(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &state,
                           phys_error *err) {
    if (!(dt >= 0.0 && std::isfinite(dt))) {
        return fail(err, PHYS_ERROR_ARGUMENT, "dt is %.9g s; expected a number >= 0", dt);
    }
    if (!paramsAreValid(params)) return explainParams(params, err);
    if (stepper.api->row_count > 0) {
        const phys_status status = checkOwnRows(params, {stepper.api->rows, stepper.api->row_count}, err);
        if (status) return status;
    }
    if (!stateIsValid(state)) return explainState(state, PHYS_ERROR_STATE, "the given state", err);
    if (!pressedOn(*stepper.scene, params, state)) {
        return fail(err, PHYS_ERROR_RANGE,
                    "gravity_z is %.9g m/s^2; while the floor carries the ball it must be below 0", params.gravity.z);
    }
    return PHYS_OK;
}

/// Steps are counted rather than summed as long as the time is what the count says: model.md 10.6.
double nextTime(const phys_state &state, double dt) {
    const double counted = static_cast<double>(state.step) * dt;
    const bool isCounted = std::abs(counted - state.time) <= 4.0 * kRounding * state.time;
    return isCounted ? static_cast<double>(state.step + 1) * dt : state.time + dt;
}

double energyOf(const Scene &scene, const phys_params &params, const phys_state &state) {
    const Vec3 velocity = toVec(state.velocity);
    const Vec3 spin = toVec(state.spin);
    return 0.5 * glm::dot(velocity, velocity) + 0.2 * scene.radius * scene.radius * glm::dot(spin, spin) -
           glm::dot(toVec(params.gravity), toVec(state.position));
}

/// A report ready for a step: the caller's buffer, everything else zero.
phys_report freshReport(const phys_report &given) {
    phys_report report{};
    report.struct_size = sizeof report;
    report.event_capacity = given.events ? given.event_capacity : 0;
    report.events = given.events;
    return report;
}

void balance(const Scene &scene, const phys_params &params, const phys_state &before, const phys_state &after,
             phys_report &report) {
    report.energy_before = energyOf(scene, params, before);
    report.energy_after = energyOf(scene, params, after);
    report.energy_scheme =
        report.energy_after + report.lost_impact + report.lost_rolling + report.lost_slip - report.energy_before;
}

phys_status checkPluginResult(const phys_stepper_api &api, const phys_state &expected, const phys_state &result,
                              phys_error *err) {
    char whose[96];
    std::snprintf(whose, sizeof whose, "the result of plugin stepper '%.60s'", api.id);
    if (!stateIsValid(result)) return explainState(result, PHYS_ERROR_PLUGIN_RESULT, whose, err);
    if (result.time == expected.time && result.step == expected.step) return PHYS_OK;
    return fail(err, PHYS_ERROR_PLUGIN_RESULT, "%s has time %.17g s and step %llu; expected %.17g s and %llu", whose,
                result.time, static_cast<unsigned long long>(result.step), expected.time,
                static_cast<unsigned long long>(expected.step));
}

} // namespace

} // namespace phys

phys_status phys_stepper_create(const phys_registry *registry, const char *id, const phys_scene *scene,
                                phys_stepper **out, phys_error *err) {
    if (!id || !scene || !out) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", !id ? "id" : !scene ? "scene" : "out");
    }
    const phys_stepper_api *api = phys::findStepper(registry, id);
    if (!api) {
        phys_stepper_info unused;
        return phys_registry_find(registry, id, &unused, err); // says which ids there are
    }
    auto *stepper = new (std::nothrow) phys_stepper{api, nullptr, scene, phys::viewOf(*scene), false};
    if (!stepper) return phys::fail(err, PHYS_ERROR_MEMORY, "out of memory for stepper '%s'", id);
    const phys_status status = api->create(&stepper->view, &stepper->self, err);
    if (status) {
        delete stepper;
        return status;
    }
    *out = stepper;
    return PHYS_OK;
}

void phys_stepper_destroy(phys_stepper *stepper) {
    if (!stepper) return;
    stepper->api->destroy(stepper->self);
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
    if (report && report->struct_size != sizeof *report) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT,
                          "report.struct_size is %u; expected %zu: call phys_report_init first", report->struct_size,
                          sizeof *report);
    }
    if (const phys_status status = phys::checkArguments(*stepper, *params, dt, *in, err)) return status;

    phys_state next = *in;
    phys_report fresh{};
    if (report) fresh = phys::freshReport(*report);
    if (dt > 0.0) {
        next.time = phys::nextTime(*in, dt);
        next.step = in->step + 1;
        const phys_state expected = next;
        const phys_status status =
            stepper->api->step(stepper->self, params, dt, in, &next, report ? &fresh : nullptr, err);
        if (status) return status;
        if (stepper->isPlugin) {
            if (const phys_status bad = phys::checkPluginResult(*stepper->api, expected, next, err)) return bad;
        }
    }
    if (report) {
        phys::balance(*stepper->scene, *params, *in, next, fresh);
        *report = fresh;
    }
    *out = next;
    return PHYS_OK;
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
    if (const phys_status status = phys::checkArguments(*stepper, *params, dt, *state, err)) return status;
    if (!PHYS_HAS_SLOT(phys_stepper_api, stepper->api, requirements)) {
        return phys::fail(err, PHYS_ERROR_UNSUPPORTED, "stepper '%s' doesn't tell what it requires", stepper->api->id);
    }
    phys_requirements requirements{};
    const phys_status status = stepper->api->requirements(stepper->self, params, dt, state, &requirements, err);
    if (!status) *out = requirements;
    return status;
}

phys_status phys_energy(const phys_scene *scene, const phys_params *params, const phys_state *state, double *out) {
    if (!scene || !params || !state || !out) return PHYS_ERROR_ARGUMENT;
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
