// SPDX-License-Identifier: MIT
// One step of the exact stepper: from event to event until the time is up, model.md 8.
#pragma once

#include "arc.h"
#include "contact/response.h"
#include "corner_motion.h"
#include "hold.h"
#include "registry/report.h"
#include "sweep.h"
#include "wall_grip.h"

namespace phys {

class Run {
public:
    Run(const Board &board, Sweep &sweep, const phys_params &params, double dt, const phys_state &in,
        phys_report *report, phys_error *err);

    /// Fills everything but the time and the number of the step.
    phys_status advance(phys_state &out);

private:
    /// How long the ball can slide on a face: until the time `until`, when it has reached the coordinate `end` if it
    /// ends.
    struct FaceWay {
        double until;
        bool ends;
        double end;
    };
    /// When a ball in the air stops falling as it does.
    struct Fall {
        double time;
        bool lands;
    };

    /// How the events of a step get on.
    struct Pace {
        explicit Pace(double left)
            : moment(1e-9 * left)
            , momentStart(left) {}

        double moment;      ///< s
        double momentStart; ///< s of the step still to go then
        uint32_t events = 0, eventsInMoment = 0;
    };

    /// Units in which speeds and accelerations are near 1; powers of two, so that they cost no rounding.
    struct Units {
        double speed, acceleration;

        double time() const { return speed / acceleration; }
        double length() const { return speed * time(); }
    };
    struct WallAxes {
        Vec2 normal, along; ///< unit
    };
    /// A ball that stays at a wall.
    struct AtWall {
        WallAxes axes;
        Units units;
        WallLaw law;
        WallState now;
    };
    /// Where in s a phase at a wall ends, and why.
    struct WallEnd {
        enum class Cause { series, time, force, stop, floorRolls, wallRolls, landing, way };
        double s;
        Cause cause;

        /// Not beyond where f falls through zero.
        void cut(const Taylor &f, Cause why);
    };
    /// A ball that two walls hold.
    struct AtCorner {
        Units units;
        CornerLaw law;
        CornerState now;
    };
    /// What ends the way along a wall after a length: the face or the quarter circle itself, another solid, the floor.
    struct WallWay {
        enum class End { none, contour, touch, floor };
        double length;
        End end;
        double coordinate; ///< of the end of a face
    };

    const Board &m_board;
    Sweep &m_sweep;
    const phys_params &m_params;
    Reporter m_report;
    phys_error *m_err;
    Ball m_ball;
    double m_left;          // s of the step still to go
    double m_elapsed = 0.0; // s of the step gone by
    double m_orientation[4];
    Touches m_touches;               // at the present position
    std::optional<uint32_t> m_floor; // that the present phase runs on
    std::optional<uint32_t> m_held;  // the solid that held the ball in the last phase
    bool m_meets = false;            // the last phase ended at a solid or a floor
    bool m_cornered = false;         // the present phase has been looked at as one between two walls
    uint32_t m_levelTouches = 0;     // phases since the last bounce that ended so, round an edge in the air

    // begin and end of the step: run.cpp
    phys_status keep(Pace &pace);
    void enter();
    phys_status pushOut();
    void leave(phys_state &out);
    void spend(double t);
    void followVelocity();
    void turn(const Vec3 &by);
    void event(uint32_t kind, double before, double after);
    void contactEvent(uint32_t kind, const Touch &touch, double before, double after);
    phys_status refuse(const char *what, const Touch &touch) const;

    // events: run_events.cpp
    phys_status resolve();
    void snapToFaces();
    void bounce(const Touch &touch);
    bool isLastBounce(const Touch &touch, double after) const;
    bool resolveFloor();
    double smallestHop() const;
    void land();
    void takeOff();
    void stopBetween();

    // smooth phases: run_phases.cpp
    phys_status phase();
    Drive drive() const;
    bool passesBorder(const Hold &hold) const;
    bool isAtRest();
    Touch touchOf(uint32_t solid) const;
    void noteHold(const Hold &hold);
    phys_status rest(const Hold &hold);
    phys_status moveFreely(const Hold &hold);
    phys_status slideOnFace(const Hold &hold);
    phys_status pivotOnEdge(const Hold &hold);
    bool glide();
    void follow(const Motion &motion, double t);
    double move(const Motion &motion, const Plane *plane, double until);
    double returnTime(const Motion &motion) const;
    void slide(const Hold &hold, const Motion &motion);
    FaceWay alongFace(const Plane &plane, const Motion &motion, double most) const;
    FaceWay alongSolid(const Hold &hold, const Motion &motion) const;
    double landingTime() const;
    Fall fallFor(const Hold &hold) const;
    void settleSpin(const Motion &motion, double t);
    void turnAlong(const Motion &motion, const Vec3 &start, double t);
    void turnOnArc(const EdgeArc &arc, double angle, double t);

    // the rigid model's slip: run_slip.cpp
    bool slides() const;
    Vec2 slipVelocity() const;
    bool gripHolds(const Hold &hold) const;
    Drive slipDrive(const Vec2 &u) const;
    phys_status slip();
    phys_status slipFreely(const Vec2 &u);
    void spinDown(const Vec2 &u);
    void settleSlip(const Motion &motion, double t);
    void roll();

    // the rigid model at a wall with friction: run_wall.cpp
    bool isRough(const Hold &hold) const;
    WallState seenFrom(const Vec2 &normal) const;
    AtWall lookAtWall(const Hold &hold) const;
    phys_status stayAtWall(const Hold &hold);
    Units unitsFor(double fastest) const;
    double unitOfAcceleration() const;
    double leastSpeed() const;
    WallEnd endAtWall(const Hold &hold, const AtWall &wall, const WallMotion &motion) const;
    void cutFall(WallEnd &end, const Taylor &height, double unit, const Vec3 &normal) const;
    WallWay wayAlong(const Hold &hold, const AtWall &wall, double reach);
    bool meetsEnds(const AtWall &wall, const WallMotion &motion, double end) const;
    WallWay wayOnFace(const Hold &hold, const AtWall &wall, double reach);
    WallWay wayOnEdge(const Hold &hold, const AtWall &wall, double reach);
    void follow(const Hold &hold, const AtWall &wall, const WallMotion &motion, const WallEnd &end, const WallWay &way);
    static bool settleSlips(const WallLaw &law, WallEnd::Cause cause, double smallest, const WallState &before,
                            WallState &now);
    WallAxes axesAfter(const Hold &hold, const AtWall &wall, double length, bool atContour) const;
    Vec3 spinAtWall(const WallLaw &law, const WallState &now, const WallAxes &axes) const;
    void turnAtWall(const Hold &hold, const AtWall &wall, const WallMotion &motion, double end);
    phys_status letGo();

    // between two walls: run_corner.cpp
    phys_status stayInCorner(const Hold &hold);
    bool isFreeToStay(const Hold &single) const;
    std::optional<AtCorner> lookAtCorner(const Touch &first, const Touch &second) const;
    void followCorner(const AtCorner &corner);

    bool isRolling() const { return m_params.model == PHYS_MODEL_ROLLING; }
};

} // namespace phys
