// SPDX-License-Identifier: MIT
// Balls side by side: a stepper moves them by the same few operations on each, which compilers make vector instructions
// of. Only steps that are nothing but rolling, leaning on a wall or resting are made so; each gives the bits of the
// stepper's own step, and is refused where that isn't certain.
#pragma once

#include <physics/plugin.h>

#include <cstdint>

namespace phys {

inline constexpr uint32_t kLaneCount = 8;
using LaneNumbers = double[kLaneCount]; ///< one of each ball

/// Of one axis.
struct LaneAxis {
    LaneNumbers position;          ///< m
    LaneNumbers velocity;          ///< m/s
    LaneNumbers gravity;           ///< m/s^2, of this step
    LaneNumbers low, high;         ///< m: no wall is near between these
    LaneNumbers lowFace, highFace; ///< m: where the ball leans on a face; beyond all places if there is none
};

struct Lanes {
    LaneAxis x, y;
    LaneNumbers gravityZ;   ///< m/s^2, of this step
    LaneNumbers share;      ///< of the drive that accelerates the ball: 5/7, or 1 if it slides
    LaneNumbers resistance; ///< coefficient of rolling friction
    LaneNumbers grip;       ///< square of the slope up to which the ball rolls
    LaneNumbers friction;   ///< coefficient of the sliding friction that may speed the ball up
    LaneNumbers rests;      ///< 1: the ball is at rest, 0: it moves
    LaneNumbers farthest;   ///< m: longest way of a step where nothing is near
    double dt;              ///< s
    double reach;           ///< m: longest way of a step beside a face; below 0 if dt is unusual
    double restSquared;     ///< m^2/s^2: square of a speed that isn't rest
    bool isOpen;            ///< whether there is nothing but one floor, which the ball must not leave
    double radius;          ///< m
    bool mayGrip;           ///< whether `grip` limits the slope of any ball
    bool resists;           ///< whether there is rolling friction; the same for all
};

/// The ability of a built-in stepper to move balls so: what its `extension` answers to kLanesId.
struct LaneSteps {
    /// Empties all lanes, for steps of dt of balls with or without rolling friction, as `params` says.
    void (*begin)(void *self, const phys_params &params, double dt, Lanes &lanes);
    /// Takes a ball into a lane. False if its next step isn't such a one.
    bool (*enter)(void *self, const phys_params &params, const phys_state &state, Lanes &lanes, uint32_t lane);
    /// Moves the balls that can move so. Returns which took the step, a bit for each lane.
    uint32_t (*step)(Lanes &lanes);
    /// Makes one step by itself, where it is such a one; but for time and step. `in` may be `out`; report: a fresh one,
    /// or nullptr. False, and nothing is written, if it isn't.
    bool (*one)(void *self, const phys_params &params, double dt, const phys_state &in, phys_state &out,
                phys_report *report);
    /// Stores a ball that has moved since it entered with `state`, but for time and step.
    void (*leave)(const phys_params &params, const Lanes &lanes, uint32_t lane, phys_state &state);
};
inline constexpr const char *kLanesId = "phys.lanes/1";

} // namespace phys
