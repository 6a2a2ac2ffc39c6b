// SPDX-License-Identifier: MIT
#include "wall_grip.h"

namespace phys {

namespace {

/// A slip that only starts, in units of the speeds if these are all zero.
constexpr double kStart = 16.0 * kRounding;

/// Below this, relative to the numbers it is the difference of, what falls is spent: model.md 8.
constexpr double kSpent = 1e-13;

constexpr int kProbe = 4; // terms that tell the direction of a start from rest

double senseOf(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; }

struct Direction {
    double aside, along;
};

/// Direction e and rate r in which a slip starts that friction can't prevent: r e = D - mu N (m_1 e_1, m_2 e_2), where
/// the static friction that would hold it is -(D_1/m_1, D_2/m_2). |e| falls as r grows.
Direction startOfSlip(double aside, double along, double asideRate, double alongRate, double most) {
    const double drives[] = {-asideRate * aside, -alongRate * along};
    const auto at = [&](double r) -> Direction {
        return {drives[0] / (r + asideRate * most), drives[1] / (r + alongRate * most)};
    };
    double low = 0.0, high = std::abs(drives[0]) + std::abs(drives[1]);
    for (int halving = 0; halving < 60; ++halving) {
        const double r = 0.5 * (low + high);
        const Direction e = at(r);
        (e.aside * e.aside + e.along * e.along > 1.0 ? low : high) = r;
    }
    const Direction e = at(high);
    const double size = length({e.aside, e.along});
    return {e.aside / size, e.along / size};
}

void mirror(WallLaw &law, WallState &now) {
    for (double *value : {&now.along, &now.floorSlip, &now.wallSlip, &now.gravityAlong, &law.resistance,
                          &law.floorSense, &law.wallSense})
        *value = -*value;
}

void describe(WallLaw &law, const WallState &now) {
    const bool isLevel = law.floor != Grip::none && now.wallSlipUp == now.up;
    law.isStraight = isLevel && (law.curvature == 0.0 || law.floor == Grip::rolls || law.wall == Grip::rolls);
    if (now.floorSlip != 0.0) law.floorSense = senseOf(now.floorSlip);
    if (now.wallSlip != 0.0) law.wallSense = senseOf(now.wallSlip);
}

/// Resistance is against the motion, or holds the ball: model.md 2.1 R4. True if along was turned round.
bool orient(WallLaw &law, WallState &now, double resistance) {
    law.resistance = 0.0;
    const WallMotion free(law, now, kProbe);
    double sense = 0.0;
    for (int k = 0; k <= kProbe && sense == 0.0; ++k) sense = senseOf(free.along[k]);
    if (sense < 0.0) mirror(law, now);
    if (law.floor == Grip::rolls) {
        const double push = law.wall == Grip::rolls ? 0.0 : sense * free.wallPush.along[0];
        law.resistance = now.along > 0.0 ? resistance : std::min(resistance, std::abs(now.gravityAlong + push));
    }
    return sense < 0.0;
}

/// Size of a slip that only starts: just above rounding, so that it has a direction.
double startOf(const WallState &now) { return std::max(2.0 * now.rounding(), kStart); }

void startFloorSlip(WallLaw &law, WallState &now, const WallMotion &rolling) {
    law.floor = Grip::slips;
    law.floorSense = -senseOf(rolling.floorPush.along[0]);
    const double start = startOf(now);
    now.floorSlip = start * law.floorSense;
    if (law.curvature == 0.0 || law.wall == Grip::rolls) return;
    const double most = law.floorFriction * rolling.floorForce[0];
    const Direction e = startOfSlip(rolling.floorPush.aside[0], rolling.floorPush.along[0], 2.5, 3.5, most);
    now.floorSlip = start * e.along;
    now.wallSlipUp = now.up - start * e.aside;
}

void startWallSlip(WallLaw &law, WallState &now, const WallMotion &rolling) {
    law.wall = Grip::slips;
    law.wallSense = -senseOf(rolling.wallPush.along[0]);
    const double start = startOf(now);
    now.wallSlip = start * law.wallSense;
    const bool flies = law.floor == Grip::none;
    if (law.floor == Grip::rolls || (law.curvature == 0.0 && !flies)) return;
    const double most = law.wallFriction * rolling.wallForce[0];
    const Direction e = startOfSlip(rolling.wallPush.aside[0], rolling.wallPush.along[0], flies ? 3.5 : 2.5, 3.5, most);
    now.wallSlip = start * e.along;
    now.wallSlipUp = start * e.aside;
}

} // namespace

bool isSpent(const Taylor &force, double size) {
    // Falling, it is spent a moment early: what it decides about is the same before and after.
    const bool falls = force[1] < 0.0 && force[0] <= kSpent * (size - force[1]);
    return falls || force[0] < -kSpent * size;
}

bool settleGrips(WallLaw &law, WallState &now, double resistance) {
    bool turned = false;
    while (true) {
        describe(law, now);
        if (orient(law, now, resistance)) turned = !turned;
        const WallMotion motion(law, now, 2);
        const double mostOnWall = law.wallFriction * motion.wallForce[0];
        const double mostOnFloor = law.floorFriction * motion.floorForce[0];
        if (law.wall == Grip::rolls && isSpent(motion.wallReserve, mostOnWall * mostOnWall)) {
            startWallSlip(law, now, motion);
        } else if (law.floor == Grip::rolls && isSpent(motion.floorReserve, mostOnFloor * mostOnFloor)) {
            startFloorSlip(law, now, motion);
        } else {
            return turned;
        }
    }
}

} // namespace phys
