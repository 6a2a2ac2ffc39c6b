// SPDX-License-Identifier: GPL-3.0-or-later
// What a ball really does under a schedule: stepper "exact", from switch to switch.
#pragma once

#include "core/schedule/trade_schedule.h"
#include "core/setup/handles.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace inspector {

struct Impact {
    double time; // s
    uint32_t box;
    double speed; // along the normal, before, m/s, > 0
};

// Constant tilt from `begin` for `length` seconds.
struct TiltSegment {
    double begin;
    double length;
    Tilt tilt;
    phys_vec3 gravity;
};

// So many steps of dt, after which a state is compared. A segment ends with a shorter step if it isn't a whole number
// of dt: all steppers see gravity switch at the same moments.
struct Leg {
    size_t segment;
    double dt;
    uint32_t steps;
    double offset; // of its end, s since the segment's begin
    double end;    // s since the start
};

// How far two compared states may be apart in time at least, s; smaller steps are compared every so many.
inline constexpr double kComparePeriod = 0.005;

// Impacts up to a time that are faster than kCountedImpact: of a ball that leans on a wall there are many slow ones.
int countedImpacts(const std::vector<Impact> &impacts, double until);

std::vector<TiltSegment> segmentsOf(const TiltSchedule &schedule, double gravity);
std::vector<Leg> legsOf(const std::vector<TiltSegment> &segments, double dt);

class TradeReference {
public:
    // params: their gravity is replaced by the segments'; orientations are right if they ask for them. Null and one
    // line in `error` if "exact" can't do the scene or the parameters from the very start.
    static std::optional<TradeReference> run(const Registry &registry, const Scene &scene, const phys_params &params,
                                             std::vector<TiltSegment> segments, QString *error);

    // s: as far as "exact" could do it and the ball was in the maze.
    double end() const { return m_legs.back().end; }
    const QString &endReason() const { return m_endReason; } // why not to the end; empty if to the end
    const std::vector<Impact> &impacts() const { return m_impacts; }
    // At the start, and every kScheduleHold or switch of the tilt from there.
    const std::vector<phys_state> &states() const { return m_states; }
    // From each of these states to the next.
    const std::vector<Leg> &legs() const { return m_legs; }

    // The states at the ends of these legs, as far as the reference goes.
    std::vector<phys_state> statesAt(const std::vector<Leg> &legs) const;

    const std::vector<TiltSegment> &segments() const { return m_segments; }

    // Up to here a comparison means something, s: until then a ball that is pushed by kPush radii every kScheduleHold,
    // in directions of its own, stays within kVisible radii of this one.
    static constexpr double kPush = 1e-6;
    static constexpr double kVisible = 0.1;
    double horizon(const std::stop_token &stop) const;
    // The same for a push of a rounding of the coordinates and a distance of a radius: beyond it no program knows where
    // the ball is, whatever the board.
    double roundingHorizon(const std::stop_token &stop) const;

private:
    TradeReference(Stepper stepper, Scene scene, const phys_params &params);
    bool step(size_t segment, double dt, phys_state &state, phys_report *report, QString *error) const;
    bool turn(size_t segment, double time, phys_state &state) const; // a step in small ones, for its orientation
    // Lengths in m.
    double pushedHorizon(double length, double visible, const std::stop_token &stop) const;
    double pushedHorizon(double length, double visible, uint64_t seed, const std::stop_token &stop) const;
    void push(phys_state &state, double length, double angle) const;
    bool isTurning() const { return m_params.options & PHYS_OPTION_ORIENTATION; }

    Stepper m_stepper;
    Scene m_scene;
    phys_params m_params;
    std::vector<TiltSegment> m_segments;
    std::vector<Leg> m_legs;
    std::vector<phys_state> m_states;
    std::vector<Impact> m_impacts;
    QString m_endReason;
};

double distance(const phys_vec3 &a, const phys_vec3 &b);

// Appends a report's impacts on walls.
void appendImpacts(const phys_report &report, std::vector<Impact> &impacts);

} // namespace inspector
