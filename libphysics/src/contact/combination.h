// SPDX-License-Identifier: MIT
// One combination of modes of lasting contacts, and its equations: model.md 14.1.
#pragma once

#include "contact/dense.h"
#include "contact/held.h"

namespace phys {

inline double sumOfPressures(std::span<const Reaction> reactions) {
    double sum = 0.0;
    for (const Reaction &reaction : reactions) sum += reaction.pressure;
    return sum;
}

/// What a unit of an unknown does to the ball.
struct Effect {
    Effect() {} // a defaulted one would be cleared
    Effect(const Vec3 &ofPush, const Vec3 &ofSpin)
        : push(ofPush)
        , spin(ofSpin) {}
    Vec3 push, spin; ///< force, and the spin's acceleration due to it
};

/// One combination of modes and its equations, model.md 14.1.
struct Combination {
    const Moment &moment;
    std::span<const Held> held;
    Work &work;
    std::array<Reaction, kMostHeld> reactions{};
    Vec3 rolling{0.0}; ///< direction that resistance opposes; shorter than 1 where part of it holds the ball
    Vec3 acceleration{0.0}, spinAcceleration{0.0};
    std::array<Vec3, kMostHeld> judged{};     ///< the forces by which the friction of sticking contacts is judged
    std::array<uint32_t, kMostHeld> column{}; ///< first unknown of each contact
    /// A contact of nearly the same or the opposite normal, or none: see `pairUp`. facing: 1 if the same, otherwise -1.
    std::array<uint32_t, kMostHeld> partner{};
    std::array<double, kMostHeld> facing{};
    uint32_t unknowns = 0;
    std::array<Effect, size_t{3} * kMostHeld> effects{}; ///< of the unknowns, while equations are set up and solved
    double most = INFINITY; ///< sum of N of another combination that fits within rounding already
    bool searches = false;  ///< for the direction of a slip that starts, model.md 14.1
    uint32_t spent = 0;     ///< bits of contacts whose friction is spent: they may start without an acceleration
    double prestress = 0.0; ///< of two sticking contacts against each other, on top of what leaves the least friction

    uint32_t count() const { return static_cast<uint32_t>(held.size()); }
    std::span<const Reaction> list() const { return {reactions.data(), held.size()}; }
    bool sticks(uint32_t i) const { return reactions[i].mode == Mode::sticking; }
    /// The only contact that sticks; count() if there is none or more than one.
    uint32_t onlySticking() const {
        uint32_t only = count();
        for (uint32_t i = 0; i < count(); ++i) {
            if (!sticks(i)) continue;
            if (only < count()) return count();
            only = i;
        }
        return only;
    }
    bool isOpen(uint32_t i) const { return reactions[i].mode == Mode::open; }
    bool isHeld() const { return squared(rolling) < 1.0 - 1e-12; }

    /// Sets the accelerations of a ball that contact i holds: zero except, at most, for a change of the spin about the
    /// normal if no other contact sticks.
    void rest(uint32_t i, double zero) {
        const Vec3 pivoting = spinAcceleration - tangential(spinAcceleration, held[i].normal);
        acceleration = Vec3(0.0);
        const bool pivots = onlySticking() == i && glm::length(pivoting) * moment.radius > zero;
        spinAcceleration = pivots ? pivoting : Vec3(0.0);
    }

    /// Whether contact i, which doesn't stick, is opposite to another face that carries all.
    bool isIdle(uint32_t i) const {
        if (isOpen(i) || sticks(i)) return false;
        for (uint32_t j = 0; j < count(); ++j) {
            if (isOpen(j)) continue;
            if (isIdleBeside(held[i].normal, held[j].normal, moment.gravity, i < j || sticks(j))) return true;
        }
        return false;
    }

    bool hasPartner(uint32_t i) const { return partner[i] < count(); }
    /// Normal of contact i, less that of its partner.
    Vec3 apart(uint32_t i) const {
        return hasPartner(i) ? held[i].normal - facing[i] * held[partner[i]].normal : held[i].normal;
    }
    /// Friction per unit of pressure of a contact that doesn't stick.
    Vec3 rubbing(uint32_t i) const { return sticks(i) ? Vec3(0.0) : -held[i].friction * reactions[i].direction; }

    uint32_t width(uint32_t i) const { return isOpen(i) ? 0 : sticks(i) ? 3 : 1; }
    /// Force on the ball per unit of the unknown `part` of contact i.
    Vec3 pushPer(uint32_t i, uint32_t part) const {
        if (sticks(i)) return {part == 0 ? 1.0 : 0.0, part == 1 ? 1.0 : 0.0, part == 2 ? 1.0 : 0.0};
        return hasPartner(i) ? apart(i) + (rubbing(i) - facing[i] * rubbing(partner[i])) : apart(i) + rubbing(i);
    }
    /// The spin's acceleration due to it.
    Vec3 spinPer(uint32_t i, uint32_t part) const {
        if (sticks(i)) return spinPerForce(i, pushPer(i, part));
        if (!hasPartner(i)) return spinPerForce(i, rubbing(i)); // pressure turns nothing, not even by rounding
        const uint32_t j = partner[i];
        const Vec3 ofPartner = spinPerForce(j, sticks(j) ? held[j].normal : rubbing(j));
        return spinPerForce(i, rubbing(i)) - facing[i] * ofPartner;
    }
    /// Force on the ball due to the unknowns of contact i.
    Vec3 push(uint32_t i, const dense::Values &x) const {
        Vec3 sum(0.0);
        for (uint32_t part = 0; part < width(i); ++part) sum += x[column[i] + part] * effects[column[i] + part].push;
        return sum;
    }
    /// The part of contact i's pressure that is in the unknowns of contacts whose partner it is, with the sign changed.
    double pressureOfPartners(uint32_t i, const dense::Values &x) const {
        double sum = 0.0;
        for (uint32_t j = 0; j < count(); ++j) sum += partner[j] == i ? facing[j] * x[column[j]] : 0.0;
        return sum;
    }
    /// Force r of contact i for these values of the unknowns.
    Vec3 force(uint32_t i, const dense::Values &x) const {
        const Vec3 along = held[i].normal + rubbing(i);
        return (hasPartner(i) ? x[column[i]] * along : push(i, x)) - pressureOfPartners(i, x) * along;
    }

    Vec3 spinPerForce(uint32_t i, const Vec3 &force) const {
        Vec3 spin = -kInertia / moment.radius * glm::cross(held[i].normal, force);
        if (sticks(i) && held[i].resistance > 0.0) {
            spin -= resistancePerPressure(moment, held[i]) * glm::dot(force, held[i].normal) * rolling;
        }
        return spin;
    }
};

/// Two contacts of nearly opposite normals hold a ball by forces that nearly cancel, and so do those of nearly the same
/// normal. Their equations would lose all digits by the square of the angle, so that one contact's unknown is the force
/// that both add, and its equation the difference of both.
void pairUp(Combination &c);

/// The equation of contact i: for the slip's rate if it sticks, otherwise for the normal acceleration. free: without
/// the forces. bend: the contribution of the features' curvature.
void addRows(const Combination &c, uint32_t i, dense::Equations &equations, const Vec3 &slipRate, const Vec3 &free,
             double bend);

/// Two sticking contacts leave a force along the line through both undetermined, which moves nothing. This equation
/// selects the one with the least friction, or with the prestress of the combination: model.md 14.1.
void addGauge(const Combination &c, uint32_t i, uint32_t j, dense::Equations &equations);

/// The equations of a combination; addRowsOf(i, equations) adds those of contact i, which isn't open.
template<class AddRowsOf>
dense::Equations equationsOf(Combination &c, AddRowsOf addRowsOf) {
    pairUp(c);
    c.unknowns = 0;
    for (uint32_t i = 0; i < c.count(); ++i) {
        c.column[i] = c.unknowns;
        for (uint32_t part = 0; part < c.width(i); ++part)
            c.effects[c.unknowns++] = {c.pushPer(i, part), c.spinPer(i, part)};
    }
    c.work.add(Work::kEquations * (1 + c.unknowns));
    dense::Equations equations(c.unknowns);
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (!c.isOpen(i)) addRowsOf(i, equations);
        if (c.isIdle(i)) equations.add(0.0)[c.column[i]] = 1.0 + c.held[i].friction;
        for (uint32_t j = 0; j < i; ++j) {
            if (c.sticks(i) && c.sticks(j)) addGauge(c, i, j, equations);
        }
    }
    return equations;
}

Vec3 slipRate(const Combination &c, uint32_t i);

/// Solves the equations of a combination for its reactions and accelerations.
void solve(Combination &c);

/// The forces of combinations of the same contacts in which no slip starts. Slips start against them.
class StuckForces {
public:
    using Forces = std::array<Vec3, kMostHeld>;

    StuckForces() {} // a defaulted one would clear the forces

    /// c: solved, and no slip starts.
    void keep(const Combination &c) {
        const uint32_t closed = closedOf(c);
        m_rolling[closed] = c.rolling;
        for (uint32_t i = 0; i < c.count(); ++i) m_forces[closed][i] = c.reactions[i].force;
        m_kept |= uint64_t{1} << closed;
    }
    /// Those of the combination in which all slips that start in c stick; solved if they aren't kept.
    const Forces &of(const Combination &c);

private:
    static_assert(kMostHeld <= 6, "a bit for each set of closed contacts");
    static constexpr uint32_t kSets = 1U << kMostHeld;

    std::array<Forces, kSets> m_forces; ///< by the bits of closed contacts
    std::array<Vec3, kSets> m_rolling;
    uint64_t m_kept = 0;

    static uint32_t closedOf(const Combination &c) {
        uint32_t closed = 0;
        for (uint32_t i = 0; i < c.count(); ++i) closed |= (c.isOpen(i) ? 0U : 1U) << i;
        return closed;
    }
};

/// Finds the reactions together with all directions that depend on them: those of slips that start, and that of
/// resistance where a ball starts to roll. False if the iteration doesn't converge.
bool settle(Combination &c, StuckForces &stuckForces);

/// Sets the forces by which friction is judged: those of the reactions, but where resistance acts the force without it,
/// as a slip ends the resistance. model.md 14.1.
void judge(Combination &c);

/// Whether the conditions of the modes hold for judged forces, up to accelerations of `zero`.
bool fits(const Combination &c, double zero);

/// Presses sticking contacts against each other along the lines through pairs of them until both are within their cones
/// if possible, model.md 14.1. That changes no motion but by the resistance to which the pressure leads.
void share(Combination &c, double zero);

} // namespace phys
