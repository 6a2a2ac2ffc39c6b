// SPDX-License-Identifier: MIT
// A ball that stays at a wall under friction, of the floor, of the wall or of both: model.md 6.5. The smooth phases
// without a closed form, as Taylor series in a variable s in which the ends of slips are regular.
#pragma once

#include "taylor.h"

namespace phys {

/// What friction does at a contact.
enum class Grip {
    none,   ///< no contact
    smooth, ///< no friction
    slips,  ///< Coulomb's, against the slip
    rolls   ///< as much as keeps the slip at zero
};

/// A slip below this, relative to the speeds whose difference it is, is their rounding.
inline constexpr double kRolls = 8.0 * kRounding;

/// The motion at a moment, in the axes n (the wall's normal), along (level: z x n or its opposite) and up.
struct WallState {
    double along = 0.0, up = 0.0;                   ///< velocity of the centre
    double floorSlip = 0.0;                         ///< along; across the wall it is up - wallSlipUp
    double wallSlip = 0.0, wallSlipUp = 0.0;        ///< along and up
    double gravityAcross = 0.0, gravityAlong = 0.0; ///< along n, and along

    /// The slip that floor and wall share, but for its sign: across the wall there, up here.
    double shared() const { return wallSlipUp - up; }

    /// Largest slip that is none but for rounding.
    double rounding() const;
};

/// What stays the same in a phase.
struct WallLaw {
    double weight = 0.0;    ///< -g.z
    double curvature = 0.0; ///< of the way: 0 on a face, 1/R round an edge
    double floorFriction = 0.0, wallFriction = 0.0;
    double resistance = 0.0; ///< what slows a ball that rolls on the floor, along: +- mu_r gn
    Grip floor = Grip::none, wall = Grip::smooth;
    bool isStraight = false;                  ///< no slip across or up: each keeps its sense, and s is the time
    double floorSense = 0.0, wallSense = 0.0; ///< +1 or -1
};

/// In units in which speeds and accelerations are near 1.
class WallMotion {
public:
    /// Forces with the terms below `order`, motions with those up to it.
    WallMotion(const WallLaw &law, const WallState &now, int order = Taylor::kOrder);

    /// Whether a slip may turn; if not, s is the time.
    bool slipsTurn() const { return !m_law.isStraight && (m_law.floor == Grip::slips || m_law.wall == Grip::slips); }

    /// Longest s up to which the series are good to rounding.
    double goodFor() const;

    WallState at(double s) const;

    /// On the floor: across the wall and along it. On the wall: up and along.
    struct Pair {
        Taylor aside, along;
    };
    Taylor time, way, height, heat;   ///< since the start: s, m along, m up, energy lost to slip
    Taylor along, up;                 ///< velocity
    Taylor floorForce, wallForce;     ///< normal forces per mass
    Pair floorSlip, wallSlip;         ///< velocities
    Pair floorPush, wallPush;         ///< friction per mass
    Taylor floorReserve, wallReserve; ///< where the ball rolls: (mu N)^2 less the friction's square

private:
    struct Direction {
        Taylor square, speed; ///< of the slip
        Pair unit;
        void extend(const Pair &slip, int k);
        void keep(const Pair &slip, double sense, int k);
    };

    WallLaw m_law;
    Pair m_gravity;                   // aside: along n
    Taylor m_turning;                 // rate of n: curvature * along
    Taylor m_spinAcross, m_spinAlong; // R om in the axes
    Taylor m_pressing;                // what the wall must push without the floor's friction
    Direction m_onFloor, m_onWall;
    Taylor m_clock;                                   // dt/ds
    Taylor m_product, m_sum, m_determinant, m_weight; // of two slips and of the equations of two forces
    struct Rates {
        Taylor along, up, floorSlip, wallSlip, wallSlipUp, gravityAcross, gravityAlong, heat;
    } m_rates; // by the time

    void extendSlips(int k);
    void extendForces(int k);
    void extendReserves(int k);
    void extendRates(int k);
    void extendMotion(int k);
};

} // namespace phys
