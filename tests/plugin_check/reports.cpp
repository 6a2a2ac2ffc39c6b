// SPDX-License-Identifier: MIT
// Whether a stepper's reports are true: events, losses, flags, orientation, requirements.
#include "trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace plugin_check {

namespace {

using witness::Case;

constexpr double kDt = 1e-3;
constexpr double kWall = 0.05; // m, its face

/// Collects the faults.
class Complaints {
public:
    void unless(bool isRight, const std::string &wrong) {
        if (!isRight && m_text.find(wrong) == std::string::npos) m_text += (m_text.empty() ? "" : "; ") + wrong;
    }
    Measure measure(const char *right) const { return {!m_text.empty(), m_text.empty() ? right : m_text}; }

private:
    std::string m_text;
};

/// A report with room for some events.
struct Report {
    Report() {
        phys_report_init(&all, sizeof all);
        all.events = events.data();
        all.event_capacity = static_cast<uint32_t>(events.size());
    }
    std::array<phys_event, 8> events{};
    phys_report all{};
};

Case towardsAWall() {
    Case scene = board(PHYS_MODEL_ROLLING);
    scene.boxes.push_back({{kWall, -1, 0}, {0.06, 1, 0.05}});
    scene.params.restitution_wall = 0.5;
    scene.params.rolling_friction = 0;
    roll(scene, 0.3, 0);
    return scene;
}

bool isNear(double value, double expected, double share) {
    return std::abs(value - expected) <= share * std::abs(expected);
}

void judgeImpact(const Report &report, const phys_state &before, const phys_state &after, Complaints &complaints) {
    const auto isImpact = [](const phys_event &event) { return event.kind == PHYS_EVENT_IMPACT; };
    uint32_t index = 0;
    while (index < report.all.event_count && !isImpact(report.events[index])) ++index;
    complaints.unless(index < report.all.event_count, "a bounce without an event");
    if (index == report.all.event_count) return;
    const phys_event &event = report.events[index];
    complaints.unless(event.box == 1, "an impact with another box than the ball's");
    complaints.unless(isNear(event.normal.x, -1, 1e-9) && event.normal.y == 0 && event.normal.z == 0,
                      "an impact's normal doesn't point from the box to the ball");
    complaints.unless(isNear(event.point.x, kWall, 1e-9), "an impact's point isn't on the box");
    complaints.unless(event.time >= before.time && event.time <= after.time, "an impact's time is outside of its step");
    complaints.unless(isNear(event.speed_before, -before.velocity.x, 1e-3), "an impact's speed before is wrong");
    complaints.unless(isNear(event.speed_after, -0.5 * event.speed_before, 1e-3), "an impact's speed after is wrong");
}

/// The energy lost in a step is attributed to its causes, up to the scheme's own error.
void judgeLosses(double scheme, double change, const char *where, Complaints &complaints) {
    complaints.unless(std::abs(scheme) <= 0.05 * std::abs(change),
                      std::string("energy lost ") + where + " isn't booked");
}

void judgeBounce(const Subject &subject, Complaints &complaints) {
    Run run(subject, towardsAWall());
    for (int i = 0; i < 400; ++i) {
        const phys_state before = run.state;
        Report report;
        if (!run.step(kDt, &report.all)) return complaints.unless(run.status() != PHYS_ERROR_PLUGIN_RESULT, run.why());
        complaints.unless(report.all.substeps > 0, "a step without substeps");
        complaints.unless(report.all.events_lost == 0, "events lost where there was room");
        if (run.state.velocity.x < 0) {
            judgeImpact(report, before, run.state, complaints);
            judgeLosses(report.all.energy_scheme, report.all.energy_after - report.all.energy_before, "in an impact",
                        complaints);
            return;
        }
        complaints.unless(report.all.event_count == 0, "an event where nothing happens");
    }
}

void judgeRolling(const Subject &subject, Complaints &complaints) {
    Case scene = board(PHYS_MODEL_ROLLING);
    scene.params.rolling_friction = 0.01;
    roll(scene, 0.3, 0.2);
    Run run(subject, scene);
    double scheme = 0, change = 0;
    for (int i = 0; i < 200; ++i) {
        Report report;
        if (!run.step(kDt, &report.all)) return;
        scheme += report.all.energy_scheme;
        change += report.all.energy_after - report.all.energy_before;
        complaints.unless(!(run.state.flags & PHYS_AIRBORNE), "airborne on the floor");
        complaints.unless(!(run.state.flags & PHYS_SLIPPING), "slipping in the rolling model");
    }
    judgeLosses(scheme, change, "by rolling", complaints);
}

void judgeFlags(const Subject &subject, Complaints &complaints) {
    Case scene = board(modelOf(subject));
    scene.start.position.z = 0.5;
    Run falling(subject, scene);
    if (falling.step(kDt)) complaints.unless(falling.state.flags & PHYS_AIRBORNE, "not airborne in the air");

    Run resting(subject, board(modelOf(subject)));
    for (int i = 0; i < 10; ++i) {
        Report report;
        if (!resting.step(kDt, &report.all)) break;
        const double lost = report.all.lost_impact + report.all.lost_rolling + report.all.lost_slip;
        complaints.unless(std::abs(lost) < 1e-12, "energy is lost at rest");
    }
    if (resting.status() == PHYS_OK) complaints.unless(resting.state.flags & PHYS_AT_REST, "at rest without its flag");

    Case slope = board(modelOf(subject));
    slope.legs[0].gravity = {2, 0, -9.6};
    Run without(subject, slope);
    slope.start.flags = PHYS_STATE_FLAGS;
    Run with(subject, slope);
    if (without.step(kDt) && with.step(kDt)) {
        complaints.unless(isSame(with.state, without.state), "the flags of the state before are read");
    }
}

/// A fifth of a turn by rolling.
void judgeOrientation(const Subject &subject, Complaints &complaints) {
    Case scene = board(PHYS_MODEL_ROLLING);
    scene.params.rolling_friction = 0;
    roll(scene, 0.3, 0.2);
    Run still(subject, scene);
    Run turning(subject, scene);
    turning.params.options |= PHYS_OPTION_ORIENTATION;
    constexpr int kSteps = 20;
    for (int i = 0; i < kSteps; ++i) {
        if (!still.step(kDt) || !turning.step(kDt)) return;
    }
    complaints.unless(std::ranges::equal(still.state.orientation, scene.start.orientation),
                      "the orientation turns without being asked for");
    const phys_vec3 &spin = scene.start.spin;
    const double rate = std::hypot(spin.x, spin.y);
    const double half = rate * kSteps * kDt / 2;
    const std::array<double, 4> expected = {spin.x / rate * std::sin(half), spin.y / rate * std::sin(half), 0,
                                            std::cos(half)};
    double apart = 0, opposite = 0; // q and -q are one orientation
    for (size_t i = 0; i < 4; ++i) {
        apart = std::max(apart, std::abs(turning.state.orientation[i] - expected[i]));
        opposite = std::max(opposite, std::abs(turning.state.orientation[i] + expected[i]));
    }
    complaints.unless(std::min(apart, opposite) < 0.05, "the orientation doesn't follow the spin");
}

/// The table and the requirements before a step.
void judgePromises(const Subject &subject, Complaints &complaints) {
    phys_stepper_info info{};
    phys_registry_find(subject.registry, subject.id.c_str(), &info, nullptr);
    Case scene = towardsAWall();
    scene.legs[0].gravity = {0.3, 0.1, -9.8};
    Run once(subject, scene);
    if (info.flags & PHYS_STEPPER_EXACT_IN_DT) {
        Run often(subject, scene);
        bool isDone = once.step(0.4);
        for (int i = 0; i < 400; ++i) isDone = often.step(kDt) && isDone;
        complaints.unless(!isDone || std::abs(once.state.position.x - often.state.position.x) < 1e-9,
                          "one step of 0.4 s isn't as good as 400 of 1 ms, which its flags promise");
    }
    Run run(subject, scene);
    phys_requirements needed{};
    if (!run.stepper()) return;
    const phys_status told = phys_stepper_requirements(run.stepper(), &run.params, kDt, &run.state, &needed, nullptr);
    complaints.unless(told != PHYS_ERROR_PLUGIN_RESULT, "requirements of unknown stages");
    if (told) return;
    Report report;
    if (run.step(kDt, &report.all))
        complaints.unless(needed.substeps == report.all.substeps,
                          "requirements tell other substeps than the step takes");
}

} // namespace

Measure reports(const Subject &subject) {
    Complaints complaints;
    judgeBounce(subject, complaints);
    judgeRolling(subject, complaints);
    judgeFlags(subject, complaints);
    judgeOrientation(subject, complaints);
    judgePromises(subject, complaints);
    return complaints.measure("events, losses, flags, orientation are what happens");
}

} // namespace plugin_check
