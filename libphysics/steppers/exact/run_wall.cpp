// SPDX-License-Identifier: MIT
// The rigid model at a wall where friction acts: on a face or an edge, smooth or rough, on the floor or in the air.
// model.md 6.5.
#include "run.h"

#include "arc.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// Parts that the turn of a curved way is made of, for drawing.
constexpr int kTurnParts = 16;

/// Least unit of acceleration, in units of the speed per second: less changes no speed in any step, and the time and
/// the length that go with it would overflow.
constexpr double kLeastAcceleration = 0x1p-400;

/// Least unit of speed, in units of that of a fall through a radius: where a slip ends all speeds may be zero.
constexpr double kLeastSpeed = 1e-18;

/// A slip below this, in least units of speed, is none: its square would underflow. No slip starts that small.
constexpr double kLeastSlip = 0x1p-60;

void scale(WallState &now, double speed, double acceleration) {
    for (double *value : {&now.along, &now.up, &now.floorSlip, &now.wallSlip, &now.wallSlipUp}) *value *= speed;
    for (double *value : {&now.gravityAcross, &now.gravityAlong}) *value *= acceleration;
}

} // namespace

/// Whether friction acts between the ball and what holds it.
bool Run::isRough(const Hold &hold) const {
    if (isRolling() || m_params.wall_friction == 0.0 || hold.kind == Hold::Kind::none) return false;
    return glm::dot(toVec(m_params.gravity), hold.touch.normal) < 0.0;
}

double Run::unitOfAcceleration() const {
    const phys_vec3 &g = m_params.gravity;
    return unitOf(length({length(inPlane(g)), g.z}));
}

double Run::leastSpeed() const { return kLeastSpeed * std::sqrt(unitOfAcceleration() * m_board.radius()); }

Run::Units Run::unitsFor(double fastest) const {
    const double acceleration = unitOfAcceleration();
    const double fall = std::sqrt(acceleration * m_board.radius());
    const double speed = unitOf(fastest > 0.0 ? std::max(fastest, leastSpeed()) : fall);
    return {speed, std::max(acceleration, kLeastAcceleration * speed)};
}

/// The ball as a wall with that normal sees it.
WallState Run::seenFrom(const Vec2 &normal) const {
    const double R = m_board.radius();
    const Vec3 &spin = m_ball.spin;
    const Vec2 along{-normal.y, normal.x};
    WallState now;
    now.along = glm::dot(inPlane(m_ball.velocity), along);
    now.up = m_floor ? 0.0 : m_ball.velocity.z;
    now.floorSlip = now.along + R * glm::dot(inPlane(spin), normal);
    now.wallSlip = now.along - R * spin.z;
    now.wallSlipUp = now.up + R * glm::dot(inPlane(spin), along);
    now.gravityAcross = glm::dot(inPlane(m_params.gravity), normal);
    now.gravityAlong = glm::dot(inPlane(m_params.gravity), along);
    return now;
}

/// The same with what friction does at each contact. Slips that are no more than rounding are none.
Run::AtWall Run::lookAtWall(const Hold &hold) const {
    const double R = m_board.radius();
    const Vec2 normal = inPlane(hold.touch.normal);
    AtWall wall{{normal, {-normal.y, normal.x}}, {}, {}, seenFrom(normal)};
    WallState &now = wall.now;
    const double rounding = std::max(now.rounding(), kLeastSlip * leastSpeed());
    const bool slipsOnFloor = slipVelocity() != Vec2(0.0) && length({now.floorSlip, now.wallSlipUp}) > rounding;
    const bool rollsOnFloor = m_floor && !slides() && !slipsOnFloor;
    if (std::abs(now.up) <= rounding && std::abs(now.wallSlipUp) <= rounding) now.up = now.wallSlipUp = 0.0;
    if (rollsOnFloor) now.floorSlip = now.wallSlipUp = 0.0;
    const bool rollsOnWall = length({now.wallSlip, now.wallSlipUp}) <= rounding;
    if (rollsOnWall) now.wallSlip = now.wallSlipUp = 0.0;

    wall.units = unitsFor(std::max({std::abs(now.along), std::abs(now.up), std::abs(now.floorSlip),
                                    std::abs(now.wallSlip), std::abs(now.wallSlipUp)}));
    scale(now, 1.0 / wall.units.speed, 1.0 / wall.units.acceleration);
    WallLaw &law = wall.law;
    law.weight = -m_params.gravity.z / wall.units.acceleration;
    law.floorFriction = m_params.sliding_friction;
    law.wallFriction = m_params.wall_friction;
    if (hold.kind == Hold::Kind::edge) law.curvature = wall.units.length() / R;
    if (m_floor) law.floor = slides() ? Grip::smooth : rollsOnFloor ? Grip::rolls : Grip::slips;
    if (law.wallFriction > 0.0) law.wall = rollsOnWall ? Grip::rolls : Grip::slips;
    if (settleGrips(law, now, m_params.rolling_friction * law.weight)) wall.axes.along = -wall.axes.along;
    return wall;
}

/// Until the ball leaves the wall or the floor, stops, changes its grip or meets something, or the series end.
phys_status Run::stayAtWall(const Hold &hold) {
    const AtWall wall = lookAtWall(hold);
    const WallMotion motion(wall.law, wall.now);
    if (isSpent(motion.wallForce, 1.0)) return letGo();
    if (m_floor && isSpent(motion.floorForce, 1.0)) {
        takeOff();
        return PHYS_OK;
    }
    WallEnd end = endAtWall(hold, wall, motion);
    if (meetsEnds(wall, motion, end.s))
        return refuse("the ball flies along it beside the top or bottom of another wall", hold.touch);
    const double reach = motion.way.at(end.s) * wall.units.length();
    const WallWay way = wayAlong(hold, wall, reach);
    if (way.end != WallWay::End::none) {
        const bool isBlocked = wall.now.along == 0.0 && way.length <= m_board.tolerance();
        if (isBlocked && way.end == WallWay::End::touch) return stayInCorner(hold);
        const double s = firstFall(remains(way.length / wall.units.length(), motion.way), end.s);
        end = {std::min(end.s, s), WallEnd::Cause::way};
    }
    follow(hold, wall, motion, end, way);
    return PHYS_OK;
}

/// Where the motion itself ends the phase, and why.
Run::WallEnd Run::endAtWall(const Hold &hold, const AtWall &wall, const WallMotion &motion) const {
    using enum WallEnd::Cause;
    const WallLaw &law = wall.law;
    const double left = m_left / wall.units.time();
    WallEnd end{motion.goodFor(), series};
    if (!motion.slipsTurn()) end.s = std::min(end.s, left);     // s is the time
    if (std::isinf(end.s)) end.s = 2.0 * left / motion.time[1]; // nothing but the time changes
    end.cut(remains(left, motion.time), time);
    end.cut(motion.wallForce, force);
    end.cut(motion.along, stop);
    if (law.wall == Grip::rolls) end.cut(motion.wallReserve, force);
    if (law.wall == Grip::slips && law.isStraight) end.cut(law.wallSense * motion.wallSlip.along, wallRolls);
    if (!m_floor) cutFall(end, motion.height, wall.units.length(), hold.touch.normal);
    if (m_floor) end.cut(motion.floorForce, force);
    if (law.floor == Grip::rolls) end.cut(motion.floorReserve, force);
    if (law.floor == Grip::slips && law.isStraight) end.cut(law.floorSense * motion.floorSlip.along, floorRolls);
    return end;
}

void Run::WallEnd::cut(const Taylor &f, Cause why) {
    const double first = firstFall(f, s);
    if (first > s) return;
    s = first;
    cause = why;
}

/// In the air: where the ball lands, or passes the upper or lower end of what it touches with that normal.
void Run::cutFall(WallEnd &end, const Taylor &height, double unit, const Vec3 &normal) const {
    const Scene &scene = m_board.scene();
    const double z = m_ball.position.z;
    const Heights heights = m_board.heights(m_ball.position, normal);
    end.cut(remains((heights.high - z) / unit, height), WallEnd::Cause::force);
    end.cut(remains((z - heights.low) / unit, -1.0 * height), WallEnd::Cause::force);
    const bool isAbove = z > scene.supportedZ || (z == scene.supportedZ && m_ball.velocity.z > 0.0);
    if (!scene.hasFloor || !isAbove) return;
    end.cut(remains((z - scene.supportedZ) / unit, -1.0 * height), WallEnd::Cause::landing);
}

/// In the air what is in the way is searched at one height: whether a solid near it has an end at those that the ball
/// passes.
bool Run::meetsEnds(const AtWall &wall, const WallMotion &motion, double end) const {
    if (m_floor) return false;
    const double R = m_board.radius(), z = m_ball.position.z, unit = wall.units.length();
    double low = z, high = z;
    const bool falls = motion.up[0] < 0.0 || (motion.up[0] == 0.0 && motion.up[1] < 0.0);
    for (const double s : {end, firstFall(falls ? -1.0 * motion.up : motion.up, end)}) {
        if (s > end) continue;
        low = std::min(low, z + unit * motion.height.at(s));
        high = std::max(high, z + unit * motion.height.at(s));
    }
    const Vec2 reach(R + m_board.tolerance() + unit * motion.way.at(end)), p = inPlane(m_ball.position);
    for (const uint32_t solid : m_board.near(p - reach, p + reach)) {
        const phys_box &box = m_board.scene().solids[solid];
        const bool reaches = box.max.z + R > low && box.min.z - R < high;
        const bool covers = box.min.z <= low + m_board.tolerance() && box.max.z >= high - m_board.tolerance();
        if (reaches && !covers) return true;
    }
    return false;
}

Run::WallWay Run::wayAlong(const Hold &hold, const AtWall &wall, double reach) {
    if (reach == 0.0) return {0.0, WallWay::End::none, 0.0};
    return hold.kind == Hold::Kind::face ? wayOnFace(hold, wall, reach) : wayOnEdge(hold, wall, reach);
}

/// What is in the way along a face within `reach`. A straight way is searched as one at unit speed.
Run::WallWay Run::wayOnFace(const Hold &hold, const AtWall &wall, double reach) {
    using enum WallWay::End;
    const Motion motion = Motion::parabola(m_ball.position, Vec3(wall.axes.along, 0.0), Vec3(0.0), reach);
    WallWay way{reach, none, 0.0};
    const FaceWay face = alongFace(hold.plane, motion, reach);
    if (face.ends) way = {face.until, contour, face.end};
    if (m_floor) {
        const double exit = firstExit(m_board.scene().floors[*m_floor], motion, 0.0, way.length, m_board.tolerance());
        if (exit <= way.length) way = {exit, floor, 0.0};
    }
    const double met = m_sweep.firstTouch(motion, way.length, &hold.plane);
    if (met <= way.length) way = {met, WallWay::End::touch, 0.0};
    return way;
}

/// The same round an edge.
Run::WallWay Run::wayOnEdge(const Hold &hold, const AtWall &wall, double reach) {
    using enum WallWay::End;
    const double R = m_board.radius();
    const EdgeArc arc{hold.corner, wall.axes.normal, wall.axes.along, R, m_ball.position.z};
    WallWay way{reach, none, 0.0};
    const double quarter = R * quarterEnd(arc).angle;
    if (quarter <= way.length) way = {quarter, contour, 0.0};
    if (m_floor) {
        const phys_box &box = m_board.scene().floors[*m_floor];
        const double exit = R * firstExitOnArc(box, arc, way.length / R, m_board.tolerance());
        if (exit <= way.length) way = {exit, floor, 0.0};
    }
    const double met = R * firstTouchOnArc(m_board, arc, way.length / R);
    if (met <= way.length) way = {met, WallWay::End::touch, 0.0};
    return way;
}

/// Puts the ball where the motion is at its end, with its speeds, and counts what it has cost.
void Run::follow(const Hold &hold, const AtWall &wall, const WallMotion &motion, const WallEnd &end,
                 const WallWay &way) {
    const double before = glm::length(m_ball.velocity);
    const bool atWayEnd = end.cause == WallEnd::Cause::way;
    const double length = atWayEnd ? way.length : motion.way.at(end.s) * wall.units.length();
    const double t = end.cause == WallEnd::Cause::time ? m_left : motion.time.at(end.s) * wall.units.time();
    m_report.lostSlip(motion.heat.at(end.s) * wall.units.speed * wall.units.speed);
    if (wall.law.floor == Grip::rolls) m_report.lostRolling(m_params.rolling_friction * -m_params.gravity.z * length);
    turnAtWall(hold, wall, motion, end.s);

    WallState now = motion.at(end.s);
    if (end.cause == WallEnd::Cause::stop) now.along = 0.0;
    const bool rolls = settleSlips(wall.law, end.cause, leastSpeed() / wall.units.speed, wall.now, now);
    scale(now, wall.units.speed, wall.units.acceleration);
    const WallAxes axes = axesAfter(hold, wall, length, atWayEnd && way.end == WallWay::End::contour);
    if (hold.kind == Hold::Kind::edge) {
        if (length > 0.0) m_ball.position = {hold.corner + m_board.radius() * axes.normal, m_ball.position.z};
    } else {
        m_ball.position += length * Vec3(axes.along, 0.0);
        if (atWayEnd && way.end == WallWay::End::contour) m_ball.position[1 - hold.plane.axis] = way.coordinate;
    }
    m_ball.velocity = {now.along * axes.along, now.up};
    m_ball.spin = spinAtWall(wall.law, now, axes);
    if (wall.law.floor == Grip::rolls || rolls) roll();
    if (atWayEnd && way.end == WallWay::End::floor)
        snapToBorder(m_board.scene().floors[*m_floor], m_board.tolerance(), m_ball.velocity, m_ball.position);
    if (!m_floor) m_ball.position.z += motion.height.at(end.s) * wall.units.length();
    if (end.cause == WallEnd::Cause::landing) m_ball.position.z = m_board.scene().supportedZ;
    m_meets = end.cause == WallEnd::Cause::landing || (atWayEnd && way.end == WallWay::End::touch);
    spend(t);

    const double after = glm::length(m_ball.velocity);
    if (rolls) event(PHYS_EVENT_ROLL, after, after);
    if (wall.law.floor == Grip::rolls && before > 0.0 && after == 0.0) event(PHYS_EVENT_STOP, before, 0.0);
}

/// A slip that has come to its end is zero exactly. True if that of the floor has.
bool Run::settleSlips(const WallLaw &law, WallEnd::Cause cause, double smallest, const WallState &before,
                      WallState &now) {
    const double rounding = now.rounding() + smallest;
    const auto ends = [&](Grip grip, WallEnd::Cause ending, const Vec2 &first, const Vec2 &last) {
        const bool fades = length(last) <= rounding && length(last) < length(first); // not one that has just started
        return grip == Grip::slips && (cause == ending || fades);
    };
    const bool floorRolls =
        ends(law.floor, WallEnd::Cause::floorRolls, {before.floorSlip, before.shared()}, {now.floorSlip, now.shared()});
    const bool wallRolls =
        ends(law.wall, WallEnd::Cause::wallRolls, {before.wallSlip, before.wallSlipUp}, {now.wallSlip, now.wallSlipUp});
    if (floorRolls) now.floorSlip = 0.0;
    if (wallRolls) now.wallSlip = 0.0;
    if (wallRolls) now.wallSlipUp = 0.0;
    if (floorRolls) now.wallSlipUp = now.up;
    return floorRolls;
}

/// The wall's axes after a way: on an edge they turn with it.
Run::WallAxes Run::axesAfter(const Hold &hold, const AtWall &wall, double length, bool atContour) const {
    if (hold.kind == Hold::Kind::face) return wall.axes;
    const EdgeArc arc{hold.corner, wall.axes.normal, wall.axes.along, m_board.radius(), m_ball.position.z};
    const QuarterEnd quarter = quarterEnd(arc);
    if (atContour) return {quarter.normal, quarter.tangent};
    const double angle = length / m_board.radius();
    return {arc.normalAt(angle), arc.tangentAt(angle)};
}

Vec3 Run::spinAtWall(const WallLaw &law, const WallState &now, const WallAxes &axes) const {
    // Seen in a mirror if along is against z x n: a spin's part in the mirror's plane changes its sign there.
    const Vec2 level{-axes.normal.y, axes.normal.x};
    const double hand = glm::dot(level, axes.along) < 0.0 ? -1.0 : 1.0;
    const Vec2 spin = hand * (now.floorSlip - now.along) * axes.normal + (now.wallSlipUp - now.up) * level;
    const double upright = hand * (now.along - now.wallSlip) / m_board.radius();
    return {spin / m_board.radius(), law.wall == Grip::smooth ? m_ball.spin.z : upright};
}

/// For drawing: the turn put together from parts.
void Run::turnAtWall(const Hold &hold, const AtWall &wall, const WallMotion &motion, double end) {
    if (!(m_params.options & PHYS_OPTION_ORIENTATION)) return;
    double before = 0.0;
    for (int part = 0; part < kTurnParts; ++part) {
        const double middle = end * (part + 0.5) / kTurnParts;
        WallState now = motion.at(middle);
        scale(now, wall.units.speed, wall.units.acceleration);
        const WallAxes axes = axesAfter(hold, wall, motion.way.at(middle) * wall.units.length(), false);
        const double time = motion.time.at(end * (part + 1) / kTurnParts) * wall.units.time();
        turn((time - before) * spinAtWall(wall.law, now, axes));
        before = time;
    }
}

/// The wall presses no longer: the ball goes on freely.
phys_status Run::letGo() {
    noteHold(Hold{});
    const Vec2 u = slipVelocity();
    if (m_ball.supported && (u != Vec2(0.0) || !gripHolds(Hold{}))) return slipFreely(u);
    return moveFreely(Hold{});
}

} // namespace phys
