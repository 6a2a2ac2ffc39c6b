// SPDX-License-Identifier: GPL-3.0-or-later
// The reference solution under a schedule: stepper "exact", stepped from switch to switch.
#pragma once

#include "core/schedule/trade_schedule.h"
#include "core/setup/handles.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace inspector {

struct Impact {
    double time; ///< s
    uint32_t box;
    double speed; ///< along the normal, before, m/s, > 0
};

/// Constant tilt from `begin` for `length` seconds.
struct TiltSegment {
    double begin;
    double length;
    Tilt tilt;
    phys_vec3 gravity;
};

/// `steps` steps of dt, after which states are compared. A segment ends with a shorter step if its length isn't a
/// multiple of dt, so that gravity switches at the same times for all steppers.
struct Leg {
    size_t segment;
    double dt;
    uint32_t steps;
    double offset; ///< end of the leg, s since the segment's begin
    double end;    ///< s since the start
};

/// Minimum time between compared states, s; with smaller steps only every n-th state is compared.
inline constexpr double kComparePeriod = 0.005;

/// The number of impacts up to a time that are faster than kCountedImpact; slower ones come in large numbers from a
/// ball that leans on a wall.
int countedImpacts(const std::vector<Impact> &impacts, double until);

std::vector<TiltSegment> segmentsOf(const TiltSchedule &schedule, double gravity);
std::vector<Leg> legsOf(const std::vector<TiltSegment> &segments, double dt);

class TradeReference {
public:
    /// params: their gravity is replaced by the segments'; orientations are accurate if the options ask for them. Null,
    /// with one line in `error`, if "exact" refuses the scene, or the parameters at the very start.
    static std::optional<TradeReference> run(const Registry &registry, const Scene &scene, const phys_params &params,
                                             std::vector<TiltSegment> segments, QString *error);

    /// s: how far "exact" got while the ball was in the maze
    double end() const { return m_legs.back().end; }
    const QString &endReason() const { return m_endReason; } ///< why it ends early; empty if it doesn't
    const std::vector<Impact> &impacts() const { return m_impacts; }
    /// States at the start and after every leg: kScheduleHold apart, or at a switch of the tilt.
    const std::vector<phys_state> &states() const { return m_states; }
    /// The legs between these states.
    const std::vector<Leg> &legs() const { return m_legs; }

    /// The reference states at the ends of these legs, up to the end of the reference.
    std::vector<phys_state> statesAt(const std::vector<Leg> &legs) const;

    const std::vector<TiltSegment> &segments() const { return m_segments; }

    /// The predictability horizon, s: until then a ball that is pushed by kPush radii every kScheduleHold, in random
    /// directions, stays within kVisible radii of this one. Comparisons beyond it are meaningless.
    static constexpr double kPush = 1e-6;
    static constexpr double kVisible = 0.1;
    double horizon(const std::stop_token &stop) const;
    /// The same for pushes of one rounding of the coordinates and a distance of one radius: beyond this horizon no
    /// program can know where the ball is, however well the board is known.
    double roundingHorizon(const std::stop_token &stop) const;

private:
    TradeReference(Stepper stepper, Scene scene, const phys_params &params);
    bool step(size_t segment, double dt, phys_state &state, phys_report *report, QString *error) const;
    bool turn(size_t segment, double time,
              phys_state &state) const; ///< one step in small substeps, for its orientation
    /// Lengths in m.
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

/// Appends a report's impacts on walls.
void appendImpacts(const phys_report &report, std::vector<Impact> &impacts);

} // namespace inspector
