// SPDX-License-Identifier: MIT
// The smooth phases between two events: free, along a face, round an edge, at rest. model.md 3, 6, 7.
#include "run.h"

#include "arc.h"
#include "pivot.h"
#include "shared/law.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// Rotation vector of a ball that rolls by `way`: z x way / R.
Vec3 rolledTurn(const Vec3 &way, double radius) { return rollingSpin(inPlane(way), radius); }

/// Parts that the turn of a curved way is made of, for drawing.
constexpr int kTurnParts = 16;

/// More would be a ball that slips past: what it hits it comes within rounding of in a few dozen.
constexpr uint32_t kMostLevelTouches = 100;

} // namespace

Drive Run::drive() const {
    if (!m_ball.supported) return {toVec(m_params.gravity), 0.0};
    if (slides()) return {Vec3(inPlane(m_params.gravity), 0.0), 0.0};
    const Law<Vec2> law = rollingLaw(m_params);
    return {Vec3(law.A, 0.0), law.B};
}

phys_status Run::phase() {
    Ball &ball = m_ball;
    m_cornered = false;
    m_floor = ball.supported ? m_board.floorUnder(ball.position, inPlane(ball.velocity)) : std::nullopt;
    if (ball.supported && !m_floor) {
        takeOff();
        return PHYS_OK;
    }
    if (slipVelocity() != Vec2(0.0)) return slip();
    const Drive acting = drive();
    Hold hold;
    if (ball.velocity != Vec3(0.0)) hold = holdMoving(m_board, m_touches, ball.position, ball.velocity, acting);
    if (ball.velocity == Vec3(0.0)) {
        hold = holdResting(m_board, m_touches, ball.position, acting);
        const bool rubs = isRough(hold) && ball.spin != Vec3(0.0);
        if (rubs && ball.supported) return hold.kind == Hold::Kind::wedged ? stayInCorner(hold) : stayAtWall(hold);
        const bool isWedged = hold.kind == Hold::Kind::wedged && (ball.supported || hold.touch.normal.z != 0.0);
        if (isWedged || (hold.kind != Hold::Kind::wedged && hold.start <= acting.B)) return rest(hold);
    }
    if (ball.supported && passesBorder(hold)) {
        takeOff();
        return PHYS_OK;
    }
    noteHold(hold);
    if (hold.kind == Hold::Kind::wedged) return stayInCorner(hold);
    const bool isHeld = hold.kind == Hold::Kind::face || hold.kind == Hold::Kind::edge;
    const bool grips = !ball.supported || gripHolds(hold);
    if (isHeld && (isRough(hold) || !grips)) return stayAtWall(hold);
    if (!grips) return slip();
    switch (hold.kind) {
    case Hold::Kind::face:
        return slideOnFace(hold);
    case Hold::Kind::edge:
        return pivotOnEdge(hold);
    case Hold::Kind::beyond:
        return refuse("the ball stays in contact with its top or bottom", hold.touch);
    default:
        return moveFreely(hold);
    }
}

/// Whether a ball on its floor's border, across which it doesn't move yet, is pulled over it.
bool Run::passesBorder(const Hold &hold) const {
    if (hold.kind == Hold::Kind::edge) return false;
    const Vec2 v = inPlane(m_ball.velocity);
    Vec2 way = v == Vec2(0.0) ? inPlane(hold.direction) : v;
    for (int axis = 0; axis < 2; ++axis) {
        const bool isFree = hold.kind != Hold::Kind::face || hold.plane.axis != axis;
        if (way[axis] == 0.0 && isFree) way[axis] = drive().A[axis];
    }
    return !m_board.floorUnder(m_ball.position, way);
}

bool Run::isAtRest() {
    if (m_ball.velocity != Vec3(0.0) || !m_ball.supported || slipVelocity() != Vec2(0.0)) return false;
    m_board.findTouches(m_ball.position, m_touches);
    const Hold hold = holdResting(m_board, m_touches, m_ball.position, drive());
    if (isRough(hold) && m_ball.spin != Vec3(0.0)) return false;
    return hold.kind == Hold::Kind::wedged || hold.start <= drive().B;
}

/// Where the ball is nearest to a solid now.
Touch Run::touchOf(uint32_t solid) const {
    const Nearest now = nearest(m_board.scene().solids[solid], m_ball.position);
    return {now.normal, now.point, solid, now.feature};
}

/// Reports that a contact begins to last, or ends without an impact.
void Run::noteHold(const Hold &hold) {
    const bool holds = hold.kind == Hold::Kind::face || hold.kind == Hold::Kind::edge;
    const double speed = glm::length(m_ball.velocity);
    if (holds && !m_held && m_elapsed > 0.0) contactEvent(PHYS_EVENT_CONTACT, hold.touch, speed, speed);
    if (!holds && m_held) contactEvent(PHYS_EVENT_RELEASE, touchOf(*m_held), speed, speed);
    m_held = holds ? std::optional(hold.touch.solid) : std::nullopt;
}

/// With unchanged gravity a ball at rest stays there: model.md 2.1 R4.
phys_status Run::rest(const Hold &hold) {
    if (!m_ball.supported && hold.touch.normal.z != 0.0) return refuse("the ball comes to rest on it", hold.touch);
    spend(m_left);
    return PHYS_OK;
}

phys_status Run::moveFreely(const Hold &hold) {
    const Drive acting = drive();
    const Vec3 &p = m_ball.position, &v = m_ball.velocity;
    if (v == Vec3(0.0)) {
        move(Motion::parabola(p, v, acting.A - acting.B * hold.direction), nullptr, m_left);
    } else if (m_ball.supported) {
        move(Motion::rolling(p, v, inPlane(acting.A), acting.B), nullptr, m_left);
    } else {
        move(Motion::parabola(p, v, acting.A), nullptr, m_left);
    }
    return PHYS_OK;
}

/// Along a motion until it ends, the time is up, or the ball touches a solid, leaves its floor or lands.
double Run::move(const Motion &motion, const Plane *plane, double until) {
    const Scene &scene = m_board.scene();
    const double back = returnTime(motion);
    double t = std::min({m_left, until, motion.end(), back});
    bool lands = false, exits = false;
    if (m_floor) {
        const double exit = m_sweep.firstExit(motion, t, *m_floor);
        exits = exit <= t;
        t = std::min(t, exit);
    } else {
        const double landing = landingTime();
        lands = landing <= t;
        t = std::min(t, landing);
    }
    const double hit = m_sweep.firstTouch(motion, t, plane);
    m_meets = lands || hit <= t || t == back;
    if (hit <= t) {
        lands = lands && hit == t;
        exits = exits && hit == t;
        t = hit;
    }

    follow(motion, t);
    if (exits) snapToBorder(scene.floors[*m_floor], m_board.tolerance(), m_ball.velocity, m_ball.position);
    if (lands) m_ball.position.z = scene.supportedZ;
    if (plane) m_ball.velocity[plane->axis] = 0.0;
    return t;
}

/// When a ball is back that a rough wall has just let go, so slowly that it doesn't leave the tolerance: the sweep
/// would see it late, and each bounce on a rough wall sets something else in motion. model.md 6.4.
double Run::returnTime(const Motion &motion) const {
    double first = kNever;
    if (isRolling() || m_params.wall_friction == 0.0) return first;
    for (const Touch &touch : m_touches) {
        if (!approaches(m_board, -touch.normal, touch.feature, m_ball.velocity)) continue;
        const double rate = glm::dot(m_ball.velocity, touch.normal);
        const double back = pressing(m_board, touch, m_ball.velocity, {motion.startAcceleration(), 0.0});
        if (rate * rate < back * m_board.tolerance()) first = std::min(first, 2.0 * rate / back);
    }
    return first;
}

/// Along a motion for t seconds in which nothing happens.
void Run::follow(const Motion &motion, double t) {
    const Vec3 before = m_ball.position;
    const Motion::Point end = motion.at(t);
    m_ball.position = end.position;
    m_ball.velocity = end.velocity;
    if (m_ball.supported) m_ball.position.z = m_board.scene().supportedZ;
    turnAlong(motion, before, t);
    spend(t);
    if (m_ball.supported) settleSpin(motion, t);
}

/// Most short steps: the ball rolls in the open, and nothing is near enough to meet. The same bits as by the phases,
/// with less asking. False, and nothing changed, if it isn't so.
bool Run::glide() {
    const Vec3 &p = m_ball.position, &v = m_ball.velocity;
    if (!m_ball.supported || v == Vec3(0.0) || slipVelocity() != Vec2(0.0) || !gripHolds(Hold{})) return false;
    const Drive acting = drive();
    const double most = length(inPlane(acting.A)) + acting.B;
    const double way = m_left * (length(inPlane(v)) + 0.5 * most * m_left) + m_board.tolerance();
    if (!m_board.isOpen(p, way)) return false;
    const Motion motion = Motion::rolling(p, v, inPlane(acting.A), acting.B);
    if (motion.end() <= m_left) return false;
    follow(motion, m_left);
    return true;
}

/// The spin of a ball on the floor after t seconds of a motion, and what rolling and slipping have cost.
void Run::settleSpin(const Motion &motion, double t) {
    if (motion.slips()) return settleSlip(motion, t);
    if (slides()) return;
    if (t == motion.end()) {
        m_ball.velocity = Vec3(0.0);
        event(PHYS_EVENT_STOP, glm::length(motion.at(0.0).velocity), 0.0);
    }
    if (m_report.wanted()) m_report.lostRolling(1.4 * drive().B * motion.path(t));
    roll();
}

void Run::turnAlong(const Motion &motion, const Vec3 &start, double t) {
    if (!(m_params.options & PHYS_OPTION_ORIENTATION)) return;
    if (!m_ball.supported || slides()) return turn(t * m_ball.spin);
    // The ball turns by its way, less that of the slip.
    Vec3 from = start;
    for (int part = 1; part <= kTurnParts; ++part) {
        const double time = t * part / kTurnParts;
        Vec3 to = motion.at(time).position;
        if (motion.slips()) to -= Vec3(motion.slipAt(time).x, 0.0);
        turn(rolledTurn(to - from, m_board.radius()) + Vec3(0.0, 0.0, t / kTurnParts * m_ball.spin.z));
        from = to;
    }
}

/// model.md 6.1: the law of one dimension, until the ball stops or the face ends.
phys_status Run::slideOnFace(const Hold &hold) {
    const Drive acting = drive();
    const int across = hold.plane.axis, along = 1 - across;
    Vec3 &p = m_ball.position, &v = m_ball.velocity;
    v[across] = 0.0;
    const double direction = v[along] != 0.0 ? v[along] : hold.direction[along];
    Vec3 a = acting.A;
    a[across] = 0.0;
    if (acting.B > 0.0) a[along] -= std::copysign(acting.B, direction);
    const bool slows = acting.B > 0.0 && a[along] * v[along] < 0.0;
    const double stop = slows ? std::abs(v[along] / a[along]) : kNever;

    slide(hold, Motion::parabola(p, v, a, stop));
    return PHYS_OK;
}

/// Along a motion on a face, until that face ends at the latest.
void Run::slide(const Hold &hold, const Motion &motion) {
    const double most = std::min(m_left, motion.end());
    const FaceWay way = m_floor ? alongFace(hold.plane, motion, most) : alongSolid(hold, motion);
    const double moved = move(motion, &hold.plane, way.until);
    if (moved == way.until && way.ends) m_ball.position[1 - hold.plane.axis] = way.end;
}

/// How long the ball slides until the face ends on either side, other solids flush with it included; no longer than
/// `most`.
Run::FaceWay Run::alongFace(const Plane &plane, const Motion &motion, double most) const {
    const int along = 1 - plane.axis;
    const Vec3 &p = m_ball.position;
    // A radius more than the ball can go: ends out of reach need not be told apart.
    const double way = most * (std::abs(motion.at(0.0).velocity[along]) + 0.5 * motion.mostAcceleration() * most);
    const double reach = way + m_board.radius();
    Vec3 low = p - Vec3(m_board.radius()), high = p + Vec3(m_board.radius());
    low[along] = m_board.faceEnd(plane, p, -1.0, p[along] - reach);
    high[along] = m_board.faceEnd(plane, p, 1.0, p[along] + reach);
    const double time = firstExit({fromVec(low), fromVec(high)}, motion, 0.0, most, m_board.tolerance());
    if (time > most) return {most, false, 0.0};
    return {time, true, motion.at(time).velocity[along] < 0.0 ? low[along] : high[along]};
}

/// The same in the air, where the face of one solid also has a lower and an upper end.
Run::FaceWay Run::alongSolid(const Hold &hold, const Motion &motion) const {
    const int along = 1 - hold.plane.axis;
    const Vec3 &p = m_ball.position, &v = m_ball.velocity, &a = motion.acceleration();
    const phys_box &box = m_board.scene().solids[m_board.carrier(hold.plane, p, hold.direction)];
    FaceWay way{m_left, false, 0.0};
    for (const double side : {-1.0, 1.0}) {
        const double end = side < 0.0 ? toVec(box.min)[along] : toVec(box.max)[along];
        const double time = firstFall(std::abs(end - p[along]), -side * v[along], -side * a[along]);
        if (time <= way.until) way = {time, true, end};
        const double height = side < 0.0 ? p.z - box.min.z : box.max.z - p.z;
        const double vertical = firstFall(std::max(0.0, height), -side * v.z, -side * a.z);
        if (vertical < way.until) way = {vertical, false, 0.0};
    }
    return way;
}

/// model.md 6.2: the angles first, then the time. In the air the ball falls freely beside it.
phys_status Run::pivotOnEdge(const Hold &hold) {
    const Drive acting = drive();
    const double R = m_board.radius();
    const Vec2 A = inPlane(acting.A), normal = inPlane(hold.touch.normal);
    const double a = length(A);
    Vec2 tangent{-normal.y, normal.x};
    if (glm::dot(tangent, inPlane(hold.direction)) < 0.0) tangent = -tangent;
    const EdgeArc arc{hold.corner, normal, tangent, R, m_ball.position.z};
    const Pendulum pendulum{glm::dot(A, tangent) / a, -glm::dot(A, normal) / a, acting.B / a,
                            length(inPlane(m_ball.velocity)) / std::sqrt(R * a)};

    // Where the way on the edge ends.
    const QuarterEnd quarter = quarterEnd(arc);
    const double stop = pendulum.stopAngle(quarter.angle);
    double end = std::min(quarter.angle, stop);
    end = std::min(end, pendulum.leaveAngle(end));
    const double touch = firstTouchOnArc(m_board, arc, end);
    end = std::min(end, touch);
    double exit = kNever;
    if (m_floor) exit = firstExitOnArc(m_board.scene().floors[*m_floor], arc, end, m_board.tolerance());
    end = std::min(end, exit);

    const double unitTime = std::sqrt(R / a);
    const Fall fall = fallFor(hold);
    const double until = std::min(m_left, fall.time);
    // The time of a stop is that of zero speed: by the angle, which hardly changes there, it would be ill defined.
    const Swing swung = swing(pendulum, end == stop ? kNever : end, until / unitTime);
    const double t = std::min(until, swung.time * unitTime);
    const double speed = swung.speed * std::sqrt(R * a);

    m_meets = swung.angle == touch;
    // The arc is level. Of a ball that rises or falls beside it, what is in the way is found step by step or never.
    m_levelTouches = !m_floor && m_meets ? m_levelTouches + 1 : 0;
    if (m_levelTouches > kMostLevelTouches)
        return refuse("the ball flies along it beside the top or bottom of another wall", hold.touch);
    turnOnArc(arc, swung.angle, t);
    const bool atQuarter = swung.angle == quarter.angle;
    const Vec2 n = atQuarter ? quarter.normal : arc.normalAt(swung.angle);
    const Vec2 way = atQuarter ? quarter.tangent : arc.tangentAt(swung.angle);
    Vec3 &p = m_ball.position, &v = m_ball.velocity;
    p = Vec3(hold.corner + R * n, p.z);
    v = Vec3(speed * way, v.z);
    if (m_floor) {
        if (swung.angle == exit) snapToBorder(m_board.scene().floors[*m_floor], m_board.tolerance(), v, p);
        m_report.lostRolling(1.4 * acting.B * R * swung.angle);
        if (!slides()) roll();
    } else {
        const bool lands = fall.lands && t == fall.time;
        m_meets = m_meets || lands;
        p.z = lands ? m_board.scene().supportedZ : p.z + t * (v.z + 0.5 * t * acting.A.z);
        v.z += t * acting.A.z;
    }
    spend(t);
    if (speed == 0.0 && m_floor) event(PHYS_EVENT_STOP, pendulum.speed * std::sqrt(R * a), 0.0);
    return PHYS_OK;
}

/// When a flying ball is down at the height of a floor; kNever if it isn't above, or has only just left one.
double Run::landingTime() const {
    const Scene &scene = m_board.scene();
    const double height = m_ball.position.z - scene.supportedZ;
    const bool above = scene.hasFloor && (height > 0.0 || (height == 0.0 && m_ball.velocity.z > 0.0));
    return above ? firstFall(height, m_ball.velocity.z, m_params.gravity.z) : kNever;
}

/// In the air: when the ball lands, or leaves the solid that it turns round at its lower or upper end.
Run::Fall Run::fallFor(const Hold &hold) const {
    if (m_floor) return {kNever, false};
    const Vec3 &p = m_ball.position, &v = m_ball.velocity;
    const Heights heights = m_board.heights(p, hold.touch.normal);
    const double g = m_params.gravity.z;
    Fall fall{std::min(firstFall(p.z - heights.low, v.z, g), firstFall(heights.high - p.z, -v.z, -g)), false};
    const double landing = landingTime();
    return landing <= fall.time ? Fall{landing, true} : fall;
}

void Run::turnOnArc(const EdgeArc &arc, double angle, double t) {
    if (!(m_params.options & PHYS_OPTION_ORIENTATION)) return;
    if (!m_ball.supported || slides()) return turn(t * m_ball.spin);
    for (int part = 0; part < kTurnParts; ++part) {
        const Vec3 from = arc.centreAt(angle * part / kTurnParts), to = arc.centreAt(angle * (part + 1) / kTurnParts);
        turn(rolledTurn(to - from, m_board.radius()));
    }
}

} // namespace phys
