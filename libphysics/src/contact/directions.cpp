// SPDX-License-Identifier: MIT
// Directions that depend on the forces they determine: model.md 14.1.
#include "contact/combination.h"

#include <cmath>

namespace phys {

namespace {

constexpr int kMostStartPasses = 100; // of the iteration for the directions in which slips and rolling start
constexpr int kMostPulling = 24;      // with a contact that would have to pull: later passes wouldn't fit
constexpr int kMostOfMore = 24;       // with a larger sum of N than a combination that fits
constexpr int kMostHopeless = 8;      // the same or with a slip that friction would end, if another combination fits
constexpr int kPlainPasses = 8;       // before mixing begins: the first passes turn the directions the right way

/// The directions that are sought: of contacts, and last that of resistance.
class Aims {
public:
    Aims() {} // a defaulted one would clear the directions

    void add(const Vec3 &direction) { m_directions[m_count++] = direction; }
    const Vec3 &operator[](uint32_t i) const { return m_directions[i]; }
    const Vec3 &last() const { return m_directions[m_count - 1]; }

    double dot(const Aims &other) const {
        double sum = 0.0;
        for (uint32_t i = 0; i < m_count; ++i) sum += glm::dot(m_directions[i], other.m_directions[i]);
        return sum;
    }
    void add(double factor, const Aims &other) {
        for (uint32_t i = 0; i < m_count; ++i) m_directions[i] += factor * other.m_directions[i];
    }
    Aims over(double divisor) const {
        Aims quotient;
        for (uint32_t i = 0; i < m_count; ++i) quotient.add(m_directions[i] / divisor);
        return quotient;
    }

private:
    std::array<Vec3, kMostHeld + 1> m_directions;
    uint32_t m_count = 0;
};

/// Solves x = next(x) faster than fixed-point iteration: Anderson mixing, which treats the changes of the last steps as
/// those of a linear map.
class Mixing {
public:
    /// A better x from x and next(x).
    Aims mix(const Aims &x, const Aims &next) {
        Aims missing = next, better = next;
        missing.add(-1.0, x);
        if (m_isBegun) {
            remember(missing, next);
            Aims left = missing;
            for (uint32_t i = 0; i < m_count; ++i) {
                const double share = m_missing[i].dot(left);
                left.add(-share, m_missing[i]);
                better.add(-share, m_next[i]);
            }
        }
        m_lastMissing = missing;
        m_lastNext = next;
        m_isBegun = true;
        return better;
    }

private:
    static constexpr uint32_t kDepth = 3;

    std::array<Aims, kDepth> m_missing, m_next; // orthonormal changes of the residual, and those of next
    Aims m_lastMissing, m_lastNext;
    uint32_t m_count = 0;
    bool m_isBegun = false;

    void remember(const Aims &missing, const Aims &next) {
        Aims change = missing, moved = next;
        change.add(-1.0, m_lastMissing);
        moved.add(-1.0, m_lastNext);
        if (m_count == kDepth) m_count = 0;
        const double whole = change.dot(change);
        for (uint32_t i = 0; i < m_count; ++i) {
            const double share = m_missing[i].dot(change);
            change.add(-share, m_missing[i]);
            moved.add(-share, m_next[i]);
        }
        const double size = std::sqrt(change.dot(change));
        if (!(size > 1e-8 * std::sqrt(whole))) return;
        m_missing[m_count] = change.over(size);
        m_next[m_count++] = moved.over(size);
    }
};

/// The contacts whose directions are unknown. `rolls`: the contact at which a ball starts to roll against resistance.
struct Sought {
    std::array<uint32_t, kMostHeld> contacts;
    uint32_t count = 0;
    uint32_t rolls = kMostHeld;

    std::span<const uint32_t> starting() const { return {contacts.data(), count}; }
    bool isNone() const { return count == 0 && rolls == kMostHeld; }
};

/// Directions, and the sizes of the forces that have them.
struct Asked {
    Aims aims;
    std::array<double, kMostHeld + 1> sizes;
    uint32_t count = 0;

    void add(const Vec3 &direction, double size) {
        aims.add(direction);
        sizes[count++] = size;
    }
};

/// The directions that follow from the forces under the present ones.
Asked askedFor(const Combination &c, const Sought &sought) {
    Asked asked;
    for (const uint32_t i : sought.starting()) {
        const Reaction &reaction = c.reactions[i];
        const Vec3 rate = tangential(slipRate(c, i), c.held[i].normal);
        const Vec3 force = c.held[i].friction * reaction.pressure * reaction.direction + rate / kSlipPerFriction;
        asked.add(hat(force), glm::length(force));
    }
    if (sought.rolls == kMostHeld) return asked;
    const Held &ground = c.held[sought.rolls];
    const double most = resistancePerPressure(c.moment, ground) * c.reactions[sought.rolls].pressure;
    // A torque changes the rate by 2/7 of itself at one contact, and by less at several contacts.
    const Vec3 torque = most * c.rolling + kSlipPerFriction * tangential(c.spinAcceleration, ground.normal);
    const double size = std::max(most, glm::length(torque));
    asked.add(most > 0.0 ? torque / size : Vec3(0.0), size);
    return asked;
}

Aims aimsOf(const Combination &c, const Sought &sought) {
    Aims aims;
    for (const uint32_t i : sought.starting()) aims.add(c.reactions[i].direction);
    if (sought.rolls != kMostHeld) aims.add(c.rolling);
    return aims;
}

void aim(Combination &c, const Sought &sought, const Aims &aims) {
    uint32_t next = 0;
    for (const uint32_t i : sought.starting())
        c.reactions[i].direction = hat(tangential(aims[next++], c.held[i].normal));
    if (sought.rolls != kMostHeld) c.rolling = aims.last() / std::max(1.0, glm::length(aims.last()));
}

bool pulls(const Combination &c, double zero) {
    return std::any_of(c.reactions.begin(), c.reactions.begin() + c.count(),
                       [zero](const Reaction &reaction) { return reaction.pressure < -zero; });
}

/// Whether directions change by no more than rounding: that of accelerations for forces this small, and that of a force
/// of which the slip's rate takes nearly all away.
bool areSettled(const Combination &c, const Sought &sought, const Aims &aims, const Asked &asked) {
    const double scale = accelerationScale(c.moment), settled = c.moment.settled;
    const auto isSettled = [&](uint32_t aim, double force) {
        constexpr double kMost = 1e-6, kRoundings = 4.0 * 0x1p-52;
        const double rounding = std::max(scale / force, asked.sizes[aim] > 0.0 ? force / asked.sizes[aim] : 0.0);
        const double within = force > 0.0 ? std::clamp(kRoundings * rounding, settled, kMost) : settled;
        return glm::length(asked.aims[aim] - aims[aim]) <= within;
    };
    uint32_t next = 0;
    for (const uint32_t i : sought.starting()) {
        if (!isSettled(next++, c.held[i].friction * c.reactions[i].pressure)) return false;
    }
    if (sought.rolls == kMostHeld) return true;
    return isSettled(next, c.held[sought.rolls].resistance * c.reactions[sought.rolls].pressure);
}

/// Whether friction asks for less than it has at a contact that should start.
bool wouldStick(const Combination &c, const Sought &sought, const Asked &asked) {
    uint32_t next = 0;
    for (const uint32_t i : sought.starting()) {
        if (asked.sizes[next++] < (1.0 - kRoughly) * c.held[i].friction * c.reactions[i].pressure) return true;
    }
    return false;
}

/// Turns the directions until they agree with the accelerations. False if they don't converge.
bool settleDirections(Combination &c, const Sought &sought) {
    solve(c);
    if (sought.isNone()) return true;
    Mixing mixing;
    int pullingPasses = 0, passesOfMore = 0, hopelessPasses = 0;
    const double zero = kRoughly * accelerationScale(c.moment);
    for (int pass = 0; pass < kMostStartPasses && !c.work.isTooMuch(); ++pass) {
        const Aims aims = aimsOf(c, sought);
        const Asked asked = askedFor(c, sought);
        const bool isSettled = areSettled(c, sought, aims, asked);
        aim(c, sought, isSettled || pass < kPlainPasses ? asked.aims : mixing.mix(aims, asked.aims));
        solve(c);
        if (isSettled) return true;
        const bool isPulling = pulls(c, zero), isMore = sumOfPressures(c.list()) > c.most + zero;
        if (isPulling && ++pullingPasses == kMostPulling) return false;
        if (isMore && ++passesOfMore == kMostOfMore) return false;
        const bool isHopeless = isPulling || wouldStick(c, sought, asked);
        if (c.most < INFINITY && isHopeless && ++hopelessPasses == kMostHopeless) return false;
    }
    return false;
}

/// The direction of one slip that starts, by search: with its rate u', n.(d x u') is zero there. Iteration may miss all
/// such directions, as where several contacts hold the ball in its place. It takes the one with the smallest sum of N.
class DirectionSearch {
public:
    DirectionSearch(Combination &c, uint32_t starting)
        : m_c(c)
        , m_i(starting)
        , m_along(c.reactions[starting].direction)
        , m_across(glm::cross(c.held[starting].normal, m_along)) {}

    bool find() {
        double best = 0.0, least = INFINITY, before = turnAt(0.0);
        for (int look = 1; look <= 4 * kLooks && !m_c.work.isTooMuch(); ++look) {
            const double from = (look - 1.0) / kLooks, to = 1.0 * look / kLooks, after = turnAt(to);
            const bool rises = before < 0.0;
            before = after;
            if (rises == (after < 0.0)) continue;
            const double zero = zeroBetween(from, to, rises);
            turnAt(zero);
            const double sum = sumOfPressures(m_c.list());
            if (!(sum < least) || !fits()) continue;
            least = sum;
            best = zero;
        }
        turnAt(best);
        return least < INFINITY;
    }

private:
    static constexpr int kLooks = 16, kHalvings = 52; ///< for a right angle; of the interval between two of them

    Combination &m_c;
    uint32_t m_i;
    Vec3 m_along, m_across; ///< directions at the contact

    /// n.(d x u') for the direction that leads through a point of the square whose corners are four directions.
    double turnAt(double corner) {
        const double along = std::abs(2.0 - corner) - 1.0;
        const double across = corner < 3.0 ? 1.0 - std::abs(1.0 - corner) : corner - 4.0;
        Vec3 &direction = m_c.reactions[m_i].direction;
        direction = hat(along * m_along + across * m_across);
        solve(m_c);
        return glm::dot(m_c.held[m_i].normal, glm::cross(direction, slipRate(m_c, m_i)));
    }

    double zeroBetween(double low, double high, bool rises) {
        for (int halving = 0; halving < kHalvings; ++halving) {
            const double middle = 0.5 * (low + high);
            ((turnAt(middle) < 0.0) == rises ? low : high) = middle;
        }
        return high;
    }

    /// Not at a pole, where forces are without limit.
    bool fits() const {
        const double zero = kRoughly * accelerationScale(m_c.moment);
        const Vec3 &direction = m_c.reactions[m_i].direction, rate = slipRate(m_c, m_i);
        const double turning =
            glm::length(tangential(rate, m_c.held[m_i].normal) - glm::dot(rate, direction) * direction);
        return turning <= zero && glm::dot(rate, direction) > zero && !pulls(m_c, zero);
    }
};

/// The contact at which rolling resistance acts; count() if there is none.
uint32_t resisted(const Combination &c) {
    uint32_t i = 0;
    while (i < c.count() && !(c.sticks(i) && c.held[i].resistance > 0.0)) ++i;
    return i;
}

/// The only contact that sticks besides one; count() if there is none or more.
uint32_t stickingBeside(const Combination &c, uint32_t one) {
    uint32_t only = c.count();
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (i == one || !c.sticks(i)) continue;
        if (only < c.count()) return c.count();
        only = i;
    }
    return only;
}

/// Resistance on a ball that can only start to turn about a line: the largest one, or the share that holds the ball.
/// Near the normal the line is so much steeper than the torque that passes of `settleDirections` would change nothing.
void resistAbout(Combination &c, const Vec3 &line, const Vec3 &direction) {
    constexpr int kMostLooks = 60;
    const auto turnWith = [&](double share) {
        c.rolling = share * direction;
        solve(c);
        return glm::dot(c.spinAcceleration, line);
    };
    double none = 0.0, turnOfNone = turnWith(none);
    double all = turnOfNone < 0.0 ? -1.0 : 1.0, turnOfAll = turnWith(all);
    if (turnOfNone * turnOfAll > 0.0) return;
    // The pressures depend on the resistance, but little: false position, whose older end counts half (Illinois).
    for (int pass = 0; pass < kMostLooks && turnOfNone != turnOfAll && !c.work.isTooMuch(); ++pass) {
        const double share = (none * turnOfAll - all * turnOfNone) / (turnOfAll - turnOfNone);
        const double turn = turnWith(share);
        if (turn == 0.0 || share == none || share == all) return;
        if (turn * turnOfAll > 0.0) {
            turnOfNone *= 0.5;
        } else {
            none = all;
            turnOfNone = turnOfAll;
        }
        all = share;
        turnOfAll = turn;
    }
}

/// Directions in which slips begin: opposite to the friction that would be needed to prevent them. If one other contact
/// sticks, the ball can only turn about the line through both, so the slip is across both normals.
bool aimStarts(Combination &c, StuckForces &stuckForces) {
    const StuckForces::Forces &stuck = stuckForces.of(c);
    const uint32_t fixed = c.onlySticking();
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.reactions[i].mode != Mode::starting) continue;
        Vec3 friction = tangential(stuck[i], c.held[i].normal);
        if (fixed < c.count()) {
            const Vec3 free = hat(glm::cross(c.held[i].normal, c.held[fixed].normal));
            if (free != Vec3(0.0)) friction = glm::dot(friction, free) * free;
        }
        c.reactions[i].direction = -hat(friction);
        if (c.reactions[i].direction == Vec3(0.0)) return false;
    }
    return true;
}

/// False unless one slip starts and no contact sticks.
bool searchStart(Combination &c, const Sought &sought) {
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.sticks(i)) return false;
    }
    return sought.count == 1 && DirectionSearch(c, sought.contacts[0]).find();
}

} // namespace

bool settle(Combination &c, StuckForces &stuckForces) {
    const double zero = kFits * accelerationScale(c.moment);
    Sought sought;
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.reactions[i].mode == Mode::starting) sought.contacts[sought.count++] = i;
    }
    const uint32_t ground = resisted(c);
    const Vec3 spin = ground < c.count() ? rollingSpin(c.moment, c.held[ground]) : Vec3(0.0);
    const bool rolls = !isNoSlip(c.moment, c.moment.radius * spin);
    if (rolls) c.rolling = hat(spin);
    if (sought.count > 0 && !aimStarts(c, stuckForces)) return false;
    if (c.searches) return searchStart(c, sought);
    bool isSettled = settleDirections(c, sought);
    if (sought.count == 0) stuckForces.keep(c);
    if (ground == c.count() || rolls) return isSettled;
    // Resistance on a ball that starts to roll: opposite to the resulting motion, or the share of the largest possible
    // one that holds the ball, model.md 14.1.
    const Vec3 free = tangential(c.spinAcceleration, c.held[ground].normal);
    if (glm::length(free) * c.moment.radius <= zero) return isSettled;
    const uint32_t other = stickingBeside(c, ground);
    if (other < c.count() && sought.count == 0) {
        const Vec3 line = hat(c.held[ground].normal - c.held[other].normal);
        resistAbout(c, line, hat(tangential(line, c.held[ground].normal)));
    } else {
        sought.rolls = ground;
        isSettled = settleDirections(c, sought) && isSettled;
    }
    if (c.isHeld() && c.reactions[ground].pressure > zero) c.rest(ground, zero);
    return isSettled;
}

} // namespace phys
