// SPDX-License-Identifier: MIT
// A step of balls on the floor, each in a region where it only rolls, leans on walls or rests. The code is the same for
// one ball and for several side by side (base/pair.h), and gives the results of FloorRun, or of LastFooting at rest.
#pragma once

#include "base/pair.h"
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
    bool isOpen;        ///< whether there is only a floor, which a ball must not leave
    bool mayGrip;       ///< whether `grip` limits the slope for any ball
};

/// The effect of gravity on balls on the floor, model.md 2.1.
template<class N>
struct FloorDrive {
    Planar<N> pull; ///< gravity along the floor, m/s^2
    N normal;       ///< gravity into it, m/s^2
    Planar<N> A;    ///< acceleration of a ball that nothing holds, m/s^2
    N B;            ///< rolling resistance, m/s^2

    FloorDrive(const Planar<N> &along, N gravityZ, N share, N resistance)
        : pull(along)
        , normal(-gravityZ)
        , A(share * along)
        , B(share * (resistance * normal)) {}

    /// Whether parameters may have this gravity, which in a batch differs from step to step.
    MaskOf<N> isAllowed() const {
        return all(magnitude(pull.x) + magnitude(pull.y) <= kMostGravity, normal <= kMostGravity, normal > 0.0);
    }
};

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

template<class N>
struct BallsInRegion {
    InRegion<N> x, y;
    FloorDrive<N> drive;
    N grip;     ///< square of the slope up to which the ball rolls
    N friction; ///< coefficient of the sliding friction that may speed the ball up
    N rests;    ///< 1: the ball is at rest, 0: it moves
    N farthest; ///< m: longest displacement in a step of swept where nothing is near

    Planar<N> velocity() const { return {x.velocity, y.velocity}; }
};

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

/// The step of a scheme, without regard to regions. kResists: whether there is rolling friction, for all balls or for
/// none.
template<class Scheme, RegionRule kRule, bool kResists>
struct StepInRegion {
    /// The step of the balls for which it is possible.
    template<class N, class Take>
    static auto make(const BallsInRegion<N> &balls, const RegionLimits &limits, Take take) {
        const bool areFree = bitsOf(any(balls.x.velocity == 0.0, balls.y.velocity == 0.0)) == 0;
        return areFree ? take(rollFree(balls, limits)) : take(rollOrRest(balls, limits));
    }

private:
    /// Balls none of which is at a face or at rest.
    template<class N>
    static RegionStep<N> rollFree(const BallsInRegion<N> &balls, const RegionLimits &limits) {
        const InRegion<N> &x = balls.x, &y = balls.y;
        RegionStep<N> step = rollBy(balls.drive.A, balls, limits);
        const N farthest = kRule == RegionRule::Swept ? balls.farthest : N(limits.reach);
        MaskOf<N> isFine =
            all(step.isFine, isSlow(balls, farthest, limits.h), x.isFree(x.place + step.displacement.x),
                y.isFree(y.place + step.displacement.y), staysFast(limits, balls.velocity(), step.velocity));
        if constexpr (kRule == RegionRule::Swept) {
            const Planar<N> turn = 0.5 * limits.h * balls.velocity();
            isFine = all(isFine, wayOf(step) <= farthest, x.isFree(x.place + turn.x), y.isFree(y.place + turn.y));
        }
        if (mayFall(balls, limits)) isFine = all(isFine, staysOnFloor(balls, limits));
        step.isFine = isFine;
        return step;
    }

    /// Any balls.
    template<class N>
    static RegionStep<N> rollOrRest(const BallsInRegion<N> &balls, const RegionLimits &limits) {
        const auto &[x, y, drive, grip, friction, rests, farthest] = balls;
        const double h = limits.h;
        // A face removes the component of the drive into it for a ball that leans on it.
        const auto leansX = any(all(x.isAtLow(), drive.A.x < 0.0), all(x.isAtHigh(), drive.A.x > 0.0));
        const auto leansY = any(all(y.isAtLow(), drive.A.y < 0.0), all(y.isAtHigh(), drive.A.y > 0.0));
        const Planar<N> A{choose(leansX, 0.0, drive.A.x), choose(leansY, 0.0, drive.A.y)};
        const Planar<N> velocity = balls.velocity();
        RegionStep<N> step = rollBy(A, balls, limits);
        step.velocity = {choose(leansX, 0.0, step.velocity.x), choose(leansY, 0.0, step.velocity.y)};
        step.displacement = {choose(leansX, 0.0, step.displacement.x), choose(leansY, 0.0, step.displacement.y)};

        // Other faces are looked for along the displacement without the face on which the ball leans.
        const N aheadX = (magnitude(velocity.x) + (magnitude(drive.A.x) + drive.B) * h) * h;
        const N aheadY = (magnitude(velocity.y) + (magnitude(drive.A.y) + drive.B) * h) * h;
        const auto isClear = all(x.isClear(choose(leansY, aheadX, 0.0)), y.isClear(choose(leansX, aheadY, 0.0)));
        auto rolls =
            all(step.isFine, isSlow(balls, N(limits.reach), h), wayOf(step) <= limits.reach, isClear,
                x.has(x.place + step.displacement.x, step.velocity.x),
                y.has(y.place + step.displacement.y, step.velocity.y), staysFast(limits, velocity, step.velocity));
        if constexpr (kRule == RegionRule::Swept) {
            const Planar<N> turn = 0.5 * h * velocity;
            rolls = all(rolls, x.has(x.place + turn.x, velocity.x), y.has(y.place + turn.y, velocity.y));
        }
        step.isFine = rolls;
        const auto isAtRest = rests > 0.0;
        if (bitsOf(isAtRest)) {
            const auto isHeld = all(dot(A, A) <= drive.B * drive.B, balls.drive.isAllowed(), isClear);
            step.velocity = {choose(isAtRest, velocity.x, step.velocity.x),
                             choose(isAtRest, velocity.y, step.velocity.y)};
            step.displacement = {choose(isAtRest, 0.0, step.displacement.x),
                                 choose(isAtRest, 0.0, step.displacement.y)};
            step.isFine = any(all(isAtRest, isHeld), all(rests == 0.0, rolls));
        }
        if (mayFall(balls, limits)) step.isFine = all(step.isFine, staysOnFloor(balls, limits));
        return step;
    }

    /// The step under a drive, without regard to regions.
    template<class N>
    static RegionStep<N> rollBy(const Planar<N> &A, const BallsInRegion<N> &balls, const RegionLimits &limits) {
        const double h = limits.h;
        const FloorDrive<N> &drive = balls.drive;
        const Planar<N> velocity = balls.velocity();
        // From nearStop. Balls that are left to the general case get finite substitutes.
        const N speedSquared = dot(velocity, velocity), driveLength = length(A);
        const N stop = choose(drive.B < driveLength, 1.0, 4.0) * (driveLength + drive.B) * h;
        const auto goesOn = kResists                        ? speedSquared > stop * stop
                            : kRule == RegionRule::Substeps ? speedSquared >= 0.0
                                                            : speedSquared > 0.0;
        const Planar<N> v{choose(goesOn, velocity.x, 1.0), choose(goesOn, velocity.y, 0.0)};
        const auto next = Scheme::advance(UnstoppedLaw<N, kResists>{A, drive.B}, v, h);

        MaskOf<N> isFine = all(goesOn, balls.drive.isAllowed());
        if (limits.mayGrip)
            isFine = all(isFine, dot(drive.pull, drive.pull) <= balls.grip * (drive.normal * drive.normal));
        return {next.velocity, next.displacement, isFine};
    }

    /// Whether a ball moves by at most `most` (m).
    template<class N>
    static MaskOf<N> isSlow(const BallsInRegion<N> &balls, N most, double h) {
        if constexpr (kRule == RegionRule::Swept) return reach(balls, h) <= most;
        // From reachOfStep, comparing squares.
        const double hSquared = h * h;
        const N farthest = most - hSquared * pull(balls);
        return all(farthest > 0.0, hSquared * dot(balls.velocity(), balls.velocity()) <= farthest * farthest);
    }

    /// An upper bound of what may accelerate the ball, m/s^2.
    template<class N>
    static N pull(const BallsInRegion<N> &balls) {
        const FloorDrive<N> &drive = balls.drive;
        return magnitude(drive.pull.x) + magnitude(drive.pull.y) + balls.friction * drive.normal;
    }

    /// An upper bound of a ball's displacement, m.
    template<class N>
    static N wayOf(const RegionStep<N> &step) {
        return magnitude(step.displacement.x) + magnitude(step.displacement.y);
    }

    /// An upper bound of how far a ball can move, m.
    template<class N>
    static N reach(const BallsInRegion<N> &balls, double h) {
        return (magnitude(balls.x.velocity) + magnitude(balls.y.velocity) + pull(balls) * h) * h;
    }

    /// Whether a step ends neither nearly at rest nor in the opposite direction.
    template<class N>
    static MaskOf<N> staysFast(const RegionLimits &limits, const Planar<N> &velocity, const Planar<N> &next) {
        const auto isFast = dot(next, next) > limits.restSquared;
        if constexpr (kRule == RegionRule::Substeps) return isFast;
        return all(isFast, dot(next, velocity) > 1.1e-9 * dot(velocity, velocity));
    }

    /// Whether it must be checked that a ball stays on the floor: there is nothing else, or the step is long; from
    /// mayFallOffFloor.
    template<class N>
    static bool mayFall(const BallsInRegion<N> &balls, const RegionLimits &limits) {
        if (limits.isOpen) return true;
        if constexpr (kRule == RegionRule::Swept) return false;
        return bitsOf(balls.drive.normal * (limits.h * limits.h) > limits.reach) != 0;
    }

    template<class N>
    static MaskOf<N> staysOnFloor(const BallsInRegion<N> &balls, const RegionLimits &limits) {
        const N way = reach(balls, limits.h);
        return all(balls.x.isFreeAround(way), balls.y.isFreeAround(way));
    }
};

} // namespace phys
