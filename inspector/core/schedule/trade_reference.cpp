// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/trade_reference.h"

#include "base/elementary.h"
#include "core/events/bounce.h"
#include "core/setup/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>

namespace inspector {

namespace {

constexpr double kScheduleRounding = 1e-9; ///< share of a step: tolerance for a segment to be a whole number of steps
constexpr int kPushedRuns = 4;
constexpr double kTurnStep = 0.001; ///< s

/// The orientation of "exact" is only second-order accurate in the step where the path bends: its error reaches a tenth
/// of a degree after some seconds of 50 ms steps, and is 2500 times smaller with these. The motion doesn't depend on
/// it.
void takeOrientation(phys_state &state, const phys_state &turned) {
    std::copy(std::begin(turned.orientation), std::end(turned.orientation), state.orientation);
}

} // namespace

double distance(const phys_vec3 &a, const phys_vec3 &b) {
    return phys::elementary::hypot(phys::elementary::hypot(a.x - b.x, a.y - b.y), a.z - b.z);
}

void appendImpacts(const phys_report &report, std::vector<Impact> &impacts) {
    for (uint32_t i = 0; i < report.event_count; ++i) {
        const phys_event &event = report.events[i];
        if (event.kind == PHYS_EVENT_IMPACT) impacts.push_back({event.time, event.box, -event.speed_before});
    }
}

int countedImpacts(const std::vector<Impact> &impacts, double until) {
    return int(std::count_if(impacts.begin(), impacts.end(), [until](const Impact &impact) {
        return impact.speed >= kCountedImpact && impact.time <= until;
    }));
}

std::vector<TiltSegment> segmentsOf(const TiltSchedule &schedule, double gravity) {
    std::vector<TiltSegment> segments;
    for (size_t i = 0; i < schedule.switches.size(); ++i) {
        const TiltSwitch &now = schedule.switches[i];
        const double end = i + 1 < schedule.switches.size() ? schedule.switches[i + 1].time : schedule.duration;
        TiltSegment segment{now.time, end - now.time, now.tilt, {}};
        phys_gravity_from_tilt(now.tilt.x, now.tilt.y, gravity, &segment.gravity);
        if (segment.length > 0.0) segments.push_back(segment);
    }
    return segments;
}

std::vector<Leg> legsOf(const std::vector<TiltSegment> &segments, double dt) {
    const auto stride = uint32_t(std::max(1.0, std::floor(kComparePeriod / dt + kScheduleRounding)));
    std::vector<Leg> legs;
    for (size_t i = 0; i < segments.size(); ++i) {
        const TiltSegment &segment = segments[i];
        const auto whole = uint64_t(std::floor(segment.length / dt + kScheduleRounding));
        const double rest = segment.length - double(whole) * dt;
        const auto add = [&](double length, uint32_t steps, double offset) {
            legs.push_back({i, length, steps, offset, segment.begin + offset});
        };
        for (uint64_t done = 0; done < whole;) {
            const auto steps = uint32_t(std::min<uint64_t>(stride, whole - done));
            done += steps;
            add(dt, steps, double(done) * dt);
        }
        if (rest > kScheduleRounding * dt) add(rest, 1, segment.length);
    }
    return legs;
}

TradeReference::TradeReference(Stepper stepper, Scene scene, const phys_params &params)
    : m_stepper(std::move(stepper))
    , m_scene(std::move(scene))
    , m_params(params) {}

std::optional<TradeReference> TradeReference::run(const Registry &registry, const Scene &scene,
                                                  const phys_params &params, std::vector<TiltSegment> segments,
                                                  QString *error) {
    const Stepper stepper = makeStepper(registry, "exact", scene, error);
    if (!stepper) return std::nullopt;
    TradeReference result(stepper, scene, params);
    result.m_legs = legsOf(segments, kScheduleHold);
    result.m_segments = std::move(segments);
    phys_state state;
    phys_scene_start(scene.get(), &state);
    result.m_states = {state};

    std::array<phys_event, 1024> events;
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = events.data();
    report.event_capacity = uint32_t(events.size());
    for (const Leg &leg : result.m_legs) {
        phys_state turned = state;
        if (!result.step(leg.segment, leg.dt, state, &report, &result.m_endReason)) break;
        if (state.flags & PHYS_OUT) result.m_endReason = QStringLiteral("the ball leaves the maze");
        if (state.flags & PHYS_OUT) break;
        if (result.isTurning() && result.turn(leg.segment, leg.dt, turned)) takeOrientation(state, turned);
        appendImpacts(report, result.m_impacts);
        result.m_states.push_back(state);
    }
    result.m_legs.resize(result.m_states.size() - 1);
    if (!result.m_legs.empty()) return result;
    if (error) *error = result.m_endReason;
    return std::nullopt;
}

bool TradeReference::step(size_t segment, double dt, phys_state &state, phys_report *report, QString *error) const {
    phys_params params = m_params;
    params.gravity = m_segments[segment].gravity;
    phys_error failure;
    if (phys_step(m_stepper.get(), &params, dt, &state, &state, report, &failure) == PHYS_OK) return true;
    tell(error, failure);
    return false;
}

bool TradeReference::turn(size_t segment, double time, phys_state &state) const {
    const double count = std::max(1.0, std::ceil(time / kTurnStep - kScheduleRounding));
    for (int i = 0; i < int(count); ++i)
        if (!step(segment, time / count, state, nullptr, nullptr)) return false;
    return true;
}

std::vector<phys_state> TradeReference::statesAt(const std::vector<Leg> &legs) const {
    std::vector<phys_state> states;
    states.reserve(legs.size());
    const double rounding = kScheduleRounding * kScheduleHold;
    size_t piece = 0;
    phys_state turned = m_states.front(); // the same ball in small steps
    double turnedUntil = 0.0;             // s
    for (const Leg &leg : legs) {
        while (piece < m_legs.size() && m_legs[piece].end <= leg.end + rounding) {
            turnedUntil = m_legs[piece].end;
            turned = m_states[++piece];
        }
        const double rest = piece > 0 ? leg.end - m_legs[piece - 1].end : leg.end;
        if (piece == m_legs.size() && rest > rounding) break;
        phys_state state = m_states[piece];
        if (rest > rounding && !step(leg.segment, rest, state, nullptr, nullptr)) break;
        if (rest > rounding && isTurning() && turn(leg.segment, leg.end - turnedUntil, turned))
            takeOrientation(state, turned);
        turnedUntil = leg.end;
        states.push_back(state);
    }
    return states;
}

double TradeReference::horizon(const std::stop_token &stop) const {
    const double radius = phys_scene_radius(m_scene.get());
    return pushedHorizon(kPush * radius, kVisible * radius, stop);
}

double TradeReference::roundingHorizon(const std::stop_token &stop) const {
    phys_box bounds;
    phys_scene_bounds(m_scene.get(), &bounds);
    const double largest = std::max({std::abs(bounds.min.x), std::abs(bounds.min.y), std::abs(bounds.max.x),
                                     std::abs(bounds.max.y), phys_scene_radius(m_scene.get())});
    return pushedHorizon(largest * std::numeric_limits<double>::epsilon(), phys_scene_radius(m_scene.get()), stop);
}

double TradeReference::pushedHorizon(double length, double visible, const std::stop_token &stop) const {
    double result = end();
    for (uint64_t seed = 1; seed <= kPushedRuns; ++seed)
        result = std::min(result, pushedHorizon(length, visible, seed, stop));
    return result;
}

double TradeReference::pushedHorizon(double length, double visible, uint64_t seed, const std::stop_token &stop) const {
    constexpr double kTurn = 6.283185307179586;
    std::mt19937_64 numbers(seed);
    phys_state state = m_states.front();
    double reached = 0.0;
    for (size_t i = 0; i < m_legs.size() && !stop.stop_requested(); ++i) {
        push(state, length, kTurn * double(numbers() >> 11) * 0x1p-53);
        if (!step(m_legs[i].segment, m_legs[i].dt, state, nullptr, nullptr)) return reached;
        if (distance(state.position, m_states[i + 1].position) > visible) return reached;
        reached = m_legs[i].end;
    }
    return reached;
}

/// Pushes the ball sideways, unless a wall is so near that the push would move it into the wall.
void TradeReference::push(phys_state &state, double length, double angle) const {
    if (nearestWall(m_scene.get(), state.position, 2.0 * length)) return;
    state.position.x += length * phys::elementary::cos(angle);
    state.position.y += length * phys::elementary::sin(angle);
}

} // namespace inspector
