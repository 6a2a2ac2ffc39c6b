// SPDX-License-Identifier: MIT
// A step of balls on the floor, each in a region where it only rolls or leans on walls. The code is the same for one
// ball and for several side by side (base/pair.h), and gives the results of FloorRun.
#pragma once

#include "base/pair.h"
#include "floor_contact.h"
#include "registry/params.h"

namespace phys {

/// When a stepper leaves a step to its general case.
enum class RegionRule {
    Substeps, ///< steps of DiscreteStepper
    Swept     ///< steps of swept, which checks whether the path reverses, and how a ball starts
};

/// What is the same for all balls of a step.
struct RegionLimits {
    double h;           ///< s
    double reach;       ///< m: longest displacement in a step beside a face; negative if h is unusual
    double restSquared; ///< m^2/s^2: a ball with a larger squared speed isn't at rest
    bool mayFall;       ///< whether it must be checked that balls stay on the floor
};

/// The speed (m/s) up to which resistance may stop a ball within h, from nearStop.
template<class N>
N stopSpeed(const Planar<N> &A, N B, double h) {
    const N drive = length(A);
    return choose(B < drive, 1.0, 4.0) * (drive + B) * h;
}

/// What gravity and friction do to balls on the floor, model.md 2.1.
template<class N>
struct FloorDrive {
    Planar<N> A; ///< acceleration of a ball that nothing holds, m/s^2
    N B;         ///< rolling resistance, m/s^2
    N pull; ///< upper bound of what may accelerate a ball, m/s^2; INFINITY if steps in regions aren't for this drive
    N stop; ///< square of stopSpeed, m^2/s^2
    N slow; ///< square of the longest way without the drive, m^2; -1 if even the drive's is too long
};

/// The drive of a tilt. share: of the drive that accelerates the ball; resistance: coefficient of rolling friction;
/// friction: that of the sliding friction which may speed the ball up; grip: square of the slope up to which it rolls.
template<class N>
FloorDrive<N> driveOf(const Planar<N> &gravity, N gravityZ, N share, N resistance, N friction, N grip,
                      const RegionLimits &limits) {
    const double h = limits.h;
    const N normal = -gravityZ, level = magnitude(gravity.x) + magnitude(gravity.y);
    const Planar<N> A = share * gravity;
    const N B = share * (resistance * normal);
    // In a batch gravity isn't checked in each step.
    const auto isUsual = all(level <= kMostGravity, normal <= kMostGravity, normal > 0.0,
                             dot(gravity, gravity) <= grip * (normal * normal));
    const N pull = choose(isUsual, level + friction * normal, INFINITY);
    const N stop = stopSpeed(A, B, h), farthest = limits.reach - h * h * pull; // from reachOfStep
    return {A, B, pull, stop * stop, choose(farthest > 0.0, farthest * farthest, -1.0)};
}

/// One axis of balls in their regions: either nothing is near a ball, or it is at a face with no speed along the axis.
template<class N>
struct InRegion {
    using Mask = MaskOf<N>;

    N place, velocity;   ///< m, m/s
    N low, high;         ///< m: no wall is near between these
    N lowFace, highFace; ///< m: where the ball leans on a face; beyond all positions if there is none

    Mask isAtLow() const { return all(place == lowFace, velocity == 0.0); }
    Mask isAtHigh() const { return all(place == highFace, velocity == 0.0); }
    /// Whether nothing is near a position.
    Mask isFree(N there) const { return all(low <= there, there <= high); }
    Mask isFreeAround(N way) const { return all(low <= place - way, place + way <= high); }
    /// Whether that is so, or the ball is still at its face, with a velocity with which it may be there.
    Mask has(N there, N velocityThere) const {
        return any(isFree(there), all(any(isAtLow(), isAtHigh()), there == place, velocityThere == 0.0));
    }
    /// Whether the ball reaches no other face within a displacement in either direction.
    Mask isClear(N way) const { return all(any(low <= place - way, isAtLow()), any(place + way <= high, isAtHigh())); }
};

// Balls in regions are a type that reads on demand
//
//     InRegion<N> x(), y();
//     FloorDrive<N> drive();
//     N farthest(); ///< m: longest displacement in a step of swept where nothing is near
//
// for its number type Number, N: most steps need only some of it.

template<class Balls>
Planar<typename Balls::Number> velocityOf(const Balls &balls) {
    return {balls.x().velocity, balls.y().velocity};
}

/// The motion of balls in a step, and whether their regions allow it.
template<class N>
struct RegionStep {
    Planar<N> velocity, displacement;
    MaskOf<N> isFine;
};

/// The law for balls that resistance doesn't stop within the step and that aren't at rest if there is resistance.
template<class N, bool kResists>
struct UnstoppedLaw {
    Planar<N> A; ///< constant acceleration, m/s^2
    N B;         ///< constant resistance against the motion, m/s^2
};

template<class N, bool kResists>
bool nearStop(const UnstoppedLaw<N, kResists> &, const Planar<N> &, double) {
    return false;
}
template<class N, bool kResists>
Planar<N> acceleration(const UnstoppedLaw<N, kResists> &law, const Planar<N> &v) {
    if constexpr (kResists) return law.A - law.B / length(v) * v;
    return law.A;
}
template<class N, bool kResists>
Planar<N> clampedVelocity(const UnstoppedLaw<N, kResists> &law, const Planar<N> &v, double dt) {
    return v + dt * acceleration(law, v);
}
template<class N, bool kResists>
Advance<Planar<N>> stopping(const UnstoppedLaw<N, kResists> &law, const Planar<N> &v, double h) {
    return {clampedVelocity(law, v, h), h * v};
}

/// Which faces press on balls, and what these leave of the drive.
template<class N>
struct Lean {
    MaskOf<N> onX, onY; ///< at a face across that axis
    Planar<N> A;        ///< m/s^2

    Lean(const InRegion<N> &x, const InRegion<N> &y, const Planar<N> &drive)
        : onX(isPressed(x, drive.x))
        , onY(isPressed(y, drive.y))
        , A(choose(onX, 0.0, drive.x), choose(onY, 0.0, drive.y)) {}

private:
    static MaskOf<N> isPressed(const InRegion<N> &along, N drive) {
        return any(all(along.isAtLow(), drive < 0.0), all(along.isAtHigh(), drive > 0.0));
    }
};

/// Whether a ball that is at rest in its region stays so, model.md 6.3.
template<class Ball>
bool staysAtRest(const Ball &ball) {
    const FloorDrive<double> &drive = ball.drive();
    const Planar<double> A = Lean<double>(ball.x(), ball.y(), drive.A).A;
    return dot(A, A) <= drive.B * drive.B && drive.pull < INFINITY;
}

/// Whether the explicit rule may have to look where the new velocity leads: FloorRun::mayLean.
template<class Scheme>
inline constexpr bool kLooksAhead = Scheme::kContactRule == ContactRule::Explicit;

/// Whether nothing is near there. A ball that leans on a face is left to the general case.
template<class Balls, class N = typename Balls::Number>
MaskOf<N> isFreeAhead(const Balls &balls, double h, const Planar<N> &newVelocity) {
    const InRegion<N> x = balls.x(), y = balls.y();
    return all(x.isFree(x.place + h * newVelocity.x), y.isFree(y.place + h * newVelocity.y));
}

/// The step of a scheme, without regard to regions. kResists: whether there is rolling friction, for all balls or for
/// none.
template<class Scheme, RegionRule kRule, bool kResists>
struct StepInRegion {
    /// The step of the balls for which it is possible.
    template<class Balls, class Take>
    static auto make(const Balls &balls, const RegionLimits &limits, Take take) {
        const auto velocity = velocityOf(balls);
        const bool areFree = bitsOf(any(velocity.x == 0.0, velocity.y == 0.0)) == 0;
        return areFree ? take(rollFree(balls, limits)) : take(rollBeside(balls, limits));
    }

private:
    /// Balls none of which is at a face.
    template<class Balls, class N = typename Balls::Number>
    static RegionStep<N> rollFree(const Balls &balls, const RegionLimits &limits) {
        const InRegion<N> x = balls.x(), y = balls.y();
        const FloorDrive<N> &drive = balls.drive();
        const Planar<N> velocity = velocityOf(balls);
        RegionStep<N> step = rollBy(drive.A, drive.stop, drive.B, velocity, limits);
        const N farthest = kRule == RegionRule::Swept ? balls.farthest() : N(limits.reach);
        MaskOf<N> isFine =
            all(step.isFine, isSlow(velocity, drive, farthest, limits.h), x.isFree(x.place + step.displacement.x),
                y.isFree(y.place + step.displacement.y), staysFast(limits, velocity, step.velocity));
        if constexpr (kRule == RegionRule::Swept) {
            const Planar<N> turn = 0.5 * limits.h * velocity;
            isFine = all(isFine, wayOf(step) <= farthest, x.isFree(x.place + turn.x), y.isFree(y.place + turn.y));
        }
        if (limits.mayFall) isFine = all(isFine, staysOnFloor(x, y, drive, limits));
        step.isFine = isFine;
        return step;
    }

    /// Any balls.
    template<class Balls, class N = typename Balls::Number>
    static RegionStep<N> rollBeside(const Balls &balls, const RegionLimits &limits) {
        const InRegion<N> x = balls.x(), y = balls.y();
        const FloorDrive<N> &drive = balls.drive();
        const double h = limits.h;
        const Lean<N> lean(x, y, drive.A);
        const Planar<N> velocity = velocityOf(balls);
        const N stop = stopSpeed(lean.A, drive.B, h);
        RegionStep<N> step = rollBy(lean.A, stop * stop, drive.B, velocity, limits);
        step.velocity = {choose(lean.onX, 0.0, step.velocity.x), choose(lean.onY, 0.0, step.velocity.y)};
        step.displacement = {choose(lean.onX, 0.0, step.displacement.x), choose(lean.onY, 0.0, step.displacement.y)};

        // Other faces are looked for along the displacement without the face on which the ball leans.
        const N aheadX = (magnitude(velocity.x) + (magnitude(drive.A.x) + drive.B) * h) * h;
        const N aheadY = (magnitude(velocity.y) + (magnitude(drive.A.y) + drive.B) * h) * h;
        const auto isClear = all(x.isClear(choose(lean.onY, aheadX, 0.0)), y.isClear(choose(lean.onX, aheadY, 0.0)));
        step.isFine =
            all(step.isFine, isSlow(velocity, drive, N(limits.reach), h), wayOf(step) <= limits.reach, isClear,
                x.has(x.place + step.displacement.x, step.velocity.x),
                y.has(y.place + step.displacement.y, step.velocity.y), staysFast(limits, velocity, step.velocity));
        if constexpr (kRule == RegionRule::Swept) {
            const Planar<N> turn = 0.5 * h * velocity;
            step.isFine = all(step.isFine, x.has(x.place + turn.x, velocity.x), y.has(y.place + turn.y, velocity.y));
        }
        if (limits.mayFall) step.isFine = all(step.isFine, staysOnFloor(x, y, drive, limits));
        return step;
    }

    /// The step under a drive, without regard to regions. Balls that are left to the general case, as those whose
    /// squared speed isn't above `stop`, get finite substitutes.
    template<class N>
    static RegionStep<N> rollBy(const Planar<N> &A, N stop, N B, const Planar<N> &velocity,
                                const RegionLimits &limits) {
        const N speedSquared = dot(velocity, velocity);
        const auto goesOn = kResists                        ? speedSquared > stop
                            : kRule == RegionRule::Substeps ? speedSquared >= 0.0
                                                            : speedSquared > 0.0;
        const Planar<N> v{choose(goesOn, velocity.x, 1.0), choose(goesOn, velocity.y, 0.0)};
        const auto next = Scheme::advance(UnstoppedLaw<N, kResists>{A, B}, v, limits.h);
        return {next.velocity, next.displacement, goesOn};
    }

    /// Whether a ball moves by at most `most` (m), which is the limits' reach where substeps would make it longer.
    template<class N>
    static MaskOf<N> isSlow(const Planar<N> &velocity, const FloorDrive<N> &drive, N most, double h) {
        if constexpr (kRule == RegionRule::Swept) return reach(velocity, drive, h) <= most;
        return h * h * dot(velocity, velocity) <= drive.slow;
    }

    /// An upper bound of a ball's displacement, m.
    template<class N>
    static N wayOf(const RegionStep<N> &step) {
        return magnitude(step.displacement.x) + magnitude(step.displacement.y);
    }

    /// An upper bound of how far a ball can move, m.
    template<class N>
    static N reach(const Planar<N> &velocity, const FloorDrive<N> &drive, double h) {
        return (magnitude(velocity.x) + magnitude(velocity.y) + drive.pull * h) * h;
    }

    /// Whether a step ends neither nearly at rest nor in the opposite direction.
    template<class N>
    static MaskOf<N> staysFast(const RegionLimits &limits, const Planar<N> &velocity, const Planar<N> &next) {
        const auto isFast = dot(next, next) > limits.restSquared;
        if constexpr (kRule == RegionRule::Substeps) return isFast;
        return all(isFast, dot(next, velocity) > 1.1e-9 * dot(velocity, velocity));
    }

    template<class N>
    static MaskOf<N> staysOnFloor(const InRegion<N> &x, const InRegion<N> &y, const FloorDrive<N> &drive,
                                  const RegionLimits &limits) {
        const N way = reach(Planar<N>{x.velocity, y.velocity}, drive, limits.h);
        return all(x.isFreeAround(way), y.isFreeAround(way));
    }
};

} // namespace phys
