// SPDX-License-Identifier: MIT
#include "exact/region_run.h"

#include "contact/held.h"
#include "exact/choose.h"
#include "exact/floor_pull.h"
#include "exact/last_bounce.h"
#include "exact/search.h"
#include "phases/resisted.h"
#include "phases/slide.h"
#include "phases/slip_end.h"
#include "phases/uniform.h"
#include "scene/nearest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace phys {

namespace {

const Vec3 kUp(0.0, 0.0, 1.0);
const Resisted::Face kFloor{0, 2, kUp};

class RegionRun {
public:
    RegionRun(const FloorRegion &region, MovingBall &ball, ContactEvents &events)
        : m_region(region)
        , m_ball(ball)
        , m_events(events)
        , m_floor(ball.scene().boxes[region.floor].max.z + ball.radius())
        , m_pull(ball.scene(), ball.params())
        , m_level(m_pull.level, 0.0) {}

    /// Computes one phase and the event that ends it. Leaves the ball where anything else may happen next.
    void advance() {
        const Vec3 &velocity = m_ball.motion.velocity;
        const bool goesOn = m_pull.goesOn(inPlane(velocity), m_ball.motion.spin);
        m_rests = kNone;
        for (int axis = 0; axis < 2; ++axis) {
            if (!range(axis).isFace(m_ball.position[axis])) continue;
            const double away = velocity[axis] * sideOf(axis);
            if (away == 0.0 && m_rests == kNone)
                m_rests = axis;
            else if (!(away > 0.0 && away * away > squareOfLeastSpeed()))
                return;
        }
        m_spin = isRigid() ? m_ball.motion.spin : rollingSpin(inPlane(velocity), m_ball.radius());
        const bool starts = m_rests != kNone && m_pull.starts(1 - m_rests, velocity, m_spin);
        m_rolls = starts || (goesOn && !m_pull.glides());
        if (starts) return moveAlongFace(m_pull.drive()[1 - m_rests]);
        if (goesOn) return m_rests == kNone ? moveFreely() : moveAlongFace(velocity[1 - m_rests]);
        if (!isRigid() || m_pull.glides()) return;
        return m_rests == kNone ? slip() : slipAlongFace();
    }

private:
    static constexpr int kNone = 2;

    bool isRigid() const { return m_ball.setting.isRigid(); }
    const FloorRegion::Range &range(int axis) const { return m_region.along[static_cast<size_t>(axis)]; }
    /// Of the touched face across an axis: direction of its normal, its box, coordinate of the ball's centre.
    int sideOf(int axis) const { return range(axis).lowFace == m_ball.position[axis] ? 1 : -1; }
    uint32_t boxAt(int axis) const { return sideOf(axis) > 0 ? range(axis).lowBox : range(axis).highBox; }
    double placeAt(int axis) const { return sideOf(axis) > 0 ? range(axis).lowFace : range(axis).highFace; }

    template<class Phase>
    End endOf(const Phase &phase) {
        return phase.end(m_ball.left, m_ball.work);
    }

    /// The ball rolls or glides.
    void moveFreely() {
        const double B = m_pull.resistance();
        if (B == 0.0) return runOn(uniform(Vec3(m_pull.drive(), 0.0)), End());
        if (!m_pull.turns(inPlane(m_ball.motion.velocity), B)) return rollStraight();
        Moment moment = m_ball.moment();
        moment.spin = m_spin;
        const Resisted phase = Resisted::rolling(moment, kFloor, B);
        return runOn(phase, endOf(phase));
    }

    /// Along the drive, until resistance stops the ball.
    void rollStraight() {
        const Moment moment = m_ball.moment();
        const Vec3 turning = tangential(m_spin, kUp), heading = hat(glm::cross(turning, kUp));
        m_rolling = glm::cross(kUp, heading);
        const Uniform phase = uniform(Vec3(m_pull.accelerationAlong(inPlane(heading)), 0.0));
        if (isNoSlip(moment, moment.radius * turning) || !isCollinear(m_rolling, phase.spinAcceleration)) return;
        return runOn(phase, phase.endOfRolling(m_rolling, 0));
    }

    Uniform uniform(const Vec3 &a) const {
        return {m_ball.motion.velocity, a, m_spin, m_rolls ? glm::cross(kUp, a) / m_ball.radius() : Vec3(-0.0)};
    }

    void slip() {
        constexpr double kLeast = 1e-12; // relative to the speeds: smaller slips may be rounding
        const Moment moment = m_ball.moment();
        const Vec3 slip = slipAt(moment, kUp);
        const double friction = m_pull.friction();
        if (!(glm::length(slip) > kLeast * speedScale(moment)) || !m_pull.turns(inPlane(slip), friction)) return;
        const Resisted phase = Resisted::slipping(moment, kFloor, slip, friction);
        const End end = endOf(phase);
        if (rollsAfter(end, slip)) runOn(phase, end);
    }

    /// Whether a ball whose slip ends in this step certainly moves on.
    bool rollsAfter(const End &end, const Vec3 &slip) const {
        Vec3 rolling = m_ball.motion.velocity - 2.0 / 7.0 * slip + 5.0 / 7.0 * end.after * m_level;
        if (m_rests != kNone) rolling[m_rests] = 0.0;
        return !(end.after < m_ball.left) || glm::length(rolling) > kUnsure * speedScale(m_ball.moment());
    }

    /// The drive presses the ball against a face, so that its acceleration is constant: model.md 14.1. heading: along
    /// the face; only its sign counts.
    void moveAlongFace(double heading) {
        const int along = 1 - m_rests;
        if (!m_pull.presses(m_rests, sideOf(m_rests), inPlane(m_ball.motion.velocity), m_spin)) return;
        Vec3 way(0.0), a(0.0);
        way[along] = heading > 0.0 ? 1.0 : -1.0;
        a[along] = m_pull.accelerationAlong(along, heading);
        m_rolling = glm::cross(kUp, way);
        const Uniform phase = uniform(a);
        return runOn(phase, m_pull.resistance() > 0.0 ? phase.endOfRolling(m_rolling, 0) : End());
    }

    /// Friction and drive press the ball against a smooth face, and the slip turns: model.md 14.2.
    void slipAlongFace() {
        const phys_params &params = m_ball.params();
        const Moment moment = m_ball.moment();
        const int along = 1 - m_rests;
        const double B = m_pull.friction();
        const Vec3 slip = slipAt(moment, kUp), direction = hat(slip), a = m_level - B * direction;
        const Vec3 n = contactAtFace(m_ball.setting, m_ball.position, boxAt(m_rests), m_rests, sideOf(m_rests)).normal;
        const double push = -glm::dot(n, a);
        const Vec2 rate(-2.5 * B * direction[m_rests], m_level[along] - 3.5 * B * direction[along]);
        const double turning = slip[m_rests] * rate.y - slip[along] * rate.x;
        constexpr double kLeast = 1e-13, kLeastTurn = 1e-10; // relative to the speeds; sine of an angle
        if (params.wall_friction > 0.0 || !(glm::length(slip) > kLeast * speedScale(moment))) return;
        if (!(push > 0.02 * B + kUnsure * accelerationScale(moment))) return;
        if (!(std::abs(turning) > kLeastTurn * glm::length(slip) * glm::length(rate))) return slipStraight(slip);
        const bool isUnsure = !rollsAfter({0.0}, slip);
        const Held floor{kUp, kUp, params.sliding_friction, 0.0, false}, face{n, glm::abs(n), 0.0, 0.0, false};
        const Reaction rubs{Mode::slipping, m_pull.pressure, Vec3(0.0), direction, slip};
        const Reaction presses{Mode::smooth, push, push * n, Vec3(0.0), Vec3(0.0)};
        const Bearing rough{0, floor, rubs}, smooth{1, face, presses};
        if (const auto closing = SlipEnd::of(moment, rough, smooth)) {
            const End end = endOf(*closing);
            Hit hit;
            if (isUnsure || !findHit(*closing, std::min(end.after, m_ball.left), hit)) return;
            if (end.after < m_ball.left && hit.after >= end.after) return runOn(*closing, end);
        }
        const Slide phase(moment, rough, smooth);
        const End end = endOf(phase);
        if (end.cause != Cause::grip || !isUnsure) runOn(phase, end);
    }

    /// The same of a slip that keeps its direction, as one along the face, and so constant accelerations.
    void slipStraight(const Vec3 &slip) {
        const double B = m_pull.friction(), R = m_ball.radius();
        m_slipping = hat(slip);
        Vec3 a = m_level - B * m_slipping;
        a[m_rests] = 0.0;
        const Uniform phase{m_ball.motion.velocity, a, m_spin, -kInertia / R * glm::cross(kUp, -B * m_slipping)};
        if (!isCollinear(slip, a - R * glm::cross(phase.spinAcceleration, kUp))) return;
        const End end = phase.endOfSlip(slip, kUp, R, 0);
        if (rollsAfter(end, slip)) runOn(phase, end);
    }

    /// An impact on a face of the region.
    struct Hit {
        double after = kNever;  ///< s
        int axis = 0, side = 0; ///< of its normal
        uint32_t box = PHYS_NO_BOX;
    };

    /// Follows a phase to an impact, to its own end or to the end of the step.
    template<class Phase>
    void runOn(const Phase &phase, const End &own) {
        const double until = std::min(own.after, m_ball.left);
        Hit hit;
        if (!findHit(phase, until, hit)) return;
        const bool hits = hit.after < until, ends = !hits && own.after < m_ball.left;
        const double end = hits ? hit.after : until;
        if (end > 0.0) follow(phase, end);
        if (ends && own.cause == Cause::grip) return grip(own, phase.mostAcceleration());
        if (ends && own.cause == Cause::stop) return stop(phase.spinAt(end));
        if (!hits) return;
        countHop(std::is_same_v<Phase, Resisted> ? kResistedCount : kHopCount, end, m_ball);
        bounce(hit);
    }

    /// Bounds of the ball's coordinates.
    struct Extent {
        Vec2 low, high;
    };

    Extent extentUntil(double time, double mostAcceleration) const {
        const Vec2 place = inPlane(m_ball.position), way = time * inPlane(m_ball.motion.velocity);
        const double bend = 0.5 * time * time * mostAcceleration;
        return {place + glm::min(way, 0.0) - bend, place + glm::max(way, 0.0) + bend};
    }

    /// Whether the ball may leave the region through a side.
    bool isBeyond(const Extent &extent, int axis, int side) const {
        if (axis == m_rests) return false;
        return side > 0 ? extent.low[axis] < range(axis).low : extent.high[axis] > range(axis).high;
    }

    uint32_t boxOn(int axis, int side) const { return side > 0 ? range(axis).lowBox : range(axis).highBox; }

    /// Whether a ball that leaves the region through a side meets a face there.
    bool isBeforeFace(const Extent &extent, int axis, int side) const {
        const uint32_t number = boxOn(axis, side);
        if (number == PHYS_NO_BOX) return false;
        const phys_box &box = m_ball.scene().boxes[number];
        const int other = 1 - axis;
        const double margin = 4.0 * m_ball.scene().tolerance; // from the ends of the face
        return extent.low[other] >= (&box.min.x)[other] + margin && extent.high[other] <= (&box.max.x)[other] - margin;
    }

    template<class Phase>
    static bool turnsOnce(const Phase &phase) {
        if constexpr (requires { phase.turnsOnce(); }) return phase.turnsOnce();
        return false;
    }

    /// False if the ball may leave the region beside the faces before.
    template<class Phase>
    bool findHit(const Phase &phase, double until, Hit &first) {
        constexpr std::array<std::pair<int, int>, 4> kSides{{{0, 1}, {0, -1}, {1, 1}, {1, -1}}};
        const double most = phase.mostAcceleration();
        Extent extent = extentUntil(until, most);
        const auto search = [&](const Way &, double from, double end, double) {
            for (const auto &[axis, side] : kSides) {
                const uint32_t number = boxOn(axis, side);
                if (!isBeyond(extent, axis, side) || number == PHYS_NO_BOX) continue;
                const double after = timeOfHit(phase, from, end, axis, side, m_ball.scene().boxes[number]);
                if (after < first.after) first = {after, axis, side, number};
            }
            return first.after;
        };
        if (turnsOnce(phase)) {
            search({}, 0.0, until, 0.0);
        } else { // rounding of a fast spin may hide the time: it depends on where the event loop searches, too
            searchParts(m_ball.work, phase, 0.0, until, kFirstWindow * m_ball.radius(), search);
        }
        if (first.after < until) extent = extentUntil(first.after, most);
        return std::all_of(kSides.begin(), kSides.end(), [&](const std::pair<int, int> &each) {
            const auto &[axis, side] = each;
            return !isBeyond(extent, axis, side) || isBeforeFace(extent, axis, side);
        });
    }

    template<class Phase>
    double timeOfHit(const Phase &phase, double from, double end, int axis, int side, const phys_box &box) {
        Contacts touched;
        const Outlook around{m_ball.scene(), m_ball.position, m_ball.motion, touched, m_ball.work};
        const bool isTouched = range(axis).isFace(m_ball.position[axis]);
        if constexpr (requires { phase.turnsOnce(); }) {
            const FaceTarget face(m_ball.position, box, axis, side, isTouched && sideOf(axis) == side);
            const double after = PlaneSearch(face, around, phase).find(from, end);
            if (!std::isnan(after)) return after;
        }
        if (isTouched) {
            touched.add(contactAtFace(m_ball.setting, m_ball.position, boxAt(axis), axis, sideOf(axis)));
        }
        return touchTime(around, box, phase, from, end);
    }

    /// (m/s)^2: squared speed off a face above which a ball certainly leaves it: its bounce isn't the last one,
    /// model.md 6.4, and the speed isn't rounding, which a fast spin makes.
    double squareOfLeastSpeed() const {
        const phys_params &params = m_ball.params();
        const Motion &motion = m_ball.motion;
        const double friction = std::max(params.rolling_friction, isRigid() ? params.sliding_friction : 0.0);
        const double level = std::abs(m_level.x) + std::abs(m_level.y), R = m_ball.radius();
        const double squares = glm::dot(motion.velocity, motion.velocity) + R * R * glm::dot(motion.spin, motion.spin);
        return std::max(2.0 * (level + friction * m_pull.pressure) * lastHeight(m_ball),
                        2.0 * kNegligibleShare * kNegligibleShare * squares);
    }

    /// Whether the law sees the contact: rounding may end the way short of it.
    bool touches(uint32_t box) const {
        const double reach = m_ball.radius() + m_ball.scene().tolerance;
        return squaredDistance(m_ball.scene().boxes[box], m_ball.position) <= reach * reach;
    }

    /// Unless the face isn't reached, another contact is near or this may be the last bounce.
    void bounce(const Hit &hit) {
        m_ball.work.add(Work::kTouch + Work::kImpact);
        const int other = 1 - hit.axis;
        if (!touches(hit.box) || (other != m_rests && !range(other).isFree(m_ball.position[other]))) return;
        const Contact face = contactAtFace(m_ball.setting, m_ball.position, hit.box, hit.axis, hit.side);
        const Motion before = m_ball.motion;
        const double R = m_ball.radius(), approach = -glm::dot(before.velocity, face.normal);
        const double after = face.restitution * approach;
        if (face.friction > 0.0 || !(after * after > squareOfLeastSpeed())) return;
        Motion &motion = m_ball.motion;
        motion.velocity += (1.0 + face.restitution) * approach * face.normal;
        report(face, before);
        dropTraces(before, R, motion);
        if (!isRigid()) {
            const Vec3 rolls = rollingSpin(inPlane(motion.velocity), R);
            m_ball.report.lostImpact(0.2 * R * R * (glm::dot(motion.spin, motion.spin) - glm::dot(rolls, rolls)));
            motion.spin = rolls;
        }
        m_ball.position[hit.axis] = face.point[hit.axis] + hit.side * R;
    }

    void report(const Contact &face, const Motion &before) {
        if (!m_ball.report.wanted()) return;
        const double R = m_ball.radius();
        m_ball.report.lostImpact(kineticEnergy(before, R) - kineticEnergy(m_ball.motion, R));
        m_ball.report.passes(1);
        m_ball.event(PHYS_EVENT_IMPACT, face, glm::dot(before.velocity, face.normal),
                     glm::dot(m_ball.motion.velocity, face.normal));
    }

    /// The end of a slip.
    void grip(const End &end, double mostAcceleration) {
        Motion &motion = m_ball.motion;
        if (m_ball.waits(end, mostAcceleration)) {
            const double passed = std::min(end.rest, m_ball.left);
            m_ball.pass(passed);
            m_ball.position += passed * motion.velocity;
        }
        const double before = glm::length(motion.velocity);
        const Vec3 slip = slipAt(m_ball.moment(), kUp);
        motion.velocity -= 2.0 / 7.0 * Vec3(slip.x, slip.y, 0.0);
        m_ball.roll();
        m_ball.event(PHYS_EVENT_ROLL, before, glm::length(motion.velocity));
        m_ball.work.add(Work::kEvent);
        if (m_rests == kNone) return;
        motion.velocity[m_rests] = 0.0;
        m_ball.roll();
    }

    /// Resistance has stopped the ball.
    void stop(const Vec3 &spin) {
        Motion &motion = m_ball.motion;
        m_ball.event(PHYS_EVENT_STOP, glm::length(motion.velocity), 0.0);
        motion = {Vec3(0.0), glm::dot(spin, kUp) * kUp};
        if (m_ball.radius() * glm::length(motion.spin) <= 4e-13 * speedScale(m_ball.moment())) motion.spin = Vec3(0.0);
        m_ball.roll();
        m_ball.work.add(Work::kEvent);
    }

    template<class Phase>
    Losses losses(const Phase &phase, double t) const {
        return phase.losses(t);
    }
    Losses losses(const Uniform &phase, double t) const {
        const double R = m_ball.radius(), rolling = m_ball.params().rolling_friction * m_pull.pressure * R * t;
        return {m_pull.friction() * t * phase.meanSlip(t, m_slipping, kUp, R),
                m_rolls ? rolling * phase.meanSpin(t, m_rolling) : 0.0};
    }

    template<class Phase>
    void follow(const Phase &phase, double t) {
        if (m_ball.report.wanted()) {
            const double R = m_ball.radius();
            const Losses lost = losses(phase, t);
            const Vec3 &given = m_ball.motion.spin;
            m_ball.report.lostSlip(lost.slip + 0.2 * R * R * (glm::dot(given, given) - glm::dot(m_spin, m_spin)));
            m_ball.report.lostRolling(lost.rolling);
        }
        const bool leans = m_rests != kNone;
        m_events.addOnFloor(leans ? boxAt(m_rests) : PHYS_NO_BOX, leans ? m_rests : 0, leans ? sideOf(m_rests) : 1,
                            m_ball);
        const double face = leans ? placeAt(m_rests) : 0.0;
        const Place place = phase.placeAt(t);
        m_ball.turn(phase, place, t);
        m_ball.position += place.way;
        m_ball.position.z = m_floor;
        if (leans) m_ball.position[m_rests] = face; // a zero may have the opposite sign
        m_ball.motion = {{place.velocity.x, place.velocity.y, 0.0}, place.spin};
        m_ball.pass(t);
        if (m_rolls) m_ball.roll();
    }

    const FloorRegion &m_region;
    MovingBall &m_ball;
    ContactEvents &m_events;
    double m_floor; ///< m: height of the centre
    FloorPull m_pull;
    Vec3 m_level;         ///< gravity along the floor, m/s^2
    Vec3 m_spin{0.0};     ///< at the start of the phase
    Vec3 m_rolling{0.0};  ///< direction of the spin that resistance opposes, of a ball that rolls straight
    Vec3 m_slipping{0.0}; ///< direction of a slip that keeps it
    bool m_rolls = false;
    int m_rests = kNone; ///< the axis across which it leans on a face
};

} // namespace

bool runInRegion(FloorRegions &regions, MovingBall &ball, ContactEvents &events) {
    if (ball.motion.velocity.z != 0.0 || !(ball.params().gravity.z < 0.0) || ball.runsAllStages()) return false;
    bool isSecond = false; // at the present position
    Vec2 tried(0.0);
    while (ball.left > 0.0) {
        if (ball.work.isTooMuch()) return false;
        const Vec2 velocity = inPlane(ball.motion.velocity);
        const phys_vec3 place = fromVec(ball.position);
        const FloorRegion *region =
            isSecond ? regions.another(tried, place, velocity, ball.left) : regions.around(place, velocity, ball.left);
        if (!region) return false;
        const double left = ball.left;
        tried = region->foundAt;
        RegionRun(*region, ball, events).advance();
        if (ball.left == left && isSecond) return false;
        isSecond = ball.left == left;
    }
    return true;
}

} // namespace phys
