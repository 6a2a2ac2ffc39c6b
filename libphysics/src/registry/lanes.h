// SPDX-License-Identifier: MIT
// Balls side by side: a stepper applies the same few operations to each, which compilers vectorise. Only steps in which
// a ball rolls or leans on a wall are made this way; each gives the bits of the stepper's own step, and is refused
// where that isn't certain.
#pragma once

#include <physics/plugin.h>

#include <cstdint>

namespace phys {

inline constexpr uint32_t kLaneCount = 8;
using LaneNumbers = double[kLaneCount]; ///< one number per ball

/// The data of one axis.
struct LaneAxis {
    LaneNumbers position;          ///< m
    LaneNumbers velocity;          ///< m/s
    LaneNumbers gravity, drive;    ///< m/s^2, of this step; the acceleration that follows
    LaneNumbers low, high;         ///< m: no wall is near between these
    LaneNumbers lowFace, highFace; ///< m: where the ball leans on a face; beyond all positions if there is none
};

struct Lanes {
    LaneAxis x, y;
    LaneNumbers gravityZ;                    ///< m/s^2, of this step
    LaneNumbers share;                       ///< share of the drive that accelerates the ball: 5/7, or 1 if it slides
    LaneNumbers resistance;                  ///< coefficient of rolling friction
    LaneNumbers grip;                        ///< square of the slope up to which the ball rolls
    LaneNumbers friction;                    ///< coefficient of the sliding friction that may speed the ball up
    LaneNumbers farthest;                    ///< m: longest displacement in a step if nothing is near
    LaneNumbers resisting, pull, stop, slow; ///< what follows from gravity as well: FloorDrive
    uint32_t tilted;                         ///< a bit for each lane whose gravity is new
    double dt;                               ///< s
    double reach;       ///< m: longest displacement in a step beside a face; negative if dt is unusual
    double restSquared; ///< m^2/s^2: a ball with a larger squared speed isn't at rest
    bool mayFall;       ///< whether it must be checked that balls stay on the floor
    bool looksAhead;    ///< whether some ball has to look where its new velocity leads
    double radius;      ///< m
    bool resists;       ///< whether there is rolling friction; the same for all balls
};

/// The ability of a built-in stepper to move balls in lanes: what its `extension` returns for kLanesId.
struct LaneSteps {
    /// Empties all lanes, for steps of dt of balls with or without rolling friction, according to `params`.
    void (*begin)(void *self, const phys_params &params, double dt, Lanes &lanes);
    /// Puts a ball into a lane. False if its next step isn't of this kind.
    bool (*enter)(void *self, const phys_params &params, const phys_state &state, Lanes &lanes, uint32_t lane);
    /// Moves the balls whose step is of this kind. Returns a bit for each lane that made the step.
    uint32_t (*step)(Lanes &lanes);
    /// Makes ready for steps of dt of single balls with these parameters.
    void (*prepare)(void *self, const phys_params &params, double dt);
    /// Makes one step of a single ball if it is of this kind, as prepared; doesn't set time and step.
    /// `in` may be `out`; report: a fresh one, or nullptr. False, and nothing is written, otherwise.
    bool (*one)(void *self, const phys_params &params, double dt, const phys_state &in, phys_state &out,
                phys_report *report);
    /// Stores a ball that entered with `state` and has moved since, except for time and step.
    void (*leave)(const phys_params &params, const Lanes &lanes, uint32_t lane, phys_state &state);
};
inline constexpr const char *kLanesId = "phys.lanes/1";

} // namespace phys
