// SPDX-License-Identifier: MIT
// Steppers that move the ball correctly but report or do something wrong besides. The id says what.
#include "support/planted_fault.h"

#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace {

using namespace support;

/// A correct step whose events are changed.
template<class Change>
phys_status withEvents(Step &step, Change change) {
    const phys_status status = soundStep(step);
    for (uint32_t i = 0; !status && step.report && i < step.report->event_count; ++i) change(step.report->events[i]);
    return status;
}
phys_status turnNormals(Step &step) {
    return withEvents(step, [](phys_event &event) {
        event.normal = {-event.normal.x, -event.normal.y, event.normal.z};
    });
}
phys_status nameTheFirstBox(Step &step) {
    return withEvents(step, [](phys_event &event) { event.box = 0; });
}
phys_status pointAtTheCentre(Step &step) {
    return withEvents(step, [&](phys_event &event) { event.point = step.out.position; });
}
phys_status slowEvents(Step &step) {
    return withEvents(step, [](phys_event &event) { event.speed_before *= 0.9; });
}
phys_status inventKinds(Step &step) {
    return withEvents(step, [](phys_event &event) { event.kind = 99; });
}

/// A correct step whose report is changed.
template<class Change>
phys_status withReport(Step &step, Change change) {
    const phys_status status = soundStep(step);
    if (!status && step.report) change(*step.report);
    return status;
}
phys_status hideEvents(Step &step) {
    return withReport(step, [](phys_report &report) { report.event_count = 0; });
}
phys_status loseEvents(Step &step) {
    return withReport(step, [](phys_report &report) { report.events_lost = 5; });
}
phys_status hideSubsteps(Step &step) {
    return withReport(step, [](phys_report &report) { report.substeps = 0; });
}
phys_status hideResistance(Step &step) {
    return withReport(step, [](phys_report &report) { report.lost_rolling = 0; });
}
phys_status hideImpacts(Step &step) {
    return withReport(step, [](phys_report &report) { report.lost_impact = 0; });
}

phys_status loseAtRest(Step &step) {
    return withReport(step, [](phys_report &report) { report.lost_rolling += 1e-7; });
}

/// A correct step whose state is changed in a way that doesn't affect the motion.
template<class Change>
phys_status withState(Step &step, Change change) {
    const phys_status status = soundStep(step);
    if (!status) change(step.out);
    return status;
}
phys_status flyUnseen(Step &step) {
    return withState(step, [](phys_state &out) { out.flags &= ~uint64_t{PHYS_AIRBORNE}; });
}
phys_status restUnseen(Step &step) {
    return withState(step, [](phys_state &out) { out.flags &= ~uint64_t{PHYS_AT_REST}; });
}
phys_status claimSlip(Step &step) {
    return withState(step, [](phys_state &out) { out.flags |= PHYS_SLIPPING; });
}
phys_status turnBackwards(Step &step) {
    return withState(step, [](phys_state &out) { out.orientation[0] = -out.orientation[0]; });
}
phys_status neverTurn(Step &step) {
    step.params.options &= ~uint32_t{PHYS_OPTION_ORIENTATION};
    return soundStep(step);
}
phys_status staySleeping(Step &step) { return step.in.flags & PHYS_AT_REST ? PHYS_OK : soundStep(step); }

/// The motion depends on what was before.
phys_status speedUp(Step &step) {
    return withState(step, [&](phys_state &out) { out.velocity.x *= ++step.self.calls > 3 ? 1.0001 : 1; });
}
phys_status drawVelocity(Step &step) {
    return withState(step, [](phys_state &out) { out.velocity.x += 1e-12 * (std::rand() % 100); }); // NOLINT
}
phys_status oversleep(Step &step) {
    usleep(20'000);
    return soundStep(step);
}
phys_status failAlways(Step &) { return 3; }

bool isTooFast(const Step &step) { return dot(step.in.velocity, step.in.velocity) > 1e10; }

/// It doesn't report what it can't do: the ball stands still.
phys_status swallow(Step &step) { return isTooFast(step) ? PHYS_OK : soundStep(step); }
phys_status failSilently(Step &step) { return isTooFast(step) ? PHYS_ERROR_SUBSTEP_CAP : soundStep(step); }
phys_status failInside(Step &step) {
    if (!isTooFast(step)) return soundStep(step);
    std::snprintf(step.err->text, sizeof step.err->text, "too fast");
    return PHYS_ERROR_INTERNAL;
}

/// Off by an error of second order in the step.
phys_status drift(Step &step) {
    return withState(step, [&](phys_state &out) { out.position.x += 1e-6 * step.dt * step.dt; });
}
phys_status roundUp(Step &step) {
    std::fesetround(FE_UPWARD);
    return soundStep(step);
}
phys_status print(Step &step) {
    std::printf("step %llu\n", static_cast<unsigned long long>(step.in.step));
    return soundStep(step);
}
phys_status trapExceptions(Step &step) {
    const phys_status status = soundStep(step);
    feenableexcept(FE_DIVBYZERO);
    return status;
}

/// What each does to the process, once, before a correct step.
template<auto change>
phys_status changeProcess(Step &step) {
    change();
    return soundStep(step);
}
void closeOutput() { close(STDOUT_FILENO); }
void closeAll() {
    for (int i = 0; i < 64; ++i) close(i);
}
void redirectErrors() { dup2(open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO); }
void openFiles() { (void)open("/dev/null", O_RDONLY | O_CLOEXEC); }
void goToRoot() { (void)!chdir("/"); }
void setLocale() {
    static const char *const kOther = std::strcmp(std::setlocale(LC_ALL, nullptr), "C") == 0 ? "C.UTF-8" : "C";
    std::setlocale(LC_ALL, kOther);
}
void takeInterrupt() { std::signal(SIGINT, SIG_IGN); }
void blockHangUp() {
    sigset_t hangUp;
    sigemptyset(&hangUp);
    sigaddset(&hangUp, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &hangUp, nullptr);
}
void setVariable() { setenv("PHYS_UNTRUE", "1", 1); }
void maskFiles() { umask(0); }
void endAlarm() { alarm(0); }

phys_status keepMemory(Step &step) {
    static std::vector<void *> kept; // all of them are kept, so that no compiler optimises the allocations away
    kept.push_back(std::malloc(64));
    return soundStep(step);
}
phys_status needStack(Step &step) {
    volatile char large[200000];                                // NOLINT
    for (size_t i = sizeof large; i > 0; --i) large[i - 1] = 1; // downwards, so that the guard page isn't skipped
    return large[0] ? soundStep(step) : PHYS_OK;
}

phys_status soundRequirements(void *self, const phys_params *params, double dt, const phys_state *state,
                              phys_requirements *out, phys_error *err) {
    return phys_stepper_requirements(static_cast<Self *>(self)->sound, params, dt, state, out, err);
}
phys_status requireMore(void *self, const phys_params *params, double dt, const phys_state *state,
                        phys_requirements *out, phys_error *err) {
    const phys_status status = soundRequirements(self, params, dt, state, out, err);
    out->substeps += 7;
    return status;
}
phys_status requireTheUnknown(void *self, const phys_params *params, double dt, const phys_state *state,
                              phys_requirements *out, phys_error *err) {
    const phys_status status = soundRequirements(self, params, dt, state, out, err);
    out->stages |= 1U << 20;
    return status;
}

template<auto requirements>
constexpr phys_stepper_api requiring(const char *id) {
    phys_stepper_api api = doing<soundStep>(id);
    api.requirements = requirements;
    return api;
}
constexpr phys_stepper_api claimingExactness(const char *id) {
    phys_stepper_api api = doing<drift>(id);
    api.flags = PHYS_STEPPER_EXACT_IN_DT;
    return api;
}

constexpr phys_stepper_api kTables[] = {
    requiring<soundRequirements>("sound"),
    doing<turnNormals>("normals-turned"),
    doing<nameTheFirstBox>("first-box-named"),
    doing<pointAtTheCentre>("points-at-the-centre"),
    doing<slowEvents>("slow-events"),
    doing<inventKinds>("kinds-invented"),
    doing<hideEvents>("events-hidden"),
    doing<loseEvents>("events-lost"),
    doing<hideSubsteps>("substeps-hidden"),
    doing<hideResistance>("resistance-not-booked"),
    doing<hideImpacts>("impacts-not-booked"),
    doing<flyUnseen>("flies-unseen"),
    doing<restUnseen>("rests-unseen"),
    doing<loseAtRest>("loses-at-rest"),
    doing<speedUp>("speeds-up"),
    doing<drawVelocity>("random"),
    doing<failAlways>("fails-always"),
    doing<oversleep>("slow"),
    doing<claimSlip>("claims-slip"),
    doing<turnBackwards>("turns-backwards"),
    doing<neverTurn>("never-turns"),
    doing<staySleeping>("stays-sleeping"),
    claimingExactness("claims-exactness"),
    requiring<requireMore>("requires-more"),
    requiring<requireTheUnknown>("requires-the-unknown"),
    doing<swallow>("swallows-errors"),
    doing<failSilently>("fails-silently-when-fast"),
    doing<failInside>("fails-inside"),
    doing<roundUp>("rounds-up"),
    doing<print>("prints"),
    doing<trapExceptions>("traps-exceptions"),
    doing<changeProcess<closeOutput>>("closes-output"),
    doing<changeProcess<closeAll>>("closes-all"),
    doing<changeProcess<redirectErrors>>("redirects-errors"),
    doing<changeProcess<openFiles>>("opens-files"),
    doing<changeProcess<goToRoot>>("goes-to-root"),
    doing<changeProcess<setLocale>>("sets-locale"),
    doing<changeProcess<takeInterrupt>>("takes-interrupt"),
    doing<changeProcess<blockHangUp>>("blocks-hang-up"),
    doing<changeProcess<setVariable>>("sets-variable"),
    doing<changeProcess<maskFiles>>("masks-files"),
    doing<changeProcess<endAlarm>>("ends-alarm"),
    doing<keepMemory>("keeps-memory"),
    doing<needStack>("needs-stack"),
};
constexpr PlantedTables kAll(kTables);

} // namespace

constinit const phys_plugin phys_plugin_entry = {PHYS_ABI_VERSION, sizeof(phys_plugin), std::size(kTables), 0,
                                                 kAll.list};
