// SPDX-License-Identifier: MIT
// Steppers with one run-time fault each; the id says which.
#include <physics/plugin.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace {

/// All that a step is given.
struct Step {
    double dt;
    const phys_state *in;
    phys_state *out;
    phys_report *report;
    phys_error *err;
};
using StepFunction = phys_status(const Step &);

phys_status createNothing(const phys_scene_view *, void **, phys_error *) { return PHYS_OK; }
void destroyNothing(void *) {}

template<StepFunction *function>
phys_status step(void *, const phys_params *, double dt, const phys_state *in, phys_state *out, phys_report *report,
                 phys_error *err) {
    return function({dt, in, out, report, err});
}

template<StepFunction *function>
constexpr phys_stepper_api doing(const char *id) {
    return {sizeof(phys_stepper_api), 0,       id,     id, "1", "", nullptr, 0, 0, createNothing, destroyNothing,
            step<function>,           nullptr, nullptr};
}

phys_status behaveWell(const Step &step) {
    step.out->position.x += 1.0;
    return PHYS_OK;
}

// Invalid states.
phys_status writeNan(const Step &step) {
    step.out->position.x = NAN;
    return PHYS_OK;
}
phys_status writeInfinity(const Step &step) {
    step.out->velocity.z = INFINITY;
    return PHYS_OK;
}
phys_status copyInput(const Step &step) {
    *step.out = *step.in; // time and step as before
    return PHYS_OK;
}
phys_status countTwice(const Step &step) {
    ++step.out->step;
    return PHYS_OK;
}
phys_status writeUnknownFlags(const Step &step) {
    step.out->flags = 0x30;
    return PHYS_OK;
}
phys_status stretchOrientation(const Step &step) {
    step.out->orientation[0] = 2.0;
    return PHYS_OK;
}
phys_status writeInput(const Step &step) {
    std::memset(const_cast<phys_state *>(step.in), 0xff, sizeof *step.in);
    return PHYS_OK;
}

// Invalid reports.
phys_status claimEvents(const Step &step) {
    if (step.report) step.report->event_count = step.report->event_capacity + 1;
    return PHYS_OK;
}
phys_status swapBuffer(const Step &step) {
    static phys_event own[1];
    if (step.report) step.report->events = own;
    return PHYS_OK;
}
phys_status reportNan(const Step &step) {
    if (step.report) step.report->lost_impact = NAN;
    return PHYS_OK;
}

// Failures.
phys_status throwReason(const Step &) { throw std::runtime_error("no reason to go on"); }
phys_status throwNumber(const Step &) { throw 7; }
phys_status returnPositive(const Step &) { return 42; }
phys_status returnUnknown(const Step &) { return -4711; }
phys_status failSilently(const Step &) { return PHYS_ERROR_UNSUPPORTED; }
phys_status failWithReason(const Step &step) {
    std::strcpy(step.err->text, "this scene has no air");
    return PHYS_ERROR_UNSUPPORTED;
}
phys_status failEndlessly(const Step &step) {
    std::memset(step.err->text, 'x', sizeof step.err->text); // no end of text
    return PHYS_ERROR_UNSUPPORTED;
}

// Faults at creation and destruction.
phys_status throwAtCreation(const phys_scene_view *, void **, phys_error *) { throw std::bad_alloc(); }
phys_status returnGarbageAtCreation(const phys_scene_view *, void **, phys_error *) { return 1; }
phys_status refuseOneBox(const phys_scene_view *view, void **, phys_error *err) {
    if (view->box_count > 1) return PHYS_OK;
    std::strcpy(err->text, "a floor without walls is too simple");
    return PHYS_ERROR_UNSUPPORTED;
}
void throwAtDestruction(void *) { throw 7; }
phys_status throwRequirements(void *, const phys_params *, double, const phys_state *, phys_requirements *,
                              phys_error *) {
    throw std::runtime_error("I require nothing");
}
phys_status endlessRequirements(void *, const phys_params *, double, const phys_state *, phys_requirements *out,
                                phys_error *) {
    std::memset(out->reasons, 'x', sizeof out->reasons);
    return PHYS_OK;
}

constexpr phys_stepper_api creating(const char *id, decltype(phys_stepper_api::create) create) {
    phys_stepper_api api = doing<behaveWell>(id);
    api.create = create;
    return api;
}
constexpr phys_stepper_api destroying(const char *id, decltype(phys_stepper_api::destroy) destroy) {
    phys_stepper_api api = doing<behaveWell>(id);
    api.destroy = destroy;
    return api;
}
constexpr phys_stepper_api requiring(const char *id, decltype(phys_stepper_api::requirements) requirements) {
    phys_stepper_api api = doing<behaveWell>(id);
    api.requirements = requirements;
    return api;
}

constexpr phys_stepper_api kTables[] = {
    doing<behaveWell>("behaves"),
    doing<writeNan>("nan"),
    doing<writeInfinity>("infinity"),
    doing<copyInput>("time-not-advanced"),
    doing<countTwice>("step-counted-twice"),
    doing<writeUnknownFlags>("unknown-flags"),
    doing<stretchOrientation>("orientation-not-unit"),
    doing<writeInput>("writes-input"),
    doing<claimEvents>("too-many-events"),
    doing<swapBuffer>("own-buffer"),
    doing<reportNan>("nan-in-report"),
    doing<throwReason>("throws"),
    doing<throwNumber>("throws-number"),
    doing<returnPositive>("positive-status"),
    doing<returnUnknown>("unknown-status"),
    doing<failSilently>("fails-silently"),
    doing<failWithReason>("fails-with-reason"),
    doing<failEndlessly>("fails-endlessly"),
    creating("throws-at-creation", throwAtCreation),
    creating("garbage-at-creation", returnGarbageAtCreation),
    creating("wants-walls", refuseOneBox),
    destroying("throws-at-destruction", throwAtDestruction),
    requiring("throws-requirements", throwRequirements),
    requiring("endless-requirements", endlessRequirements),
};
constexpr size_t kCount = sizeof kTables / sizeof kTables[0];

struct Pointers {
    const phys_stepper_api *list[kCount];
};
constexpr Pointers pointers() {
    Pointers pointers{};
    for (size_t i = 0; i < kCount; ++i) pointers.list[i] = &kTables[i];
    return pointers;
}
constexpr Pointers kPointers = pointers();

} // namespace

constinit const phys_plugin phys_plugin_entry = {PHYS_ABI_VERSION, sizeof(phys_plugin), kCount, 0, kPointers.list};
