// SPDX-License-Identifier: MIT
// One step of the exact stepper: from event to event until the time is up, model.md 8.
#pragma once

#include "arc.h"
#include "hold.h"
#include "report.h"
#include "response.h"
#include "sweep.h"

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
    std::optional<Touch> m_held;     // by the last phase
    bool m_meets = false;            // the last phase ended at a solid or a floor

    // begin and end of the step: run.cpp
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
    void land();
    void takeOff();
    void stopBetween();

    // smooth phases: run_phases.cpp
    phys_status phase();
    Drive drive() const;
    bool isAtRest();
    void noteHold(const Hold &hold);
    phys_status rest(const Hold &hold);
    phys_status moveFreely(const Hold &hold);
    phys_status slideOnFace(const Hold &hold);
    phys_status pivotOnEdge(const Hold &hold);
    bool glide();
    void follow(const Motion &motion, double t);
    double move(const Motion &motion, const Plane *plane, double until);
    void slide(const Hold &hold, const Motion &motion);
    FaceWay alongFace(const Plane &plane, const Motion &motion) const;
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
    phys_status slipOnFace(const Hold &hold, const Vec2 &u);
    void spinDown(const Vec2 &u);
    void settleSlip(const Motion &motion, double t);
    void roll();

    // the rigid model at a rough wall: run_groove.cpp
    bool isRough(const Hold &hold) const;
    phys_status rubOnWall(const Hold &hold);
    void rollInGroove(const Hold &hold, double acceleration, double spinRate, double end);

    bool isRolling() const { return m_params.model == PHYS_MODEL_ROLLING; }
};

} // namespace phys
