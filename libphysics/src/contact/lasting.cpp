// SPDX-License-Identifier: MIT
#include "contact/lasting.h"

#include "contact/coulomb_newton.h"
#include "contact/held.h"
#include "contact/least_push.h"

#include <cmath>

namespace phys {

namespace {

constexpr int kMostSweeps = 300;

/// Rounds of sweeps that find the reactions together: very rough contacts may alternate for ever. The longer limit is
/// for a slip far larger than the drive, where friction depends on the pressure that it causes.
constexpr int kUsuallyTogether = 40;
constexpr int kMostTogether = 100;

/// Sweeps after which Newton's method is tried for the first time; then after twice as many each time.
constexpr int kFirstNewton = 12;

/// Changes below this share of the speeds count as rounding.
constexpr double kNegligible = 1e-15;

/// Slips that friction ends are larger than what counts as rounding of one change by up to this factor.
constexpr double kLeftOfSlip = 1e4;

constexpr double kNotPressed = -1.0;

double size(const Vec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

bool areOpposite(const Lasting &a, const Lasting &b) { return size(a.lever + b.lever) <= kSameNormal; }

/// The smallest reaction that keeps the ball from approaching.
double reactionOf(const Lasting &contact, const Motion &motion) {
    const double missing = contact.slow - glm::dot(contact.limit, motion.velocity);
    return std::max(0.0, contact.reaction + missing / glm::dot(contact.limit, contact.lever));
}

/// Friction that ends the slip, or as much as Coulomb's cone allows, opposing the mean slip.
Vec3 frictionOf(Lasting &contact, const Motion &motion, double radius) {
    contact.isSpent = false;
    if (!contact.holds(motion.velocity) || (contact.friction == 0.0 && !contact.isGlued)) return Vec3(0.0);
    const Vec3 slip = slipAt(motion, contact.limit, radius);
    const Vec3 sticking = tangential(contact.rubbing - kEndsSlip * slip, contact.lever);
    const double most = contact.friction * contact.reaction;
    if (contact.hasNoLimit() || glm::dot(sticking, sticking) <= most * most) return sticking;
    contact.isSpent = true;
    return clipped(tangential(contact.rubbing - kEndsSlip * (contact.slipBefore + slip), contact.lever), most);
}

/// Resistance opposing the mean spin, at most as much as ends it.
Vec3 resistanceOf(const Lasting &contact, const Motion &motion, double most) {
    const Vec3 holding = tangential(contact.resisting - motion.spin, contact.lever);
    if (glm::dot(holding, holding) <= most * most) return holding;
    return clipped(tangential(contact.resisting - contact.spinBefore - motion.spin, contact.lever), most);
}

} // namespace

/// One Gauss-Seidel sweep, each contact in closed form; arePressed: the reactions are already those of all contacts.
/// Returns the largest change, m/s.
double LastingContacts::sweep(double rollingFriction, bool arePressed, Motion &motion) {
    double largest = 0.0;
    m_work->add(Work::kDisc * count());
    for (Lasting &contact : *this) {
        const double reaction = arePressed ? contact.reaction : reactionOf(contact, motion);
        const double pushed = reaction - contact.reaction;
        motion.velocity += pushed * contact.lever;
        contact.reaction = reaction;

        const Vec3 rubbing = frictionOf(contact, motion, m_radius);
        const Vec3 rubbed = rubbing - contact.rubbing;
        motion.velocity += rubbed;
        motion.spin -= 2.5 / m_radius * glm::cross(contact.lever, rubbed);
        contact.rubbing = rubbing;
        largest = std::max({largest, std::abs(pushed), size(rubbed)});

        if (rollingFriction == 0.0 || !contact.rolls) continue;
        const Vec3 resisting = resistanceOf(contact, motion, contact.mostResisting(rollingFriction, m_radius));
        const Vec3 resisted = resisting - contact.resisting;
        motion.spin += resisted;
        contact.resisting = resisting;
        largest = std::max(largest, m_radius * size(resisted));
    }
    return largest;
}

/// Whether sweeps would converge to the reactions too slowly. One sweep leaves the share cos^2 of an error, for the
/// angle between the normals. Opposite normals don't share a load: releaseOpposite. If there are more normals than
/// independent ones, some contact must open, and sweeps would shift its load in small steps.
bool LastingContacts::shareLoads() const {
    constexpr double kAligned = 0.9, kFlat = 0.1;
    if (count() > 3) return true;
    for (const Lasting *a = begin(); a != end(); ++a) {
        for (const Lasting *b = a + 1; b != end(); ++b) {
            if (std::abs(glm::dot(a->lever, b->lever)) > kAligned && !areOpposite(*a, *b)) return true;
        }
    }
    const LastingContacts &all = *this;
    return count() == 3 && std::abs(glm::dot(all[0].lever, glm::cross(all[1].lever, all[2].lever))) < kFlat;
}

/// The reactions of least sum of all contacts together, with friction unchanged: more normals than independent ones
/// leave a choice, model.md 14.1. Returns the largest change of the velocity (m/s), or kNotPressed if there is no
/// solution, in which case nothing is changed.
double LastingContacts::pressTogether(double negligible, Motion &motion) {
    Vec3 unpressed = motion.velocity;
    for (const Lasting &contact : *this) unpressed -= contact.reaction * contact.lever;
    const double enough = 8.0 * negligible;
    std::array<Push, kMostContacts> pushes;
    bool anyPresses = false;
    for (uint32_t i = 0; i < count(); ++i) {
        const Lasting &contact = (*this)[i];
        const double along = glm::dot(contact.limit, contact.lever);
        const double missing = contact.slow - glm::dot(contact.limit, unpressed);
        pushes[i] = {contact.lever, missing / along, contact.limit / along};
        anyPresses = anyPresses || missing > enough;
    }
    const std::optional<Vec3> pressed =
        anyPresses ? leastPushOfFew({pushes.data(), count()}, enough, *m_work) : Vec3(0.0);
    if (!pressed) return kNotPressed;
    for (uint32_t i = 0; i < count(); ++i) (*this)[i].reaction = pushes[i].amount;
    for (Lasting &contact : *this) contact.isIdle = contact.isGlued && isIdle(contact);
    const Vec3 velocity = unpressed + *pressed;
    const double changed = size(velocity - motion.velocity);
    motion.velocity = velocity;
    return changed;
}

/// Whether two other contacts press whose normals are in one plane with the contact's, which therefore doesn't.
bool LastingContacts::isIdle(const Lasting &contact) const {
    if (contact.reaction > 0.0) return false;
    const Lasting *first = nullptr;
    for (const Lasting &other : *this) {
        if (!(other.reaction > 0.0)) continue;
        const double volume = first ? glm::dot(contact.lever, glm::cross(first->lever, other.lever)) : 1.0;
        if (std::abs(volume) <= kSameNormal) return true;
        first = &other;
    }
    return false;
}

/// A solution far from the result of the sweeps is a different one, in which friction maintains the pressure that it
/// depends on.
bool LastingContacts::solveByNewton(double rollingFriction, double negligible, bool isLast, Motion &motion) {
    const LastingContacts before = *this;
    const Motion motionBefore = motion;
    const double most = isLast ? INFINITY : 2.0 * pressure();
    if (!solveCoulomb({{begin(), end()}, m_radius, rollingFriction, negligible, *m_work}, motion)) return false;
    m_needsNewton = pressure() <= most;
    if (m_needsNewton) return true;
    *this = before;
    motion = motionBefore;
    return false;
}

/// False if that doesn't converge.
bool LastingContacts::settle(double rollingFriction, double negligible, bool releases, Motion &motion) {
    int nextNewton = m_needsNewton ? 0 : kFirstNewton;
    for (int i = 0; i < kMostSweeps; ++i) {
        if (i == nextNewton) {
            nextNewton = std::max(kFirstNewton, 2 * nextNewton);
            const bool isSolved = solveByNewton(rollingFriction, negligible, i > kMostSweeps / 2, motion);
            if (isSolved && !(releases && releaseOpposite(negligible))) return true;
        }
        const bool isSettled = sweep(rollingFriction, false, motion) <= negligible;
        const bool isReleased = releases && releaseOpposite(negligible);
        if (isSettled && !isReleased) return true;
    }
    return false;
}

/// The same for contacts that share loads.
bool LastingContacts::settleTogether(double rollingFriction, double negligible, int most, Motion &motion) {
    for (int i = 0; i < most; ++i) {
        const double pressed = pressTogether(negligible, motion);
        const bool arePressed = pressed != kNotPressed;
        const double swept = sweep(rollingFriction, arePressed, motion);
        const bool isSettled = swept <= negligible && (!arePressed || pressed <= negligible);
        const bool isReleased = releaseOpposite(negligible);
        if (isSettled && !isReleased) return true;
    }
    return solvePressed(rollingFriction, negligible, motion);
}

/// Whether it presses, or is glued by choice without pressure.
bool LastingContacts::takesPart(const Lasting &contact) const {
    return contact.reaction > 0.0 || (m_isChosen && contact.isGlued && !contact.isIdle);
}

/// Newton's method for the contacts that press, where friction that depends on the pressure of another contact settles
/// too slowly. The others must stay open: sweeps of all might press them, against a solution with a smaller sum.
bool LastingContacts::solvePressed(double rollingFriction, double negligible, Motion &motion) {
    LastingContacts pressed(m_radius, *m_work);
    for (const Lasting &contact : *this) {
        if (takesPart(contact)) pressed.add(contact);
    }
    if (pressed.count() == 0 || pressed.count() == count()) return false;
    Motion solved = motion;
    if (!solveCoulomb({{pressed.begin(), pressed.end()}, m_radius, rollingFriction, negligible, *m_work}, solved))
        return false;
    const bool stayOpen = std::all_of(begin(), end(), [&](const Lasting &contact) {
        return takesPart(contact) || glm::dot(contact.limit, solved.velocity) >= contact.slow - 8.0 * negligible;
    });
    if (!stayOpen) return false;
    const Lasting *next = pressed.begin();
    for (Lasting &contact : *this) {
        if (takesPart(contact)) contact = *next++;
    }
    motion = solved;
    return true;
}

void LastingContacts::unload() {
    for (Lasting &contact : *this) {
        contact.reaction = 0.0;
        contact.rubbing = contact.resisting = Vec3(0.0);
        contact.isIdle = contact.rolls = contact.closes = false;
        contact.load = -1.0;
    }
}

/// driven: the motion without any impulse. Where friction depends on itself, sweeps may not converge: squeezing is then
/// kept. A slip that reverses within the substep can have no friction of order 2, neither that of a slip nor that of
/// sticking: then its end alone determines the direction. If nothing helps, friction is dropped.
void LastingContacts::settleWithoutResistance(double negligible, const Motion &driven, Motion &motion) {
    const auto startAnew = [&] {
        unload();
        motion = driven;
    };
    if (shareLoads()) {
        if (settleTogether(0.0, negligible, kUsuallyTogether, motion)) return;
        startAnew();
    }
    if (settle(0.0, negligible, true, motion)) return;
    startAnew();
    if (settleTogether(0.0, negligible, kMostTogether, motion)) return;
    startAnew();
    if (settle(0.0, negligible, false, motion)) return;
    startAnew();
    for (Lasting &contact : *this) contact.slipBefore = Vec3(0.0);
    if (settle(0.0, negligible, true, motion)) return;
    startAnew();
    for (Lasting &contact : *this) contact.friction = 0.0;
    if (!settleTogether(0.0, negligible, kUsuallyTogether, motion)) settle(0.0, negligible, true, motion);
}

/// Parallel faces as far apart as the ball is wide may squeeze it without moving anything, but friction depends on the
/// squeeze. The law takes the smallest reactions, model.md 14.1. Returns whether there was a squeeze.
bool LastingContacts::releaseOpposite(double negligible) {
    bool any = false;
    for (Lasting *a = begin(); a != end(); ++a) {
        for (Lasting *b = a + 1; b != end(); ++b) {
            const double squeeze = std::min(a->reaction, b->reaction);
            if (squeeze <= negligible || !areOpposite(*a, *b)) continue;
            a->reaction -= squeeze;
            b->reaction -= squeeze;
            any = true;
        }
    }
    return any;
}

bool LastingContacts::slips(const Lasting &contact, double negligible, const Motion &motion) const {
    return size(slipAt(motion, contact.limit, m_radius)) > kLeftOfSlip * negligible;
}

bool LastingContacts::isStill(const Lasting &contact, double negligible, const Motion &motion) const {
    return contact.reaction > 0.0 && (contact.closes || !slips(contact, negligible, motion));
}

namespace {

bool isAllowed(const Lasting &contact) {
    return contact.rolls || contact.closes ? contact.reaction > 0.0 : contact.sticks();
}

/// Presses two contacts against each other along the line between their points by what leaves the least friction.
/// Returns how much that is, m/s; nothing if their normals are parallel.
std::optional<double> relievePair(Lasting &a, Lasting &b) {
    const Vec3 line = a.lever - b.lever;
    const Vec3 acrossA = tangential(line, a.lever);
    const Vec3 acrossB = tangential(line, b.lever);
    const double size = glm::dot(acrossA, acrossA) + glm::dot(acrossB, acrossB);
    if (size <= kNegligible) return {};
    const double share = (glm::dot(b.rubbing, acrossB) - glm::dot(a.rubbing, acrossA)) / size;
    a.reaction += share * glm::dot(line, a.lever);
    a.rubbing += share * acrossA;
    b.reaction -= share * glm::dot(line, b.lever);
    b.rubbing -= share * acrossB;
    a.isSpent = b.isSpent = false;
    return std::abs(share);
}

} // namespace

/// Two sticking contacts can be pressed against each other along the line between their points without moving anything.
/// Of all such solutions the law takes the one with the least friction, model.md 13.3, to which this changes if the
/// cones allow it. One of them may be at its limit by this pressure alone.
LastingContacts::Strain LastingContacts::relieve(double negligible, const Motion &motion) {
    Strain strain{0.0, false};
    if (countStill(negligible, motion) > 2) {
        if (const std::optional<double> relieved = relieveTogether(negligible, motion)) return {*relieved, false};
        strain.remains = true;
    }
    for (Lasting *a = begin(); a != end(); ++a) {
        for (Lasting *b = a + 1; b != end(); ++b) {
            if (!isStill(*a, negligible, motion) || !isStill(*b, negligible, motion)) continue;
            Lasting relievedA = *a;
            Lasting relievedB = *b;
            const std::optional<double> share = relievePair(relievedA, relievedB);
            if (!share) continue;
            if (!isAllowed(relievedA) || !isAllowed(relievedB)) {
                strain.remains = true;
                continue;
            }
            *a = relievedA;
            *b = relievedB;
            strain.relieved = std::max(strain.relieved, *share);
        }
    }
    return strain;
}

/// The same for three contacts or more, whose pairs share contacts: all pairs are relieved before the cones are asked.
/// Returns the largest pressure, or nothing if the cones don't allow it.
std::optional<double> LastingContacts::relieveTogether(double negligible, const Motion &motion) {
    constexpr int kMostRounds = 200;
    LastingContacts still(m_radius, *m_work);
    for (const Lasting &contact : *this) {
        if (isStill(contact, negligible, motion)) still.add(contact);
    }
    double most = 0.0, last = INFINITY;
    for (int i = 0; i < kMostRounds && last > negligible; ++i) {
        last = 0.0;
        for (Lasting *a = still.begin(); a != still.end(); ++a) {
            for (Lasting *b = a + 1; b != still.end(); ++b) last = std::max(last, relievePair(*a, *b).value_or(0.0));
        }
        most = std::max(most, last);
    }
    if (!std::all_of(still.begin(), still.end(), isAllowed)) return {};
    const Lasting *next = still.begin();
    for (Lasting &contact : *this) {
        if (isStill(contact, negligible, motion)) contact = *next++;
    }
    return most;
}

uint32_t LastingContacts::countStill(double negligible, const Motion &motion) const {
    return static_cast<uint32_t>(
        std::count_if(begin(), end(), [&](const Lasting &contact) { return isStill(contact, negligible, motion); }));
}

/// A pair that closes a gap slips along the line between its points, which is no slip of the motion: where the friction
/// that keeps the pair from any other slip, with the least pressure between them, is within the cones, both stick.
/// Otherwise that pressure would grow until a cone is reached, and the slip along the line would decide what rolls.
void LastingContacts::stickWhileClosing(double negligible, Motion &motion) {
    for (Lasting *a = begin(); a != end(); ++a) {
        for (Lasting *b = a + 1; b != end(); ++b) {
            const bool isClosing = a->slow < 0.0 || b->slow < 0.0;
            const bool areRough = a->reaction * a->friction > 0.0 && b->reaction * b->friction > 0.0;
            if (isClosing && areRough && sticksWhileClosing(*a, *b, negligible, motion)) return;
        }
    }
}

bool LastingContacts::sticksWhileClosing(Lasting &a, Lasting &b, double negligible, Motion &motion) {
    if (!slips(a, negligible, motion) && !slips(b, negligible, motion)) return false;
    const LastingContacts before = *this;
    const Motion motionBefore = motion;
    a.closes = b.closes = true;
    if (solveCoulomb({{begin(), end()}, m_radius, 0.0, negligible, *m_work}, motion)) {
        relieve(negligible, motion);
        m_needsNewton = a.sticks() && b.sticks();
        if (m_needsNewton) return true;
    }
    *this = before;
    motion = motionBefore;
    return false;
}

/// Contacts that stick only by such a pressure may slip instead, at less: friction must not maintain the pressure on
/// which it depends, model.md 14.1. Reactions found without friction first, with which friction then grows, are the
/// smallest. Three that stick only so may even press less than where one of them opens, and aren't a solution.
void LastingContacts::settleFromBelow(double negligible, const Motion &driven, Motion &motion) {
    LastingContacts other = *this;
    Motion after = driven;
    other.unload();
    if (!other.settleTogether(0.0, negligible, kMostTogether, after)) return;
    const bool isLess = other.pressure() < pressure() - negligible;
    if (!isLess && (countStill(negligible, motion) < 3 || other.relieve(negligible, after).remains)) return;
    std::copy(other.begin(), other.end(), begin());
    motion = after;
}

double LastingContacts::pressure() const {
    double sum = 0.0;
    for (const Lasting &contact : *this) sum += contact.reaction;
    return sum;
}

void LastingContacts::solve(double rollingFriction, Motion &motion) {
    const double negligible = kNegligible * (size(motion.velocity) + m_radius * size(motion.spin));
    const Motion driven = motion;
    for (Lasting &contact : *this) {
        contact.rubbing = tangential(contact.rubbing, contact.lever);
        motion.velocity += contact.reaction * contact.lever + contact.rubbing;
        motion.spin += contact.resisting - 2.5 / m_radius * glm::cross(contact.lever, contact.rubbing);
    }
    if (!m_isChosen) return solveBySweeps(rollingFriction, negligible, driven, motion);
    const double most = m_mostPressure * pressure() + negligible;
    const bool isSolved = keepChoice(rollingFriction, negligible, motion);
    if (isSolved && pressure() <= most) return;
    const LastingContacts near = *this;
    const Motion nearMotion = motion;
    unload();
    motion = driven;
    m_isChosen = m_isPrestressed = false;
    solveBySweeps(rollingFriction, negligible, driven, motion);
    // Sweeps may end in a jam, which presses far more.
    if (!isSolved || near.pressure() >= pressure()) return;
    *this = near;
    motion = nearMotion;
}

/// driven: as of settleWithoutResistance.
void LastingContacts::solveBySweeps(double rollingFriction, double negligible, const Motion &driven, Motion &motion) {
    settleWithoutResistance(negligible, driven, motion);
    stickWhileClosing(negligible, motion);
    if (relieve(negligible, motion).remains) {
        settleFromBelow(negligible, driven, motion);
        relieve(negligible, motion);
    }
    if (rollingFriction == 0.0) return;
    bool anyRolls = false;
    for (Lasting &contact : *this) {
        contact.rolls = contact.isTop && contact.reaction > 0.0 && (contact.isGlued || contact.sticks());
        anyRolls = anyRolls || contact.rolls;
    }
    if (!anyRolls) return;
    for (int i = 0; i < kMostShares; ++i) {
        if (!shareLoads() || !settleTogether(rollingFriction, negligible, kUsuallyTogether, motion))
            settle(rollingFriction, negligible, true, motion);
        const bool isRelieved = relieve(negligible, motion).relieved > negligible;
        if (i == 0 && !isRelieved) return;
        if (keepLoads(negligible)) return;
    }
}

/// Lets resistance depend on the present reactions from now on, whatever pressure between sticking contacts the next
/// solution has. Returns whether it did so already.
bool LastingContacts::keepLoads(double negligible) {
    bool areKept = true;
    for (Lasting &contact : *this) {
        areKept = areKept && std::abs(contact.reaction - contact.load) <= negligible;
        contact.load = contact.reaction;
    }
    return areKept;
}

} // namespace phys
