// SPDX-License-Identifier: MIT
#include "contact_step.h"

#include "contact/choice.h"
#include "contact/near.h"
#include "contact/push_out.h"
#include "scene/nearest.h"

#include <cmath>

namespace phys {

namespace {

/// Order 2: alternates between the end, which determines the normals, and the normals, which determine the end.
constexpr int kMidpointPasses = 3;

double kineticEnergy(const StepContext &context, const Motion &motion) {
    return 0.5 * glm::dot(motion.velocity, motion.velocity) + spinEnergy(motion.spin, context.radius());
}

Vec3 rollingSpinOf(const StepContext &context, const Ball &ball) {
    return rollingSpin(inPlane(ball.velocity), context.radius());
}

/// Normal of the same feature for another position of the centre; beyond its border that of the one it continues in.
Vec3 normalAt(const Contact &contact, const Vec3 &position) {
    Vec3 normal = contact.across(position - contact.point);
    if (contact.isFace()) return glm::normalize(normal);
    for (int axis = 0; axis < 3; ++axis) {
        if (normal[axis] * contact.sides[axis] < 0.0) normal[axis] = 0.0;
    }
    return normal == Vec3(0.0) ? contact.normal : glm::normalize(normal);
}

/// The energy dissipated by friction and resistance: each impulse times the mean motion that it opposes, model.md 13.5.
SmoothLoss lossOf(const StepContext &context, const LastingContacts &contacts, const Motion &before,
                  const Motion &after) {
    SmoothLoss loss;
    if (!context.report.wanted()) return loss;
    const double radius = context.radius();
    const Motion mean{0.5 * (before.velocity + after.velocity), 0.5 * (before.spin + after.spin)};
    for (const Lasting &contact : contacts) {
        const Vec3 slip = mean.velocity - radius * glm::cross(mean.spin, contact.lever);
        // Neither adds energy; a negative amount due to the order belongs to the scheme.
        loss.slip += std::max(0.0, -glm::dot(contact.rubbing, slip));
        loss.rolling += std::max(0.0, -0.4 * radius * radius * glm::dot(contact.resisting, mean.spin));
    }
    return loss;
}

/// The contacts at the end of a substep, and what they took.
struct HeldBall {
    LastingContacts contacts;
    SmoothLoss loss;
    bool jams; ///< no modes fit at the start
};

Lasting lastingOf(const Contact &contact, double slow) {
    Lasting lasting{};
    lasting.lever = lasting.limit = contact.normal;
    lasting.slow = slow;
    lasting.friction = contact.friction;
    lasting.isTop = contact.isTop;
    lasting.isGlued = contact.isGlued;
    lasting.load = -1.0;
    return lasting;
}

/// Determines which contacts press, stick and roll, if that isn't obvious: lasting contacts without impulses get those
/// of a substep h (s). Returns whether no modes fit.
bool choose(const StepContext &context, const Contacts &contacts, const Motion &motion, double h,
            LastingContacts &lasting) {
    const Moment moment{motion.velocity, motion.spin, context.setting.gravity(), context.radius()};
    return choose(contacts, moment, context.params().rolling_friction, h, context.work, lasting);
}

/// The explicit rule: the old velocity, with the new one's component along the normals of pressing contacts.
Vec3 mixedVelocity(const LastingContacts &contacts, const Vec3 &before, const Vec3 &after) {
    NormalSpan pressing;
    for (const Lasting &contact : contacts) {
        if (contact.reaction > 0.0) pressing.add(contact.lever);
    }
    return after - pressing.across(after - before);
}

/// Puts a ball onto the edge or corner that pressed it, off others only where their normals are nearly the same, and
/// removes its speed along the normal. Returns how far it was off, m.
double settleOn(const StepContext &context, const Contact &contact, const NormalSpan &others, Ball &ball) {
    constexpr double kNearlySame = 0.01; // sine of the angle
    const Vec3 offset = contact.across(ball.position - contact.point);
    const double distance = glm::length(offset);
    const Vec3 normal = offset / distance, along = others.across(normal);
    const double off = context.radius() - distance, share = glm::dot(along, normal);
    const bool isAlone = along == normal || share < kNearlySame * kNearlySame;
    ball.position += isAlone ? off * normal : off / share * along;
    ball.velocity -= glm::dot(ball.velocity, normal) * normal;
    return std::abs(off);
}

/// Puts the ball onto what pressed until the end, at all places together.
void settleOnAll(const StepContext &context, const Contacts &contacts, const LastingContacts &lasting, Ball &ball) {
    constexpr int kMostSettlingSweeps = 40;
    const double near = 0.25 * context.setting.tolerance;
    double off = INFINITY;
    uint32_t pressing = 0;
    for (int i = 0; i < kMostSettlingSweeps && off > near && (i == 0 || pressing > 1); ++i) {
        off = 0.0;
        pressing = 0;
        NormalSpan settled;
        for (const bool areFaces : {true, false}) {
            for (uint32_t k = 0; k < contacts.count(); ++k) {
                if (!(lasting.begin()[k].reaction > 0.0) || contacts[k].isFace() != areFaces) continue;
                ++pressing;
                if (areFaces)
                    snapToFace(context, contacts[k], ball);
                else
                    off = std::max(off, settleOn(context, contacts[k], settled, ball));
                settled.add(normalAt(contacts[k], ball.position));
            }
        }
    }
    if (pressing < 2) return;
    NormalSpan span;
    double fastest = 0.0;
    for (uint32_t k = 0; k < contacts.count(); ++k) {
        if (!(lasting.begin()[k].reaction > 0.0)) continue;
        const Vec3 normal = normalAt(contacts[k], ball.position);
        span.add(normal);
        fastest = std::max(fastest, std::abs(glm::dot(ball.velocity, normal)));
    }
    const Vec3 across = span.across(ball.velocity);
    if (glm::distance(across, ball.velocity) <= kMostTaken * fastest) ball.velocity = across;
}

/// What pressed until the end stays in contact: where only friction presses the ball, it would fly off what is left of
/// a gap or of a speed. Not where it is farther off than it comes within h, as between nearly opposite normals.
void stayInContact(const StepContext &context, const Contacts &contacts, const LastingContacts &lasting,
                   const Motion &before, double h, Ball &ball) {
    Ball settled = ball;
    settleOnAll(context, contacts, lasting, settled);
    const double fastest = glm::length(before.velocity) + h * glm::length(context.setting.gravity());
    if (glm::distance(ball.position, settled.position) <= h * fastest) ball = settled;
}

/// Two contacts that stick can't approach each other, but by prestress.
bool twoStick(const LastingContacts &lasting) {
    if (lasting.isPrestressed()) return false; // they slip along the line through both instead
    return std::count_if(lasting.begin(), lasting.end(), [](const Lasting &contact) { return contact.sticks(); }) > 1;
}

/// Whether the normals of contacts of order 1 turn within the substep as the ball goes round an edge or a corner: where
/// modes are chosen, and where such a normal and friction press the ball onto other contacts.
bool normalsTurn(const StepContext &context, const Contacts &contacts, const LastingContacts &lasting) {
    if (!context.isRigid()) return lasting.isChosen();
    const auto turns = [&](const Contact &contact) {
        return !contact.isFace() && (lasting.isChosen() || contact.sides[2] != 0);
    };
    return contacts.count() > 1 && std::any_of(contacts.begin(), contacts.end(), turns) && !twoStick(lasting);
}

/// Whether a touched rough contact opens at once: pressure of the scheme's order would rub with all of its friction.
bool opensAtOnce(const StepContext &context, const Contacts &contacts, uint32_t i, double curving,
                 const LastingContacts &lasting) {
    const Contact &contact = contacts[i];
    if (contact.friction == 0.0 || !touches(context, contact)) return false;
    if (contacts.count() > 1) return lasting.isChosen() && lasting[i].reaction == 0.0;
    return glm::dot(context.setting.gravity(), contact.normal) + curving > 0.0;
}

/// Lets the ball approach contacts along the normals of the start as it goes round them: all, or those that open.
void goRound(const StepContext &context, const Contacts &contacts, const Vec3 &velocity, double h, bool all,
             LastingContacts &lasting) {
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        const double curving = contacts[i].curving(velocity, context.radius());
        if (all || opensAtOnce(context, contacts, i, curving, lasting)) lasting[i].slow -= h * curving;
    }
}

/// The contacts of a substep of order 1, which changes the motion; turn: whether their normals do. Contacts only take
/// energy from it: where the solution adds some, as several sticking contacts turn the ball to close their gaps, the
/// gaps stay. jams: whether no modes fit.
LastingContacts closeGaps(const StepContext &context, const Contacts &contacts, double h, Motion &motion, bool &turn,
                          bool &jams) {
    constexpr double kMostGain = 1e-12;
    const Motion before = motion;
    Motion driven = motion;
    driven.velocity += h * context.setting.gravity();
    bool mayTurn = true;
    const auto solve = [&](double time) { // s, in which the gaps are closed
        LastingContacts lasting(context.radius(), context.work);
        for (const Contact &contact : contacts)
            lasting.add(lastingOf(contact, touches(context, contact) ? 0.0 : -contact.gap / time));
        jams = choose(context, contacts, before, h, lasting);
        turn = mayTurn && normalsTurn(context, contacts, lasting);
        goRound(context, contacts, before.velocity, h, turn, lasting);
        motion = driven;
        lasting.solve(context.params().rolling_friction, motion);
        return lasting;
    };
    LastingContacts closing = solve(h);
    mayTurn = !turn || !twoStick(closing);
    if (!mayTurn) closing = solve(h);
    const double fallen = h * glm::dot(context.setting.gravity(), motion.velocity);
    const double gain = kineticEnergy(context, motion) - kineticEnergy(context, before) - fallen;
    if (!(gain > kMostGain * kineticEnergy(context, driven))) return closing;
    return solve(INFINITY);
}

/// Between two nearly opposite normals what rounding leaves of the speed along them becomes thousands of times faster
/// across, which could lift a ball that they hold. driven: a speed (m/s) of the size of those before.
void stopBetween(const LastingContacts &contacts, double driven, Motion &motion) {
    constexpr double kNearlyOpposite = 1e-3; // half the length of their sum
    NormalSpan held;
    bool areOpposite = false;
    for (const Lasting &contact : contacts) {
        const bool isHeld = contact.reaction > 0.0 && contact.slow == 0.0 &&
                            std::abs(glm::dot(motion.velocity, contact.limit)) <= kStill * driven;
        if (!isHeld) continue;
        held.add(contact.limit);
        for (const Lasting &other : contacts) {
            const bool isOpposite = glm::length(other.limit + contact.limit) <= 2.0 * kNearlyOpposite;
            areOpposite = areOpposite || (isOpposite && other.reaction > 0.0 && other.slow == 0.0);
        }
    }
    if (areOpposite) motion.velocity = held.across(motion.velocity);
}

HeldBall holdFirstOrder(const StepContext &context, const Contacts &contacts, ContactRule kind, double h, Ball &ball) {
    const Motion before = motionOf(ball);
    Motion motion = before;
    bool turn = false, jams = false;
    const LastingContacts lasting = closeGaps(context, contacts, h, motion, turn, jams);
    const SmoothLoss loss = lossOf(context, lasting, before, motion);
    const bool isExplicit = kind == ContactRule::Explicit;
    stopBetween(lasting, glm::length(before.velocity) + h * glm::length(context.setting.gravity()), motion);
    const Vec3 moving = isExplicit ? mixedVelocity(lasting, before.velocity, motion.velocity) : motion.velocity;
    ball.position += h * moving;
    setMotion(motion, ball);
    if (kind == ContactRule::Closing || turn) {
        stayInContact(context, contacts, lasting, before, h, ball);
        return {lasting, loss, jams};
    }
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        const bool arrives = lasting.begin()[i].reaction > 0.0 && contacts[i].isFace();
        if (arrives) snapToFace(context, contacts[i], ball);
    }
    return {lasting, loss, jams};
}

/// Impulses act along the normals half-way, conditions along those at the end; friction opposes the mean slip, or that
/// at the end: model.md 13.5.
LastingContacts midpointContacts(const StepContext &context, const Contacts &contacts, ContactRule kind,
                                 const Ball &ball, const Vec3 &way) {
    const double radius = context.radius();
    LastingContacts lasting(radius, context.work);
    const double rolling = kRolling * (glm::length(ball.velocity) + radius * glm::length(ball.spin));
    for (const Contact &contact : contacts) {
        Lasting next = lastingOf(contact, 0.0);
        next.lever = normalAt(contact, ball.position + 0.5 * way);
        next.limit = normalAt(contact, ball.position + way);
        if (kind == ContactRule::SecondOrder) {
            next.slipBefore = slipAt(motionOf(ball), contact.normal, radius);
            if (glm::length(next.slipBefore) <= rolling) next.spinBefore = ball.spin;
        }
        lasting.add(next);
    }
    return lasting;
}

/// At the end, contacts that stick have no slip along their normals there. What the turn of the normals left of it
/// would count as a slip that is still to end.
HeldBall holdTurning(const StepContext &context, const Contacts &contacts, ContactRule kind, double h, Ball &ball) {
    const Motion before = motionOf(ball);
    Motion driven = before;
    driven.velocity += h * context.setting.gravity();
    Motion motion = before;
    const auto way = [&] {
        const bool isMean = kind == ContactRule::SecondOrder;
        return h * (isMean ? 0.5 * (before.velocity + motion.velocity) : motion.velocity);
    };
    LastingContacts lasting(context.radius(), context.work);
    bool jams = false;
    // The normals of faces don't turn.
    const bool turns =
        std::any_of(contacts.begin(), contacts.end(), [](const Contact &contact) { return !contact.isFace(); });
    for (int pass = 0; pass < (turns ? kMidpointPasses : 1); ++pass) {
        LastingContacts next = midpointContacts(context, contacts, kind, ball, way());
        for (Lasting *last = lasting.begin(), *contact = next.begin(); last != lasting.end(); ++last, ++contact) {
            contact->reaction = last->reaction;
            contact->rubbing = last->rubbing;
        }
        if (lasting.isChosen()) next.keep(lasting);
        if (pass == 0) jams = choose(context, contacts, before, h, next);
        lasting = next;
        motion = driven;
        lasting.solve(context.params().rolling_friction, motion);
    }
    const SmoothLoss loss = lossOf(context, lasting, before, motion);
    ball.position += way();
    setMotion(motion, ball);
    stayInContact(context, contacts, lasting, before, h, ball);
    return {lasting, loss, jams};
}

/// Whether contacts, with friction and resistance, can hold a ball at rest: model.md 13.5.
bool canHold(const StepContext &context, const Contacts &contacts) {
    const Vec3 gravity = context.setting.gravity();
    const double left = kStill * glm::length(gravity);
    LastingContacts lasting(context.radius(), context.work);
    for (const Contact &contact : contacts) {
        if (contact.gap < -context.setting.tolerance) return false;
        lasting.add(lastingOf(contact, 0.0));
    }
    // One second of gravity, as a velocity: what the contacts leave of it corresponds to an acceleration.
    choose(context, contacts, {Vec3(0.0), Vec3(0.0)}, 1.0, lasting);
    Motion motion{gravity, Vec3(0.0)};
    lasting.solve(context.params().rolling_friction, motion);
    return glm::length(motion.velocity) <= left && context.radius() * glm::length(motion.spin) <= left;
}

/// Whether a ball at rest on a floor, between smooth upright faces, stays so, including the limit: model.md 6.3.
/// Nothing if it touches anything else.
std::optional<bool> holdsOnFloor(const StepContext &context, const Contacts &contacts) {
    Law<Vec2> law = rollingLaw(context.params());
    if (!context.rubsOnFloor()) law.B = 0.0;
    bool hasFloor = false;
    for (const Contact &contact : contacts) {
        if (contact.gap < -context.setting.tolerance) return {};
        hasFloor = hasFloor || contact.isTop;
        if (contact.isTop) continue;
        if (!contact.isFace() || contact.sides[2] != 0 || context.hasRoughWalls()) return {};
        const int axis = contact.sides[0] ? 0 : 1;
        if (law.A[axis] * contact.sides[axis] < 0.0) law.A[axis] = 0.0;
    }
    if (!hasFloor) return {};
    return context.params().gravity.z <= 0.0 && glm::dot(law.A, law.A) <= law.B * law.B;
}

HeldBall holdInThisOrder(const StepContext &context, const Contacts &contacts, ContactRule kind, double h, Ball &ball) {
    const bool turns = kind == ContactRule::SecondOrder || kind == ContactRule::EndingSlip;
    return (turns ? holdTurning : holdFirstOrder)(context, contacts, kind, h, ball);
}

/// A jam among touched contacts ends as in `exact`, model.md 14.1. end: endJam, or stopJam. False if it can't.
bool endJamBy(decltype(endJam) end, const StepContext &context, const Contacts &contacts, double h, Ball &ball) {
    const bool allTouched = std::all_of(contacts.begin(), contacts.end(),
                                        [&](const Contact &contact) { return touches(context, contact); });
    Moment moment{ball.velocity, ball.spin, context.setting.gravity(), context.radius()};
    const double resistance = context.params().rolling_friction;
    if (!allTouched || !end(contacts, resistance, h, context.work, moment)) return false;
    const double before = kineticEnergy(context, motionOf(ball));
    setMotion({moment.velocity, moment.spin}, ball);
    context.report.lostSlip(before - kineticEnergy(context, motionOf(ball)));
    return true;
}

} // namespace

void snapToFace(const StepContext &context, const Contact &contact, Ball &ball) {
    for (int axis = 0; axis < 3; ++axis) {
        if (contact.sides[axis] == 0) continue;
        ball.position[axis] = contact.point[axis] + contact.sides[axis] * context.radius();
        if (touches(context, contact)) ball.velocity[axis] = 0.0;
    }
}

void lookAhead(const StepContext &context, const Ball &ball, std::span<const Vec3> ways, double h, Contacts &contacts) {
    findContacts(context.setting, ball.position, motionOf(ball), ways, contacts);
    contacts.dropHidden(context.setting.tolerance);
    const Vec3 gravity = context.setting.gravity();
    for (Contact &contact : contacts) {
        const double pressing = std::max(0.0, -glm::dot(gravity, contact.normal));
        // Contact with an edge lasts only while the ball is pressed on it by more than its way round it curves.
        const double curving = std::min(pressing, contact.curving(ball.velocity, context.radius()));
        contact.restSpeed = 2.0 * h * (pressing + curving);
    }
}

SpinOnFloor::SpinOnFloor(const StepContext &context, const Contacts &contacts, const Ball &ball)
    : m_context(context)
    , m_before(ball.spin) {
    const double negligible = negligibleSpeed(motionOf(ball), context.radius());
    m_isCarried = std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        return contact.isGlued && touches(context, contact) && std::abs(ball.velocity.z) <= negligible;
    });
    m_atImpact = m_isCarried ? rollingSpinOf(context, ball) : ball.spin;
}

void SpinOnFloor::follow(const Contacts &contacts, Ball &ball) {
    const double negligible = negligibleSpeed(motionOf(ball), m_context.radius());
    m_follows = std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        return contact.isGlued && ball.velocity.z <= std::max(contact.restSpeed, negligible);
    });
    if (!m_follows) return;
    ball.spin = rollingSpinOf(m_context, ball);
    m_jump = spinEnergy(m_atImpact, m_context.radius()) - spinEnergy(ball.spin, m_context.radius());
}

void SpinOnFloor::settle(bool presses, Ball &ball) const {
    if (!m_follows) return;
    if (!presses) {
        ball.spin = m_before;
        return;
    }
    ball.spin = rollingSpinOf(m_context, ball);
    // When a rolling ball hits a wall, the spin takes part in the impact; at a landing, friction gives or takes its
    // energy, as where a carried ball is given another spin.
    m_isCarried ? m_context.report.lostImpact(m_jump) : m_context.report.lostSlip(m_jump);
    m_context.report.lostSlip(spinEnergy(m_before, m_context.radius()) - spinEnergy(m_atImpact, m_context.radius()));
}

bool hold(const StepContext &context, const Contacts &contacts, ContactRule kind, double h, Ball &ball,
          std::span<bool> presses) {
    Ball start = ball;
    HeldBall held = holdInThisOrder(context, contacts, kind, h, ball);
    for (const auto end : {endJam, stopJam}) {
        if (!held.jams || !endJamBy(end, context, contacts, h, start)) continue;
        ball = start;
        held = holdInThisOrder(context, contacts, kind, h, ball);
    }
    SmoothLoss loss = held.loss;
    if (contacts.hasTies()) {
        // Contacts that compare equal: the mean of both orders favours none.
        Contacts reversed = contacts;
        reversed.reverseTies();
        Ball other = start;
        const SmoothLoss lossOfOther = holdInThisOrder(context, reversed, kind, h, other).loss;
        loss = {0.5 * (loss.rolling + lossOfOther.rolling), 0.5 * (loss.slip + lossOfOther.slip)};
        ball.position = 0.5 * (ball.position + other.position);
        ball.velocity = 0.5 * (ball.velocity + other.velocity);
        ball.spin = 0.5 * (ball.spin + other.spin);
    }
    book(loss, context.report);
    Motion motion = motionOf(ball);
    dropTraces(motionOf(start), context.radius(), motion);
    setMotion(motion, ball);
    bool onTop = false;
    for (size_t i = 0; const Lasting &contact : held.contacts) {
        const bool isPressed = contact.reaction > 0.0;
        onTop = onTop || (contact.isTop && contact.holds(ball.velocity));
        if (!presses.empty()) presses[i++] = isPressed;
    }
    return onTop;
}

bool leaveOverlaps(const StepContext &context, Ball &ball) {
    Work work;
    PushOut pushed = pushOut(context.scene(), ball.position, work);
    context.report.penetration(pushed.depth);
    context.report.passes(pushed.passes);
    if (pushed.passes > 0) context.work.add(work.done());
    return pushed.isFree;
}

bool payForLift(const StepContext &context, const Vec3 &way, Ball &ball) {
    const double lifted = -glm::dot(context.setting.gravity(), way);
    if (!(lifted > 0.0)) return true;
    const double kinetic = kineticEnergy(context, motionOf(ball));
    if (lifted > kinetic) return false;
    const double share = std::sqrt(1.0 - lifted / kinetic);
    ball.velocity *= share;
    ball.spin *= share;
    return true;
}

bool rests(const StepContext &context, Ball &ball) {
    const double radius = context.radius();
    const double still = kStill * std::sqrt(glm::length(context.setting.gravity()) * radius);
    if (glm::length(ball.velocity) > still) return false;
    // The rolling model's spin isn't independent: it ends with the velocity.
    if (context.isRigid() && radius * glm::length(ball.spin) > still) return false;
    Contacts contacts;
    // As at the start of the next step: the motion that is left must not decide.
    if (!findContacts(context.setting, ball.position, {Vec3(0.0), Vec3(0.0)}, Vec3(0.0), contacts)) return false;
    // In the air, which pulls nothing without gravity, the rolling model's spin stays as well.
    if (contacts.empty() && ball.spin != Vec3(0.0)) return false;
    // A ball that rolls on the floor alone keeps even the slowest motion.
    const bool isStill = ball.velocity == Vec3(0.0) && (!context.isRigid() || ball.spin == Vec3(0.0));
    if (!isStill && contacts.count() == 1 && contacts[0].isTop) return false;
    const std::optional<bool> holds = holdsOnFloor(context, contacts);
    if (!(holds ? *holds : canHold(context, contacts))) return false;
    if (!context.isRigid()) context.report.lostSlip(spinEnergy(ball.spin, radius));
    ball.velocity = Vec3(0.0);
    ball.spin = Vec3(0.0);
    return true;
}

} // namespace phys
