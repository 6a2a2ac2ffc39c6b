// SPDX-License-Identifier: MIT
// Directions that depend on the forces they determine: model.md 14.1.
#include "contact/combination.h"

namespace phys {

namespace {

constexpr int kMostStartPasses = 100; // of the iteration for the directions in which slips and rolling start
constexpr int kMostPulling = 24;      // with a contact that would have to pull: later passes wouldn't fit
constexpr int kPlainPasses = 8;       // before mixing begins: the first passes turn the directions the right way

/// One direction for each contact, and last that of resistance.
using Aims = std::array<Vec3, kMostHeld + 1>;

double dot(const Aims &a, const Aims &b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
    return sum;
}

void add(Aims &a, double factor, const Aims &b) {
    for (size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

/// Solves x = next(x) faster than fixed-point iteration: Anderson mixing, which treats the changes of the last steps as
/// those of a linear map.
class Mixing {
public:
    /// A better x from x and next(x).
    Aims mix(const Aims &x, const Aims &next) {
        Aims missing = next, better = next;
        add(missing, -1.0, x);
        if (m_isBegun) {
            remember(missing, next);
            Aims left = missing;
            for (uint32_t i = 0; i < m_count; ++i) {
                const double share = dot(m_missing[i], left);
                add(left, -share, m_missing[i]);
                add(better, -share, m_next[i]);
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
        add(change, -1.0, m_lastMissing);
        add(moved, -1.0, m_lastNext);
        if (m_count == kDepth) m_count = 0;
        const double whole = dot(change, change);
        for (uint32_t i = 0; i < m_count; ++i) {
            const double share = dot(m_missing[i], change);
            add(change, -share, m_missing[i]);
            add(moved, -share, m_next[i]);
        }
        const double size = std::sqrt(dot(change, change));
        if (!(size > 1e-8 * std::sqrt(whole))) return;
        for (size_t i = 0; i < change.size(); ++i) {
            m_missing[m_count][i] = change[i] / size;
            m_next[m_count][i] = moved[i] / size;
        }
        ++m_count;
    }
};

/// The contacts whose directions are unknown. `rolls`: the contact at which a ball starts to roll against resistance.
struct Sought {
    uint32_t starting = 0; ///< bits
    uint32_t rolls = kMostHeld;
};

/// The directions that follow from the forces under the present ones.
Aims askedFor(const Combination &c, const Sought &sought) {
    Aims asked{};
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (!(sought.starting >> i & 1U)) continue;
        const Reaction &reaction = c.reactions[i];
        const Vec3 rate = tangential(slipRate(c, i), c.held[i].normal);
        asked[i] = hat(c.held[i].friction * reaction.pressure * reaction.direction + rate / kSlipPerFriction);
    }
    if (sought.rolls == kMostHeld) return asked;
    const Held &ground = c.held[sought.rolls];
    const double most = resistancePerPressure(c.moment, ground) * c.reactions[sought.rolls].pressure;
    // A torque changes the rate by 2/7 of itself at one contact, and by less at several contacts.
    const Vec3 torque = most * c.rolling + kSlipPerFriction * tangential(c.spinAcceleration, ground.normal);
    if (most > 0.0) asked.back() = torque / std::max(most, glm::length(torque));
    return asked;
}

Aims aimsOf(const Combination &c, const Sought &sought) {
    Aims aims{};
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (sought.starting >> i & 1U) aims[i] = c.reactions[i].direction;
    }
    if (sought.rolls != kMostHeld) aims.back() = c.rolling;
    return aims;
}

void aim(Combination &c, const Sought &sought, const Aims &aims) {
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (sought.starting >> i & 1U) c.reactions[i].direction = hat(tangential(aims[i], c.held[i].normal));
    }
    if (sought.rolls != kMostHeld) c.rolling = aims.back() / std::max(1.0, glm::length(aims.back()));
}

bool pulls(const Combination &c, double zero) {
    return std::any_of(c.reactions.begin(), c.reactions.begin() + c.count(),
                       [zero](const Reaction &reaction) { return reaction.pressure < -zero; });
}

/// Whether directions change by no more than the rounding of accelerations implies for forces this small.
bool areSettled(const Combination &c, const Sought &sought, const Aims &aims, const Aims &asked) {
    const double scale = accelerationScale(c.moment);
    const auto isSettled = [&](size_t aim, double force) {
        constexpr double kMost = 1e-6, kRoundings = 4.0 * 0x1p-52;
        const double within = force > 0.0 ? std::clamp(kRoundings * scale / force, kSettled, kMost) : kSettled;
        return glm::length(asked[aim] - aims[aim]) <= within;
    };
    for (uint32_t i = 0; i < c.count(); ++i) {
        const double pressure = c.reactions[i].pressure;
        if ((sought.starting >> i & 1U) && !isSettled(i, c.held[i].friction * pressure)) return false;
        if (sought.rolls == i && !isSettled(kMostHeld, c.held[i].resistance * pressure)) return false;
    }
    return true;
}

/// Turns the directions until they agree with the accelerations. False if they don't converge.
bool settleDirections(Combination &c, const Sought &sought) {
    solve(c);
    if (sought.starting == 0 && sought.rolls == kMostHeld) return true;
    Mixing mixing;
    int pullingPasses = 0;
    const double zero = kRoughly * accelerationScale(c.moment);
    for (int pass = 0; pass < kMostStartPasses && !c.work.isTooMuch(); ++pass) {
        const Aims aims = aimsOf(c, sought), asked = askedFor(c, sought);
        const bool isSettled = areSettled(c, sought, aims, asked);
        aim(c, sought, isSettled || pass < kPlainPasses ? asked : mixing.mix(aims, asked));
        solve(c);
        if (isSettled) return true;
        if (pulls(c, zero) && ++pullingPasses == kMostPulling) return false;
    }
    return false;
}

/// The contact at which rolling resistance acts; count() if there is none.
uint32_t resisted(const Combination &c) {
    uint32_t i = 0;
    while (i < c.count() && !(c.sticks(i) && c.held[i].resistance > 0.0)) ++i;
    return i;
}

/// Directions in which slips begin: opposite to the friction that would be needed to prevent them. If one other contact
/// sticks, the ball can only turn about the line through both, so the slip is across both normals.
bool aimStarts(Combination &c) {
    Combination stuck = c;
    bool starts = false;
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.reactions[i].mode != Mode::starting) continue;
        stuck.reactions[i].mode = Mode::sticking;
        starts = true;
    }
    if (!starts) return true;
    solve(stuck);
    const uint32_t fixed = c.onlySticking();
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.reactions[i].mode != Mode::starting) continue;
        Vec3 friction = tangential(stuck.reactions[i].force, c.held[i].normal);
        if (fixed < c.count()) {
            const Vec3 free = hat(glm::cross(c.held[i].normal, c.held[fixed].normal));
            if (free != Vec3(0.0)) friction = glm::dot(friction, free) * free;
        }
        c.reactions[i].direction = -hat(friction);
        if (c.reactions[i].direction == Vec3(0.0)) return false;
    }
    return true;
}

} // namespace

bool settle(Combination &c) {
    const double zero = kFits * accelerationScale(c.moment);
    Sought sought;
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.reactions[i].mode == Mode::starting) sought.starting |= 1U << i;
    }
    const uint32_t ground = resisted(c);
    const Vec3 spin = ground < c.count() ? rollingSpin(c.moment, c.held[ground]) : Vec3(0.0);
    const bool rolls = !isNoSlip(c.moment, c.moment.radius * spin);
    if (rolls) c.rolling = hat(spin);
    if (!aimStarts(c)) return false;
    bool isSettled = settleDirections(c, sought);
    if (ground == c.count() || rolls) return isSettled;
    // Resistance on a ball that starts to roll: opposite to the resulting motion, or the share of the largest possible
    // one that holds the ball, model.md 14.1.
    const Vec3 free = tangential(c.spinAcceleration, c.held[ground].normal);
    if (glm::length(free) * c.moment.radius <= zero) return isSettled;
    sought.rolls = ground;
    isSettled = settleDirections(c, sought) && isSettled;
    if (c.isHeld()) c.rest(ground, zero);
    return isSettled;
}

} // namespace phys
