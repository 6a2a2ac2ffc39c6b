// SPDX-License-Identifier: MIT
// A step of the balls in lanes, as many at a time as a number type has (base/pair.h).
#pragma once

#include "region_step.h"
#include "registry/lanes.h"

namespace phys {

/// The lanes from one on, as many as N has numbers: balls in regions.
template<class N>
struct LanesOf {
    using Number = N;

    Lanes &lanes;
    uint32_t first;

    /// What follows from new gravity.
    void tilt(const RegionLimits &limits) const {
        const N gravityZ = of(lanes.gravityZ);
        const FloorDrive<N> drive = driveOf<N>({of(lanes.x.gravity), of(lanes.y.gravity)}, gravityZ, of(lanes.share),
                                               of(lanes.resistance), of(lanes.friction), of(lanes.grip), limits);
        set(drive.A.x, lanes.x.drive);
        set(drive.A.y, lanes.y.drive);
        set(drive.B, lanes.resisting);
        set(drive.pull, lanes.pull);
        set(drive.stop, lanes.stop);
        set(drive.slow, lanes.slow);
    }

    /// Whether a ball may fall by more than `most` (m) in a step; from mayFallOffFloor.
    bool mayFall(double most) const { return bitsOf(-(lanes.dt * lanes.dt) * of(lanes.gravityZ) > most) != 0; }

    InRegion<N> x() const { return along(lanes.x); }
    InRegion<N> y() const { return along(lanes.y); }
    FloorDrive<N> drive() const {
        const Planar<N> A{of(lanes.x.drive), of(lanes.y.drive)};
        return {A, of(lanes.resisting), of(lanes.pull), of(lanes.stop), of(lanes.slow)};
    }
    N farthest() const { return of(lanes.farthest); }

    /// Keeps the results of the balls whose step is fine. Returns a bit for each of those.
    uint32_t keep(const RegionStep<N> &step) const {
        move(step.displacement.x, step.velocity.x, step.isFine, lanes.x);
        move(step.displacement.y, step.velocity.y, step.isFine, lanes.y);
        return bitsOf(step.isFine) << first;
    }

private:
    N of(const LaneNumbers &numbers) const { return phys::load<N>(numbers + first); }
    void set(N values, LaneNumbers &numbers) const { store(values, numbers + first); }

    InRegion<N> along(const LaneAxis &axis) const {
        return {of(axis.position), of(axis.velocity), of(axis.low), of(axis.high), of(axis.lowFace), of(axis.highFace)};
    }

    void move(N displacement, N velocity, MaskOf<N> isFine, LaneAxis &along) const {
        const N place = of(along.position);
        set(choose(isFine, place + displacement, place), along.position);
        set(choose(isFine, velocity, of(along.velocity)), along.velocity);
    }
};

/// What follows from the gravity that is new in some lanes.
template<RegionRule kRule, class N>
void tilt(Lanes &lanes) {
    constexpr uint32_t kSome = (1U << kWidth<N>)-1U;
    for (uint32_t lane = 0; lane < kLaneCount; lane += kWidth<N>) {
        const LanesOf<N> some{lanes, lane};
        if ((lanes.tilted >> lane & kSome) == 0) continue;
        some.tilt({lanes.dt, lanes.reach, lanes.restSquared, lanes.mayFall});
        if (kRule == RegionRule::Substeps && some.mayFall(lanes.reach)) lanes.mayFall = true;
    }
    lanes.tilted = 0;
}

template<class Scheme, RegionRule kRule, bool kResists, class N>
uint32_t rollInLanes(Lanes &lanes) {
    const RegionLimits limits{lanes.dt, lanes.reach, lanes.restSquared, lanes.mayFall};
    uint32_t moved = 0;
    for (uint32_t lane = 0; lane < kLaneCount; lane += kWidth<N>) {
        const LanesOf<N> some{lanes, lane};
        moved |= StepInRegion<Scheme, kRule, kResists>::make(some, limits, [&](const RegionStep<N> &step) {
            if (!kLooksAhead<Scheme> || !lanes.looksAhead) return some.keep(step);
            const auto isFine = all(step.isFine, isFreeAhead(some, lanes.dt, step.velocity));
            return some.keep({step.velocity, step.displacement, isFine});
        });
    }
    return moved;
}

/// LaneSteps::step.
template<class Scheme, RegionRule kRule, class N>
uint32_t stepInLanes(Lanes &lanes) {
    if (lanes.tilted) tilt<kRule, N>(lanes);
    return lanes.resists ? rollInLanes<Scheme, kRule, true, N>(lanes) : rollInLanes<Scheme, kRule, false, N>(lanes);
}

} // namespace phys
