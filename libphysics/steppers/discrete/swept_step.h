// SPDX-License-Identifier: MIT
// From event to event inside one step: impacts, contacts that begin and end, stops; second order throughout, model.md
// 13.5.
#pragma once

#include "base/orientation.h"
#include "discrete.h"
#include "schemes.h"

#include <optional>

namespace phys {

class SweptStep {
public:
    /// A contact that was just settled may be off by a few roundings.
    static Setting settingOf(const PlanInput &input);

    /// start: the ball at the step's start.
    SweptStep(const PlanInput &input, Reporter &reporter, Work &work, const StepPlan &plan, const Ball &start);

    const Ball &ball() const { return m_ball; }
    /// How the step turned the ball so far: piece by piece, as impacts change the spin.
    const double (&orientation() const)[4] { return m_orientation; }

    /// Positions of the ball that were tried and boxes that were tested, weighted by their cost: a position in the air
    /// is 1.
    uint32_t effort() const { return m_effort + m_boxes / kBoxesOfPlace; }

    /// Moves to the next event and handles it. True once the end of the step is reached.
    bool toNextEvent();

private:
    using Step = DiscreteStep<VelocityVerlet>;

    /// Ascending times.
    struct Looks {
        std::array<double, 7> times;
        uint32_t count = 0;

        void add(double time) {
            uint32_t place = count++;
            for (; place > 0 && times[place - 1] > time; --place) times[place] = times[place - 1];
            times[place] = time;
        }
    };

    /// How the ball moves in a phase.
    enum class Course : uint8_t {
        Free,         ///< in the air, or on one top face alone
        BetweenWalls, ///< the same along upright smooth walls
        Held          ///< contacts of any kind
    };

    /// Moves the ball t seconds into this phase, as if there were no obstacles.
    Course move(double t, Reporter &reporter, Work &work, Ball &ball) const;
    /// Where that leads.
    struct Moved {
        double t = -1.0;       ///< s; below 0: none yet
        bool slipEnds = false; ///< it was computed with this
        Course course = Course::Free;
        Ball ball{};
    };
    const Moved &movedBy(double t) const;
    Ball at(double t) const { return movedBy(t).ball; }

    bool advanceFreely();
    /// Rotates by the mean spin of the t seconds that have passed.
    void turn(const Vec3 &spinBefore, double t) {
        if (m_plan.runs(PHYS_STAGE_ORIENTATION)) rotate(m_orientation, 0.5 * t * (spinBefore + m_ball.spin));
    }
    double restSpeedAlong(const Vec3 &normal) const;
    double leavingSpeed(double restSpeed) const;
    bool touchesGround();
    bool beginOnFloor();
    void beginPhase();
    /// Whether a floor carries the ball for certain: among upright faces and edges, which can't lift it off.
    bool isSurelyCarried() const {
        uint32_t tops = 0, inclined = 0;
        for (const Contact &contact : m_contacts) {
            tops += contact.isTop;
            inclined += !contact.isTop && contact.sides[2] != 0;
        }
        return tops == 1 && inclined == 0 && m_context.params().gravity.z <= 0.0;
    }
    bool pressesNow(std::span<bool> presses = {}) const;
    void dropWhatIsLeft();
    void finishHops(const Vec3 &velocity);
    void snapToFaces();
    void stopSlowApproach();
    void keepContacts(const Vec3 &velocity);
    bool loseSpeedAlong(const NormalSpan &kept, double most, const Vec3 &velocity);
    bool isBound(double speed) const;
    void dropWhatNothingPresses(const Vec3 &velocity, double negligible);
    void finishPhase(double t);
    template<class Left>
    double timeToZero(double end, double start, Left left) const;
    double timeToSlipEnd(double end);
    double timeToStopOrRoll(double end);
    Vec3 slipOnTop(const Ball &ball) const;
    double horizon() const;
    double longestClear(double rest) const;
    double safeTimeOfPhase() const;
    bool isClear(double t) const;
    bool isParabola(Course course, double end) const;
    std::optional<double> firstTouchOfParabola(double end, const Ball &last) const;
    Looks looks(double end, const Ball &last) const;
    double firstEvent(double end) const;
    double root(double before, double lateBefore, double after, double lateAfter) const;
    double lateness(const Ball &ball) const;
    double overlap(const Ball &ball) const;
    double beyondFeature(const Ball &ball) const;
    bool holds(uint32_t box) const {
        return std::any_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &c) { return c.box == box; });
    }

    PlanInput m_input;
    StepPlan m_plan;
    StepContext m_context;
    double m_substep; ///< s: longest way in contact at a time
    double m_slow;    ///< m/s: a slower motion counts as none for a lasting contact
    Ball m_ball;
    double m_orientation[4];
    static constexpr uint32_t kBoxesOfPlace = 16;
    mutable uint32_t m_effort = 0, m_boxes = 0;
    mutable int m_halvings = 0; ///< of the step's rest in the last phase
    mutable Moved m_moved;      ///< the last one: the end of a phase is asked for several times
    double m_done = 0.0;        ///< s of the step that lie behind the ball
    Contacts m_contacts;        ///< the contacts of this phase
    Vec3 m_taken{0.0};          ///< m/s: what contacts took of the velocity at the phase's beginning, for reactions
    double m_hopEnd = INFINITY; ///< s into the phase at which a hop that a contact took ends
    bool m_isAlone = false;     ///< nothing but one top face is touched
    bool m_resists = false;     ///< resistance may stop the ball, beside other contacts
    bool m_slipEnds = false;    ///< somewhere in this phase, which is then short
    double m_stop = 0.0;        ///< s into the phase at which the ball stops
    double m_roll = 0.0;        ///< s into the phase at which the slip on the floor ends
};

} // namespace phys
