// SPDX-License-Identifier: MIT
// Steppers with one run-time fault each; the id says which.
#include <physics/plugin.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace {

/// The arguments of a step.
struct Step {
    const phys_params *params;
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
phys_status step(void *, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                 phys_report *report, phys_error *err) {
    return function({params, dt, in, out, report, err});
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
phys_status restMoving(const Step &step) {
    step.out->flags = PHYS_AT_REST;
    step.out->velocity.x = 1.0;
    return PHYS_OK;
}
phys_status restSpinning(const Step &step) {
    step.out->flags = PHYS_AT_REST;
    step.out->spin.z = 1.0;
    return PHYS_OK;
}
phys_status turnUnasked(const Step &step) {
    step.out->orientation[2] = 1.0;
    step.out->orientation[3] = 0.0;
    return PHYS_OK;
}
phys_status writeInput(const Step &step) {
    std::memset(const_cast<phys_state *>(step.in), 0xff, sizeof *step.in);
    return PHYS_OK;
}

/// Writes the byte behind it.
template<class T>
phys_status writeBeyond(T *record) {
    if (record) *reinterpret_cast<char *>(record + 1) = 1;
    return PHYS_OK;
}
phys_status writeBeyondOut(const Step &step) { return writeBeyond(step.out); }
phys_status writeBeyondReport(const Step &step) { return writeBeyond(step.report); }
phys_status writeBeyondError(const Step &step) { return writeBeyond(step.err); }
phys_status writeOneEventTooFar(const Step &step) {
    if (step.report && step.report->event_capacity) step.report->events[step.report->event_capacity] = {};
    return PHYS_OK;
}

/// As numerical code does that computes bounds.
phys_status roundUpwards(const Step &) {
    std::fesetround(FE_UPWARD);
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

// Clang 14 takes no floating-point numbers as template arguments, but references to them.
constexpr double kNan = NAN, kInfinity = INFINITY, kMinusInfinity = -INFINITY, kMinusTwo = -2.0, kMinusOne = -1.0,
                 kEighth = 0.125, kThree = 3.0, kFive = 5.0;
constexpr phys_vec3 kNowhere{0, NAN, 0}, kLong{0, 0.6, 0.9};
constexpr uint32_t kNoKind = 0, kKind99 = 99, kBox12345 = 12345, kFloor = 0, kNoBox = PHYS_NO_BOX;

/// Changes one member of a report. All zero is a good one.
template<auto member, const auto &value>
phys_status report(const Step &step) {
    if (step.report) step.report->*member = value;
    return PHYS_OK;
}
/// All of a step's energy at once: each part is finite, their sum isn't.
phys_status loseEverything(const Step &step) {
    if (step.report) step.report->lost_impact = step.report->lost_rolling = step.report->lost_slip = 1e308;
    return PHYS_OK;
}
phys_status claimEnergies(const Step &step) {
    if (step.report) step.report->energy_before = step.report->energy_after = step.report->energy_scheme = 42.0;
    return PHYS_OK;
}
phys_status pass(const Step &step, uint32_t cap) {
    if (!step.report) return PHYS_OK;
    step.report->passes = step.report->substeps = 9;
    step.report->pass_cap = step.report->substep_cap = cap;
    return PHYS_OK;
}
phys_status passTheCap(const Step &step) { return pass(step, 8); }
phys_status passWithoutACap(const Step &step) { return pass(step, 0); }

/// Two good events: an impact in the middle of the step, a stop at its end.
bool writeGoodEvents(const Step &step) {
    if (!step.report || step.report->event_capacity < 2) return false;
    const double end = step.out->time, middle = end - step.dt / 2;
    step.report->events[0] = {middle, {1, 2, 0}, {0, 0.6, 0.8}, -3, 0, PHYS_EVENT_IMPACT, 0};
    step.report->events[1] = {end, step.out->position, {0, 0, 0}, 2, 0, PHYS_EVENT_STOP, PHYS_NO_BOX};
    step.report->event_count = 2;
    return true;
}
phys_status reportGoodEvents(const Step &step) {
    writeGoodEvents(step);
    return PHYS_OK;
}
/// Changes one member of one of them.
template<int index, auto member, const auto &value>
phys_status event(const Step &step) {
    if (writeGoodEvents(step)) step.report->events[index].*member = value;
    return PHYS_OK;
}
phys_status writeParams(const Step &step) {
    const_cast<phys_params *>(step.params)->restitution_wall = 0.125;
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

phys_status oddRequirements(void *, const phys_params *, double, const phys_state *, phys_requirements *out,
                            phys_error *) {
    std::memcpy(out->reasons[0], "one\ntwo\xff", 9);
    return PHYS_OK;
}

phys_status unknownRequirements(void *, const phys_params *, double, const phys_state *, phys_requirements *out,
                                phys_error *) {
    out->stages = 0x41;
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
    doing<restMoving>("rests-moving"),
    doing<restSpinning>("rests-spinning"),
    doing<turnUnasked>("turns-unasked"),
    doing<writeInput>("writes-input"),
    doing<writeBeyondOut>("writes-beyond-out"),
    doing<writeBeyondReport>("writes-beyond-report"),
    doing<writeBeyondError>("writes-beyond-error"),
    doing<writeOneEventTooFar>("one-event-too-far"),
    doing<roundUpwards>("rounds-upwards"),
    doing<claimEvents>("too-many-events"),
    doing<swapBuffer>("own-buffer"),
    doing<report<&phys_report::lost_impact, kNan>>("nan-in-report"),
    doing<report<&phys_report::penetration, kMinusOne>>("penetration-negative"),
    doing<report<&phys_report::lost_impact, kMinusOne>>("impact-gains"),
    doing<report<&phys_report::lost_rolling, kMinusOne>>("rolling-gains"),
    doing<report<&phys_report::lost_slip, kMinusInfinity>>("slip-infinite"),
    doing<loseEverything>("loses-everything"),
    doing<claimEnergies>("claims-energies"),
    doing<passTheCap>("passes-the-cap"),
    doing<passWithoutACap>("passes-without-a-cap"),
    doing<reportGoodEvents>("good-events"),
    doing<event<1, &phys_event::kind, kNoKind>>("event-of-kind-0"),
    doing<event<0, &phys_event::kind, kKind99>>("event-of-kind-99"),
    doing<event<0, &phys_event::box, kBox12345>>("event-of-no-such-box"),
    doing<event<0, &phys_event::box, kNoBox>>("impact-without-a-box"),
    doing<event<1, &phys_event::box, kFloor>>("stop-with-a-box"),
    doing<event<0, &phys_event::time, kFive>>("event-too-late"),
    doing<event<0, &phys_event::time, kMinusOne>>("event-too-early"),
    doing<event<1, &phys_event::time, kEighth>>("events-out-of-order"),
    doing<event<1, &phys_event::time, kNan>>("event-at-no-time"),
    doing<event<0, &phys_event::point, kNowhere>>("event-nowhere"),
    doing<event<0, &phys_event::normal, kLong>>("event-with-a-long-normal"),
    doing<event<1, &phys_event::normal, kLong>>("event-with-a-normal-of-no-box"),
    doing<event<0, &phys_event::speed_before, kThree>>("impact-from-behind"),
    doing<event<0, &phys_event::speed_after, kMinusOne>>("impact-inwards"),
    doing<event<1, &phys_event::speed_before, kMinusTwo>>("speed-negative"),
    doing<event<1, &phys_event::speed_after, kInfinity>>("speed-infinite"),
    doing<writeParams>("writes-params"),
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
    requiring("odd-requirements", oddRequirements),
    requiring("unknown-requirements", unknownRequirements),
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
