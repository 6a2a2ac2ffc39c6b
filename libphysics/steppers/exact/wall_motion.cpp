// SPDX-License-Identifier: MIT
#include "wall_motion.h"

namespace phys {

namespace {

/// What the series leave out, in the units of the speeds; of a slip that may turn, relative to its size.
constexpr double kLeftOut = 1e-17;

double constantTerm(double value, int k) { return k == 0 ? value : 0.0; }

} // namespace

double WallState::rounding() const {
    const double surface = length({length({floorSlip - along, wallSlipUp - up}), along - wallSlip}); // R |om|
    return kRolls * (length({along, up}) + surface);
}

WallMotion::WallMotion(const WallLaw &law, const WallState &now, int order)
    : m_law(law) {
    along[0] = now.along;
    up[0] = now.up;
    floorSlip.along[0] = now.floorSlip;
    wallSlip.along[0] = now.wallSlip;
    wallSlip.aside[0] = now.wallSlipUp;
    m_gravity.aside[0] = now.gravityAcross;
    m_gravity.along[0] = now.gravityAlong;
    for (int k = 0; k < order; ++k) {
        extendSlips(k);
        extendForces(k);
        extendReserves(k);
        extendRates(k);
        extendMotion(k);
    }
}

void WallMotion::Direction::extend(const Pair &slip, int k) {
    square[k] = productTerm(slip.aside, slip.aside, k) + productTerm(slip.along, slip.along, k);
    speed[k] = k == 0 ? std::sqrt(square[0]) : rootTerm(square, speed, k);
    unit.aside[k] = quotientTerm(slip.aside, speed, unit.aside, k);
    unit.along[k] = quotientTerm(slip.along, speed, unit.along, k);
}

void WallMotion::Direction::keep(const Pair &slip, double sense, int k) {
    speed[k] = sense * slip.along[k];
    unit.along[0] = sense;
}

/// Term k of what follows from the motion alone. dt/ds is the size of the slip, of two slips r1 r2/(r1 + r2): so no
/// rate has a slip below the fraction line.
void WallMotion::extendSlips(int k) {
    m_turning[k] = m_law.curvature * along[k];
    m_spinAcross[k] = floorSlip.along[k] - along[k];
    m_spinAlong[k] = wallSlip.aside[k] - up[k];
    floorSlip.aside[k] = -m_spinAlong[k];
    m_pressing[k] = -m_gravity.aside[k] - productTerm(m_turning, along, k);

    const bool floorSlips = m_law.floor == Grip::slips, wallSlips = m_law.wall == Grip::slips;
    if (m_law.isStraight) {
        if (floorSlips) m_onFloor.keep(floorSlip, m_law.floorSense, k);
        if (wallSlips) m_onWall.keep(wallSlip, m_law.wallSense, k);
        m_clock[k] = constantTerm(1.0, k);
        return;
    }
    if (floorSlips) m_onFloor.extend(floorSlip, k);
    if (wallSlips) m_onWall.extend(wallSlip, k);
    if (floorSlips && wallSlips) {
        m_product[k] = productTerm(m_onFloor.speed, m_onWall.speed, k);
        m_sum[k] = m_onFloor.speed[k] + m_onWall.speed[k];
        m_clock[k] = quotientTerm(m_product, m_sum, m_clock, k);
    } else {
        m_clock[k] = floorSlips ? m_onFloor.speed[k] : wallSlips ? m_onWall.speed[k] : constantTerm(1.0, k);
    }
}

/// Term k of the forces. Along n: wallForce = pressing - floorPush. Upwards: floorForce = weight - wallPush.
void WallMotion::extendForces(int k) {
    const double mu = m_law.floorFriction, muWall = m_law.wallFriction;
    const Grip floor = m_law.floor, wall = m_law.wall;
    const double weight = constantTerm(m_law.weight, k);
    const double carried = productTerm(m_turning, m_spinAcross, k); // turning of the spin along
    const double gravity = m_gravity.along[k];

    // What of the wall's friction doesn't depend on its force.
    if (wall == Grip::rolls && floor == Grip::none) wallPush.aside[k] = 2.0 / 7.0 * (weight + carried);
    if (wall == Grip::rolls && (floor == Grip::slips || floor == Grip::smooth)) wallPush.aside[k] = 0.4 * carried;

    // Normal forces: two equations where the slips couple them.
    if (floor == Grip::slips && wall == Grip::slips) {
        const Taylor &across = m_onFloor.unit.aside, &upwards = m_onWall.unit.aside;
        m_determinant[k] = constantTerm(1.0, k) - mu * muWall * productTerm(across, upwards, k);
        m_weight[k] = weight + muWall * productTerm(upwards, m_pressing, k);
        floorForce[k] = quotientTerm(m_weight, m_determinant, floorForce, k);
    } else if (floor == Grip::slips || floor == Grip::rolls) {
        floorForce[k] = weight - wallPush.aside[k];
    }
    if (floor == Grip::slips) {
        floorPush.aside[k] = -mu * productTerm(m_onFloor.unit.aside, floorForce, k);
        floorPush.along[k] = -mu * productTerm(m_onFloor.unit.along, floorForce, k);
    }
    // Rolling on the floor, the spin turns with the way.
    if (floor == Grip::rolls) floorPush.aside[k] = -0.4 * carried;
    wallForce[k] = m_pressing[k] - floorPush.aside[k];

    if (wall == Grip::slips) {
        wallPush.aside[k] = -muWall * productTerm(m_onWall.unit.aside, wallForce, k);
        wallPush.along[k] = -muWall * productTerm(m_onWall.unit.along, wallForce, k);
    }
    const double resisted = gravity - constantTerm(m_law.resistance, k);
    if (wall == Grip::rolls && floor == Grip::rolls) wallPush.along[k] = -2.0 / 9.0 * resisted;
    if (wall == Grip::rolls && floor != Grip::rolls) wallPush.along[k] = -2.0 / 7.0 * (gravity + floorPush.along[k]);
    if (floor == Grip::smooth) floorForce[k] = weight - wallPush.aside[k];
}

/// Term k of what static friction has left. The floor's is judged without the rolling resistance: model.md 2.2 F2.
void WallMotion::extendReserves(int k) {
    const auto reserve = [k](double friction, const Taylor &force, const Pair &push) {
        const double most = friction * friction * productTerm(force, force, k);
        return most - productTerm(push.aside, push.aside, k) - productTerm(push.along, push.along, k);
    };
    const double gravity = m_gravity.along[k];
    if (m_law.floor == Grip::rolls) {
        const bool both = m_law.wall == Grip::rolls;
        floorPush.along[k] = both ? -2.0 / 9.0 * gravity : -2.0 / 7.0 * (gravity + wallPush.along[k]);
        floorReserve[k] = reserve(m_law.floorFriction, floorForce, floorPush);
    }
    if (m_law.wall == Grip::rolls) wallReserve[k] = reserve(m_law.wallFriction, wallForce, wallPush);
}

/// Term k of the accelerations, model.md 6.5.
void WallMotion::extendRates(int k) {
    const bool rollsOnFloor = m_law.floor == Grip::rolls, rollsOnWall = m_law.wall == Grip::rolls;
    const double gravity = m_gravity.along[k], resistance = constantTerm(m_law.resistance, k);
    Rates &rates = m_rates;
    rates.along[k] = gravity + floorPush.along[k] + wallPush.along[k];
    if (rollsOnFloor) rates.along[k] = 5.0 / 7.0 * (gravity + wallPush.along[k] - resistance);
    if (rollsOnFloor && rollsOnWall) rates.along[k] = 5.0 / 9.0 * (gravity - resistance);
    if (m_law.floor == Grip::none) rates.up[k] = wallPush.aside[k] - constantTerm(m_law.weight, k);

    if (!rollsOnFloor)
        rates.floorSlip[k] = rates.along[k] + 2.5 * floorPush.along[k] + productTerm(m_turning, m_spinAlong, k);
    if (!rollsOnWall) rates.wallSlip[k] = rates.along[k] + 2.5 * wallPush.along[k];
    if (!rollsOnFloor && !rollsOnWall) {
        const double carried = productTerm(m_turning, m_spinAcross, k);
        rates.wallSlipUp[k] = rates.up[k] + 2.5 * (wallPush.aside[k] - floorPush.aside[k]) - carried;
    }
    rates.gravityAcross[k] = productTerm(m_turning, m_gravity.along, k);
    rates.gravityAlong[k] = -productTerm(m_turning, m_gravity.aside, k);
    rates.heat[k] = m_law.floorFriction * productTerm(floorForce, m_onFloor.speed, k) +
                    m_law.wallFriction * productTerm(wallForce, m_onWall.speed, k);
}

/// Term k + 1 of what moves: rates times the clock, integrated.
void WallMotion::extendMotion(int k) {
    const double share = 1.0 / (k + 1);
    const auto integral = [&](const Taylor &rate) { return share * productTerm(m_clock, rate, k); };
    time[k + 1] = share * m_clock[k];
    way[k + 1] = integral(along);
    height[k + 1] = integral(up);
    heat[k + 1] = integral(m_rates.heat);
    along[k + 1] = integral(m_rates.along);
    up[k + 1] = integral(m_rates.up);
    floorSlip.along[k + 1] = integral(m_rates.floorSlip);
    wallSlip.along[k + 1] = integral(m_rates.wallSlip);
    wallSlip.aside[k + 1] = integral(m_rates.wallSlipUp);
    m_gravity.aside[k + 1] = integral(m_rates.gravityAcross);
    m_gravity.along[k + 1] = integral(m_rates.gravityAlong);
}

double WallMotion::goodFor() const {
    const double slip = std::min(m_law.isStraight || m_law.floor != Grip::slips ? 1.0 : m_onFloor.speed[0],
                                 m_law.isStraight || m_law.wall != Grip::slips ? 1.0 : m_onWall.speed[0]);
    double s = kNever;
    for (const Taylor *series : {&time, &way, &heat, &along, &up, &m_gravity.aside, &m_gravity.along})
        s = std::min(s, series->goodFor(kLeftOut));
    for (const Taylor *series : {&floorSlip.along, &wallSlip.along, &wallSlip.aside})
        s = std::min(s, series->goodFor(kLeftOut * slip));
    return s;
}

WallState WallMotion::at(double s) const {
    return {along.at(s),           up.at(s),
            floorSlip.along.at(s), wallSlip.along.at(s),
            wallSlip.aside.at(s),  m_gravity.aside.at(s),
            m_gravity.along.at(s)};
}

} // namespace phys
