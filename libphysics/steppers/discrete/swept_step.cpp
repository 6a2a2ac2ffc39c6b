// SPDX-License-Identifier: MIT
#include "swept_step.h"

#include "scene/nearest.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace phys {

namespace {

/// A speed along a normal below this share of sqrt(g R) doesn't open a contact.
constexpr double kSlow = 1e-11;

/// Share of a substep: what happens within it happens now.
constexpr double kSoon = 1.0 / 64.0;

/// The time in which a ball of this speed under this acceleration (m/s^2) moves by at most half its radius, s.
double safeTime(double radius, double pull, double speed) {
    const double safe = 0.5 * radius;
    const double root = speed + std::sqrt(speed * speed + 4.0 * pull * safe);
    return root > 0.0 ? 2.0 * safe / root : INFINITY;
}

/// The time in which friction that turns the ball's spin into speed moves it by at most a quarter of its radius, s.
double safeTimeOfSpin(const PlanInput &input, const Ball &ball) {
    const double spin = input.params.model == PHYS_MODEL_RIGID ? glm::length(ball.spin) : 0.0;
    return spin > 0.0 ? kSafeTurn / spin : INFINITY;
}

double safeTime(const PlanInput &input, const Ball &ball) {
    const double pull = glm::length(toVec(input.params.gravity));
    return std::min(safeTime(input.scene.radius, pull, glm::length(ball.velocity)), safeTimeOfSpin(input, ball));
}

/// On which side of a box a centre is along each axis: -1, 0 inside, 1; 2 at an end, where the velocity decides.
std::array<int, 3> sidesOf(const phys_box &box, const Vec3 &centre, double tolerance) {
    std::array<int, 3> sides{};
    for (int axis = 0; axis < 3; ++axis) {
        const double below = (&box.min.x)[axis] - centre[axis], above = centre[axis] - (&box.max.x)[axis];
        const bool isAtEnd = std::abs(below) <= tolerance || std::abs(above) <= tolerance;
        sides[static_cast<size_t>(axis)] = isAtEnd ? 2 : below > 0.0 ? -1 : above > 0.0 ? 1 : 0;
    }
    return sides;
}

} // namespace

Setting SweptStep::settingOf(const PlanInput &input) {
    Setting setting(input.scene, input.params);
    setting.tolerance = 2.0 * input.scene.tolerance;
    return setting;
}

SweptStep::SweptStep(const PlanInput &input, Reporter &reporter, Work &work, const StepPlan &plan, const Ball &start)
    : m_input(input)
    , m_plan(plan)
    , m_context{settingOf(input), reporter, work}
    , m_substep(std::min(input.dt, safeTime(input, start)))
    , m_slow(kSlow * std::sqrt(glm::length(toVec(input.params.gravity)) * input.scene.radius))
    , m_ball(start) {
    std::copy(std::begin(input.state.orientation), std::end(input.state.orientation), m_orientation);
}

SweptStep::Course SweptStep::move(double t, Reporter &reporter, Work &work, Ball &ball) const {
    Step step(m_context.setting, reporter, work, m_plan, t);
    if (m_isAlone || m_contacts.empty()) {
        ball.supported = m_isAlone;
        book(step.move(ball), reporter);
        return Course::Free;
    }
    if (m_hopEnd == INFINITY && step.rollBetweenWalls(m_contacts, ball)) {
        ball.supported = true;
        return Course::BetweenWalls;
    }
    const StepContext context{m_context.setting, reporter, work};
    const ContactRule rule = m_slipEnds ? ContactRule::EndingSlip : ContactRule::SecondOrder;
    ball.velocity += m_taken;
    ball.supported = hold(context, m_contacts, rule, t, ball);
    return Course::Held;
}

const SweptStep::Moved &SweptStep::movedBy(double t) const {
    if (m_moved.t == t && m_moved.slipEnds == m_slipEnds) return m_moved;
    constexpr uint32_t kEffortOfContacts = 40;
    Reporter silent;
    m_moved = {t, m_slipEnds, Course::Free, m_ball};
    m_moved.course = move(t, silent, m_context.work, m_moved.ball);
    m_effort += m_moved.course == Course::Held ? 1 + kEffortOfContacts : 1;
    return m_moved;
}

bool SweptStep::toNextEvent() {
    if (advanceFreely()) return true;
    beginPhase();
    m_moved.t = -1.0;
    if (mayRest(m_context.setting, m_ball.velocity) && rests(m_context, m_ball)) {
        m_done = m_input.dt;
        return true;
    }
    const double rest = m_input.dt - m_done;
    const double t = firstEvent(timeToStopOrRoll(timeToSlipEnd(std::min(rest, horizon()))));
    const Vec3 spinBefore = m_ball.spin;
    finishPhase(t);
    turn(spinBefore, t);
    // The remainder may be too short to count.
    m_done = rest - t <= 2.0 * kRounding * m_input.dt ? m_input.dt : m_done + t;
    return m_done >= m_input.dt;
}

/// The whole step if no event happens in it.
bool SweptStep::advanceFreely() {
    if (m_done > 0.0) return false;
    if (passesBy(m_input)) {
        move(m_input.dt, m_context.report, m_context.work, m_ball);
        turn(m_ball.spin, m_input.dt);
        return true;
    }
    if (!isSlow(m_input) || spinsFast(m_input)) return false;
    const StepContext context{{m_input.scene, m_input.params}, m_context.report, m_context.work};
    const Motion before = motionOf(m_ball);
    if (!FloorRun<VelocityVerlet>(context, m_plan, m_input.dt).glide(m_ball)) return false;
    turn(m_context.isRigid() ? before.spin : rollingSpin(inPlane(before.velocity), m_context.radius()), m_input.dt);
    return true;
}

/// Speed below which an approach doesn't bounce.
double SweptStep::restSpeedAlong(const Vec3 &normal) const {
    const Vec3 gravity = m_context.setting.gravity();
    const double share = 2.0 * m_substep * m_substep * std::sqrt(glm::length(gravity) / m_context.radius());
    return share * std::max(0.0, -glm::dot(gravity, normal));
}

/// Speed above which leaving a contact ends it.
double SweptStep::leavingSpeed(double restSpeed) const {
    // Friction may also press the ball, so that a bounce doesn't rise above rounding.
    const double hop = std::sqrt(2.0 * glm::length(m_context.setting.gravity()) * m_context.scene().tolerance);
    return std::max({restSpeed, m_slow, hop});
}

/// Whether the ball touches nothing but one floor and at most one vertical face. These are its contacts then.
bool SweptStep::touchesGround() {
    const Setting &setting = m_context.setting;
    const Vec3 &p = m_ball.position;
    const double touching = m_context.radius() + setting.tolerance;
    uint32_t floors = 0, faces = 0;
    m_contacts.clear();
    for (const uint32_t number : setting.scene.boxesNear(p.x, p.y, setting.scene.hasManyBoxes)) {
        const phys_box &box = setting.scene.boxes[number];
        if (squaredDistance(box, p) > touching * touching) continue;
        const std::array<int, 3> sides = sidesOf(box, p, setting.tolerance);
        const int axis = sides[2] != 0 ? 2 : sides[1] != 0 ? 1 : 0;
        const int side = sides[static_cast<size_t>(axis)];
        const bool isFace = std::count(sides.begin(), sides.end(), 0) == 2 && std::abs(side) == 1;
        uint32_t &count = axis == 2 ? floors : faces;
        if (!isFace || count++ > 0 || (axis == 2 && side < 0)) return false;
        m_contacts.add(contactAtFace(setting, p, number, axis, side));
    }
    return floors == 1;
}

/// The usual phase, begun at less cost with the bits of the general case: in the rolling model, the ball lies on a
/// floor alone or bounces off a face there. Otherwise returns false and changes no more than the contacts.
bool SweptStep::beginOnFloor() {
    const bool mayBe = !m_context.isRigid() && !m_context.report.wanted() && m_ball.velocity.z == 0.0 &&
                       m_context.params().gravity.z <= 0.0;
    if (!mayBe || !touchesGround()) return false;
    Motion motion = motionOf(m_ball);
    for (const Contact &contact : m_contacts) {
        if (contact.isTop) continue;
        const double restSpeed = restSpeedAlong(contact.normal);
        const double approach = -glm::dot(motion.velocity, contact.normal);
        if (approach > std::max(restSpeed, negligibleSpeed(motion, m_context.radius()))) {
            motion.velocity += (1.0 + contact.restitution) * approach * contact.normal;
            dropTraces(motionOf(m_ball), m_context.radius(), motion);
        }
        if (!(glm::dot(motion.velocity, contact.normal) > leavingSpeed(restSpeed))) return false;
    }
    m_contacts.drop([](const Contact &contact) { return !contact.isTop; });
    m_ball.velocity = Vec3(inPlane(motion.velocity), 0.0);
    m_ball.spin = rollingSpin(inPlane(motion.velocity), m_context.radius());
    m_ball.position.z = m_contacts[0].point.z + m_context.radius();
    m_isAlone = true;
    m_resists = false;
    return true;
}

void SweptStep::beginPhase() {
    m_taken = Vec3(0.0);
    m_hopEnd = INFINITY;
    if (beginOnFloor()) return;
    const Setting &setting = m_context.setting;
    const auto lookHere = [&] {
        findContacts(setting, m_ball.position, motionOf(m_ball), Vec3(0.0), m_contacts);
        for (Contact &contact : m_contacts) contact.restSpeed = restSpeedAlong(contact.normal);
    };
    lookHere();
    SpinOnFloor landing(m_context, m_contacts, m_ball);
    // The velocity determines on which side of a border the ball is.
    if (hit(m_context, m_contacts, m_done, 0.0, m_ball)) lookHere();
    landing.follow(m_contacts, m_ball);
    dropWhatIsLeft();
    // A ball that hops too low to leave a top face also rolls on it: friction must not treat its spin as a slip.
    SpinOnFloor staying(m_context, m_contacts, m_ball);
    staying.follow(m_contacts, m_ball);
    const bool turns = landing.turns(m_ball) || staying.turns(m_ball);
    const bool carries = !turns || isSurelyCarried() || pressesNow();
    staying.settle(carries, m_ball);
    landing.settle(carries, m_ball);
}

/// Whether a top face presses on the ball, if it doesn't leave its contacts now; presses: as of `hold`.
bool SweptStep::pressesNow(std::span<bool> presses) const {
    Ball trial = m_ball;
    Reporter silent;
    return hold({m_context.setting, silent, m_context.work}, m_contacts, ContactRule::SecondOrder, kSoon * m_substep,
                trial, presses);
}

/// Slow contacts last from now on, without any speed along their normals; those that the ball leaves are dropped.
void SweptStep::dropWhatIsLeft() {
    if (m_contacts.count() > 1) stopSlowApproach();
    const Vec3 velocity = m_ball.velocity;
    const auto speed = [&](const Contact &contact) { return glm::dot(velocity, contact.normal); };
    m_contacts.drop([&](const Contact &contact) { return speed(contact) > leavingSpeed(contact.restSpeed); });
    keepContacts(velocity);
    const double negligible = negligibleSpeed({velocity, m_ball.spin}, m_context.radius());
    const bool leaves = std::any_of(m_contacts.begin(), m_contacts.end(),
                                    [&](const Contact &contact) { return speed(contact) > negligible; });
    if (leaves) dropWhatNothingPresses(velocity, negligible);
    finishHops(velocity);
    snapToFaces();
    m_isAlone =
        m_contacts.count() == 1 && m_contacts[0].isTop && m_context.params().gravity.z <= 0.0 && m_hopEnd == INFINITY;
    m_resists = !m_isAlone && m_context.params().rolling_friction > 0.0 && m_ball.velocity != Vec3(0.0) &&
                std::any_of(m_contacts.begin(), m_contacts.end(), [](const Contact &contact) { return contact.isTop; });
}

/// A hop that a contact took at once lasts all the same: until its end the contact presses less, and a glued face turns
/// no spin. Otherwise friction would err by the hop's momentum however short the step.
void SweptStep::finishHops(const Vec3 &velocity) {
    const Vec3 gravity = m_context.setting.gravity();
    const Vec3 taken = velocity - m_ball.velocity;
    double friction = 0.0, most = 0.0;
    for (Contact &contact : m_contacts) {
        friction = std::max(friction, contact.friction);
        most = std::max(most, leavingSpeed(contact.restSpeed));
        const double speed = glm::dot(taken, contact.normal);
        // The sum of all bounces, the first of which has begun.
        const double hop = speed > 0.0 ? speed : -contact.restitution * speed;
        const double pressing = std::max(0.0, -glm::dot(gravity, contact.normal)) * (1.0 - contact.restitution);
        if (!contact.isGlued || hop <= m_slow || pressing == 0.0) continue;
        m_hopEnd = 2.0 * hop / pressing;
        contact.isGlued = contact.isTop = false;
    }
    const double speed = glm::length(taken);
    if (!m_context.isRigid() || friction == 0.0 || speed <= m_slow || speed > most) return;
    constexpr double kShortest = 1.0 / 1024.0; // of a substep
    m_taken = taken;
    m_hopEnd = std::max(kShortest * m_substep, 4.0 * speed / glm::length(gravity));
}

/// Between two opposite faces that are a rounding farther apart than its diameter the ball is put in the middle.
void SweptStep::snapToFaces() {
    Ball forwards = m_ball, backwards = m_ball;
    const auto snap = [&](const Contact &contact, Ball &ball) {
        if (contact.isFace()) snapToFace(m_context, contact, ball);
    };
    for (uint32_t i = 0; i < m_contacts.count(); ++i) {
        snap(m_contacts[i], forwards);
        snap(m_contacts[m_contacts.count() - 1 - i], backwards);
    }
    m_ball.position = 0.5 * (forwards.position + backwards.position);
    m_ball.velocity = forwards.velocity;
}

/// A ball too slow to bounce is stopped at several contacts as in an impact: no contact pulls it back.
void SweptStep::stopSlowApproach() {
    const bool approaches = std::any_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &contact) {
        return glm::dot(m_ball.velocity, contact.normal) < -m_slow;
    });
    if (!approaches) return;
    Motion motion = motionOf(m_ball);
    Work work; // limited as for a step of `exact`
    resolveImpacts(m_contacts, m_context.radius(), motion, work);
    setMotion(motion, m_ball); // no event and no loss is reported: the amount is of the scheme's own order
}

/// Removes the speed along the normals of the contacts from a velocity. Where normals are nearly parallel this would
/// remove far more than the ball's speed along them: it leaves one of them then, or keeps a negligible speed along it.
void SweptStep::keepContacts(const Vec3 &velocity) {
    for (;;) {
        NormalSpan kept;
        double fastest = 0.0; // of the contacts that it leaves
        double most = m_slow;
        for (const Contact &contact : m_contacts) {
            const double speed = glm::dot(velocity, contact.normal);
            kept.add(contact.normal);
            fastest = std::max(fastest, speed);
            most = std::max(most, kMostTaken * std::abs(speed));
        }
        if (loseSpeedAlong(kept, most, velocity) || fastest <= m_slow) return;
        m_contacts.drop([&](const Contact &contact) { return glm::dot(velocity, contact.normal) == fastest; });
    }
}

/// Gives the ball that velocity without its component along these normals. False, with all of it, if that would take
/// more than `most` from a ball that isn't bound.
bool SweptStep::loseSpeedAlong(const NormalSpan &kept, double most, const Vec3 &velocity) {
    const Vec3 across = kept.across(velocity);
    const double taken = glm::length(across - velocity);
    const bool takesTooMuch = taken > most && !isBound(taken);
    m_ball.velocity = takesTooMuch ? velocity : across;
    return !takesTooMuch;
}

/// Whether a ball that approaches all its contacts at once rocks between them: too slow to climb out over any, and
/// gravity drives it into each while the others hold it.
bool SweptStep::isBound(double speed) const {
    const Vec3 gravity = m_context.setting.gravity();
    const uint32_t count = m_contacts.count();
    const auto heldBut = [&](uint32_t free) {
        NormalSpan span;
        for (uint32_t i = 0; i < count; ++i) {
            if (i != free) span.add(m_contacts[i].normal);
        }
        return span.across(gravity);
    };
    const double size = glm::length(gravity), pull = glm::length(gravity - heldBut(count));
    for (uint32_t i = 0; i < count; ++i) {
        const Contact &contact = m_contacts[i];
        const double rise = pull + glm::dot(gravity, contact.normal); // per radius, times the pull
        const bool isDriven = glm::dot(heldBut(i), contact.normal) <= kStill * size;
        if (!isDriven || speed > contact.restSpeed || speed * speed > rise * m_context.radius()) return false;
    }
    return true;
}

/// Of the contacts that the ball leaves slowly, keeps those that press if the ball doesn't leave them now; it may
/// later.
void SweptStep::dropWhatNothingPresses(const Vec3 &velocity, double negligible) {
    std::array<bool, Contacts::kMost> presses;
    pressesNow(presses);
    NormalSpan kept;
    double most = m_slow;
    const bool *pressing = presses.data();
    m_contacts.drop([&](const Contact &contact) {
        const double speed = glm::dot(velocity, contact.normal);
        const bool lasts = *pressing++ || speed <= negligible;
        if (lasts) {
            kept.add(contact.normal);
            most = std::max(most, kMostTaken * std::abs(speed));
        }
        return !lasts;
    });
    loseSpeedAlong(kept, most, velocity);
}

void SweptStep::finishPhase(double t) {
    const Ball end = at(t);
    if (m_context.report.wanted()) {
        Work again; // a report changes no status either
        move(t, m_context.report, again, m_ball);
    }
    m_ball = end;
    if (t == m_stop) {
        m_ball.velocity = Vec3(0.0);
        m_ball.spin = Vec3(0.0, 0.0, m_context.isRigid() ? m_ball.spin.z : 0.0);
    }
    if (t == m_roll) {
        // What the order left of the slip: 2/7 of it becomes speed, the rest spin, and no energy is added.
        const Vec3 rest = 2.0 / 7.0 * slipOnTop(m_ball);
        m_ball.velocity -= rest;
        m_ball.spin += 2.5 / m_context.radius() * glm::cross(Vec3(0.0, 0.0, 1.0), rest);
        m_context.report.lostSlip(1.75 * glm::dot(rest, rest));
    }
    const bool isSlaved = m_ball.supported && !m_context.isRigid();
    if (isSlaved) m_ball.spin = rollingSpin(inPlane(m_ball.velocity), m_context.radius());
}

/// When `left`, which falls linearly within the order from `start` on, reaches 0; INFINITY if not before `end`.
template<class Left>
double SweptStep::timeToZero(double end, double start, Left left) const {
    constexpr int kMostHalvings = 60;
    double t = end, rest = left(at(t));
    if (rest > kZero * start) return INFINITY;
    for (int i = 0; i < kMostHalvings && rest <= kZero * start; ++i) rest = left(at(t *= 0.5));
    // A value that grows at first is examined again from there.
    return rest < start ? std::min(end, t * start / (start - rest)) : t;
}

/// Near its end a slip turns ever faster: phases halve its remainder until an error of first order in it is one of
/// second order in the step. Such a last phase ends at the slip that remains, as the law requires where friction
/// depends on the pressure that it causes: there a slip ends at once.
double SweptStep::timeToSlipEnd(double end) {
    m_slipEnds = false;
    if (!m_context.isRigid() || m_isAlone || m_contacts.empty()) return end;
    const double radius = m_context.radius();
    constexpr double kShortest = 1.0 / 1024.0; // of a substep
    const double gravity = glm::length(m_context.setting.gravity());
    const double last = m_substep * glm::clamp(m_substep * std::sqrt(gravity / radius), kShortest, kSoon);
    const double none = std::max(kRolling * (glm::length(m_ball.velocity) + radius * glm::length(m_ball.spin)), m_slow);
    const Motion start = motionOf(m_ball);
    Motion after = start;
    const auto visitSlips = [&](auto visit) { // the remainder of each nonzero slip, m/s
        for (const Contact &contact : m_contacts) {
            const Vec3 slip = slipAt(start, contact.normal, radius);
            const double speed = glm::length(slip);
            if (contact.friction == 0.0 || speed <= none) continue;
            visit(glm::dot(slipAt(after, contact.normal, radius), slip) / speed, speed);
        }
    };
    // All are examined at the same times, so that the order of contacts doesn't matter.
    double t = end, ended = INFINITY;
    for (;; t *= 0.25) {
        after = motionOf(at(t));
        m_slipEnds = false;
        visitSlips([&](double left, double speed) { m_slipEnds = m_slipEnds || left <= kZero * speed; });
        if (m_slipEnds) ended = t;
        if (!m_slipEnds || t <= last) break;
    }
    // Too short a phase may leave a jam without a solution that has friction.
    const double changed = glm::length(after.velocity - start.velocity) + radius * glm::length(after.spin - start.spin);
    if (!m_slipEnds && ended < INFINITY && changed <= kRolling * gravity * t) {
        m_slipEnds = true;
        return ended;
    }
    double shortest = end;
    visitSlips([&](double left, double speed) {
        const double rest = std::max(0.0, left);
        const double half = rest < speed ? 0.5 * t * speed / (speed - rest) : t;
        shortest = std::min(shortest, std::max(last, half));
    });
    return shortest;
}

/// Resistance ends when the ball stops, and begins when a slip ends: neither may be inside a phase.
double SweptStep::timeToStopOrRoll(double end) {
    m_stop = m_roll = INFINITY;
    if (m_context.params().rolling_friction == 0.0) return end;
    const double speed = glm::length(m_ball.velocity);
    const Vec3 slip = slipOnTop(m_ball);
    const double slipSpeed = glm::length(slip);
    const bool slips = slipSpeed > kRolling * (speed + m_context.radius() * glm::length(m_ball.spin));
    if (slips && m_isAlone) { // it may turn on its way; beside other contacts it ends in a short phase: see above
        const Law<Vec2> law = slippingLaw(m_context.params());
        m_roll = ResistedLaw(inPlane(slip), law.A, law.B).stopTime();
    } else if (!slips && m_resists && speed > 0.0) { // resistance acts on a rolling ball
        const Vec3 direction = m_ball.velocity / speed;
        m_stop = timeToZero(end, speed, [&](const Ball &ball) { return glm::dot(ball.velocity, direction); });
    }
    return std::min({end, m_stop, m_roll});
}

/// Slip at the top face that carries the ball; 0 without one, and in the rolling model.
Vec3 SweptStep::slipOnTop(const Ball &ball) const {
    const bool isOnTop =
        std::any_of(m_contacts.begin(), m_contacts.end(), [](const Contact &contact) { return contact.isTop; });
    if (!isOnTop || !m_context.isRigid()) return Vec3(0.0);
    return slipAt(motionOf(ball), Vec3(0.0, 0.0, 1.0), m_context.radius());
}

/// How much of this phase may be examined in one piece, s: the rest of the step, halved until nothing is near the path.
double SweptStep::horizon() const {
    const double rest = m_input.dt - m_done;
    const bool isParabola = m_isAlone || m_contacts.empty();
    if (isParabola && rest > m_substep) {
        const double clear = longestClear(rest);
        if (clear > 0.0) return clear;
    }
    return std::min({rest, safeTimeOfPhase(), m_hopEnd});
}

/// The rest of the step (s), halved as seldom as makes the path clear; 0 if it is clear for no more than a substep. A
/// path that is free for longer is free for less; the search begins at the halvings of the last phase.
double SweptStep::longestClear(double rest) const {
    const auto halved = [&](int times) { return std::ldexp(rest, -times); };
    int most = std::ilogb(rest / m_substep);
    if (most > 0 && !(halved(most) > m_substep)) --most;
    int tooLong = -1, clear = most + 1, stride = 1;
    for (int times = std::min(m_halvings, most); clear - tooLong > 1; stride *= 2) {
        (isClear(halved(times)) ? clear : tooLong) = times;
        times += times == clear ? -stride : stride;
        if (times <= tooLong || times >= clear) times = (tooLong + clear) / 2;
    }
    m_halvings = clear;
    return clear > most ? 0.0 : halved(clear);
}

/// The time in which the ball moves by at most half its radius, and by a quarter more due to its spin, s.
double SweptStep::safeTimeOfPhase() const {
    double friction = 0.0;
    for (const Contact &contact : m_contacts) friction = std::max(friction, contact.friction);
    const double radius = m_context.radius();
    const double gravity = glm::length(m_context.setting.gravity());
    const double speed = glm::length(m_ball.velocity);
    if (m_isAlone) { // the pressure is known, and friction turns at most 2/7 of the slip into speed
        const double ofSlip = 2.0 / 7.0 * glm::length(slipOnTop(m_ball));
        return std::max(safeTime(radius, (1.0 + friction) * gravity, speed), safeTime(radius, gravity, speed + ofSlip));
    }
    const double forWay = safeTime(radius, gravity, speed);
    return friction == 0.0 ? forWay : std::min(forWay, safeTimeOfSpin(m_input, m_ball));
}

} // namespace phys
