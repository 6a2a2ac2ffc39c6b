// SPDX-License-Identifier: MIT
// From impact to impact inside one step: second-order conservative advancement along the scheme's path, model.md 5.2.
#pragma once

#include "requirements.h"
#include "velocity_verlet.h"

#include <array>

namespace phys {

class Sweep {
public:
    /// start: the ball at the step's start.
    Sweep(const PlanInput &input, Reporter &reporter, const StepPlan &plan, const Ball &start);

    const Ball &ball() const { return m_ball; }

    /// Pushes a ball that overlaps boxes out of them; false if it can't be freed.
    bool leaveOverlaps();

    /// Moves to the next impact, landing or floor edge and lets it happen. True once the step's end is reached.
    bool toNextEvent();

private:
    static constexpr uint32_t kMost = 64;

    /// A short list of solids without allocation.
    struct Solids {
        std::array<uint32_t, kMost> numbers;
        uint32_t count = 0;

        void add(uint32_t solid) {
            if (count < kMost) numbers[count++] = solid;
        }
        bool has(uint32_t solid) const {
            return std::find(numbers.begin(), numbers.begin() + count, solid) != numbers.begin() + count;
        }
    };

    /// The ball t seconds into this phase, as if there was nothing ahead.
    Ball at(double t, Reporter &reporter) const;
    Ball at(double t) const;

    /// First time in [0, horizon] at which `happens` (false at 0, true at horizon) is true.
    template<class Predicate>
    double firstTime(double horizon, Predicate happens) const;

    void beginPhase();
    std::span<const uint32_t> candidatesWithin(double horizon);
    double endOfSupport(double horizon) const;
    double endOfFaces(double horizon) const;
    double timeOfImpact(double horizon, bool &impact);
    double safeStep(const Ball &ball, bool atStart, std::span<const uint32_t> candidates, bool &touches) const;
    void resolveImpacts();
    void landNow();
    bool endsInContact(double bounced, double pressing) const;

    StepContext m_context;
    PlanInput m_input;
    StepPlan m_plan;
    Ball m_ball;
    double m_done = 0.0;       ///< s of the step that lie behind the ball
    Surroundings m_around;     ///< at the phase's start
    Vec3 m_drive{0.0};         ///< acceleration at the phase's start, m/s^2
    double m_mostAcceleration; ///< bound of |p''|, m/s^2
    Solids m_ignored;          ///< touched at the phase's start without approaching
    Solids m_faces;            ///< those of them on whose faces the ball leans
    Solids m_buffer;
};

} // namespace phys
