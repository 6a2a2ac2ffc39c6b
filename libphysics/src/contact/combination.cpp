// SPDX-License-Identifier: MIT
#include "contact/combination.h"

namespace phys {

void pairUp(Combination &c) {
    constexpr double kNearly = 1e-3; // sine of the angle between normals
    c.partner.fill(kMostHeld);
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.isOpen(i) || c.sticks(i)) continue;
        for (uint32_t j = 0; j < c.count() && !c.hasPartner(i); ++j) {
            if (j == i || c.isOpen(j) || c.hasPartner(j)) continue;
            // The smoother contact is the partner, as its pressure becomes a difference.
            const double smoother = c.sticks(j) ? -1.0 : c.held[j].friction;
            if (smoother > c.held[i].friction || (smoother == c.held[i].friction && j > i)) continue;
            const Vec3 line = glm::cross(c.held[i].normal, c.held[j].normal);
            if (line == Vec3(0.0) || squared(line) > kNearly * kNearly) continue;
            c.partner[i] = j;
            c.facing[i] = glm::dot(c.held[i].normal, c.held[j].normal) > 0.0 ? 1.0 : -1.0;
        }
    }
}

void addRows(const Combination &c, uint32_t i, dense::Equations &equations, const Vec3 &slipRate, const Vec3 &free,
             double bend) {
    const Held &contact = c.held[i];
    const bool sticks = c.sticks(i);
    const Vec3 apart = c.apart(i);
    std::array<dense::Values *, 3> rows{};
    for (uint32_t row = 0; row < c.width(i); ++row)
        rows[row] = &equations.add(sticks ? slipRate[static_cast<int>(row)] : -(glm::dot(apart, free) + bend));
    for (uint32_t unknown = 0; unknown < c.unknowns; ++unknown) {
        Vec3 change = c.effects[unknown].push;
        if (!sticks) {
            (*rows[0])[unknown] = glm::dot(apart, change);
            continue;
        }
        change -= c.moment.radius * glm::cross(c.effects[unknown].spin, contact.normal);
        for (uint32_t row = 0; row < 3; ++row) (*rows[row])[unknown] = change[static_cast<int>(row)] + 0.0;
    }
}

void addGauge(const Combination &c, uint32_t i, uint32_t j, dense::Equations &equations) {
    const Vec3 line = hat(c.held[i].normal - c.held[j].normal);
    const Vec3 at[] = {tangential(line, c.held[i].normal), -tangential(line, c.held[j].normal)};
    dense::Values &factors = equations.add(c.prestress * (squared(at[0]) + squared(at[1])));
    for (uint32_t part = 0; part < 3; ++part) {
        factors[c.column[i] + part] = at[0][static_cast<int>(part)];
        factors[c.column[j] + part] = at[1][static_cast<int>(part)];
    }
}

namespace {

/// Computes accelerations from the unknowns.
void accelerate(Combination &c, const dense::Values &x) {
    c.acceleration = c.moment.gravity;
    c.spinAcceleration = Vec3(0.0);
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.isOpen(i)) continue;
        const Vec3 push = c.push(i, x);
        c.acceleration += push;
        c.spinAcceleration += c.sticks(i) ? c.spinPerForce(i, push) : x[c.column[i]] * c.effects[c.column[i]].spin;
    }
}

/// The features' curvature in the equation of contact i.
double bendOf(const Combination &c, uint32_t i) {
    const double own = curvature(c.moment, c.held[i]);
    return c.hasPartner(i) ? own - c.facing[i] * curvature(c.moment, c.held[c.partner[i]]) : own;
}

/// The smallest N that counts as zero: it is negative by no more than rounding, and so is the friction due to it.
double leastPressure(const Combination &c, uint32_t i) {
    return -kFits * accelerationScale(c.moment) / (1.0 + c.held[i].friction);
}

/// Solves the equations, with no pressure at the contacts in `idle` (bits) instead of their own equations.
dense::Values unknownsOf(Combination &c, uint32_t idle) {
    dense::Equations equations = equationsOf(c, [&](uint32_t i, dense::Equations &rows) {
        const Vec3 turning = glm::cross(c.moment.spin, c.held[i].across * c.moment.velocity);
        if (!(idle >> i & 1U)) {
            return addRows(c, i, rows, turning - c.moment.gravity, c.moment.gravity, bendOf(c, i));
        }
        dense::Values &factors = rows.add(0.0);
        factors[c.column[i]] = 1.0;
        for (uint32_t j = 0; j < c.count(); ++j) {
            if (c.partner[j] == i) factors[c.column[j]] = -c.facing[j];
        }
    });
    return equations.solve();
}

/// Contacts that pull, but by no more than rounding: bits.
uint32_t pullingByRounding(const Combination &c) {
    uint32_t bits = 0;
    for (uint32_t i = 0; i < c.count(); ++i) {
        const Reaction &reaction = c.reactions[i];
        const bool pulls = reaction.pressure < 0.0 && reaction.pressure >= leastPressure(c, i);
        bits |= (pulls && reaction.mode != Mode::sticking ? 1U : 0U) << i;
    }
    return bits;
}

} // namespace

void solve(Combination &c) {
    // Rounding must not make a contact pull: friction would follow it and drive the slip. The forces at the others are
    // those without it: what balanced its friction would drive them, in proportion to its mu.
    uint32_t idle = 0;
    dense::Values x;
    for (uint32_t pulling = 1; pulling != 0; idle |= pulling) {
        x = unknownsOf(c, idle);
        for (uint32_t i = 0; i < c.count(); ++i) {
            Reaction &reaction = c.reactions[i];
            reaction.force = c.force(i, x);
            reaction.pressure = c.isOpen(i) ? 0.0 : glm::dot(reaction.force, c.held[i].normal);
            if (!(idle >> i & 1U)) continue;
            reaction.pressure = 0.0;
            reaction.force = Vec3(0.0);
        }
        pulling = pullingByRounding(c);
    }
    accelerate(c, x);
}

const StuckForces::Forces &StuckForces::of(const Combination &c) {
    const uint32_t closed = closedOf(c);
    if ((m_kept >> closed & 1U) && m_rolling[closed] == c.rolling) return m_forces[closed];
    Combination stuck = c;
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.reactions[i].mode == Mode::starting) stuck.reactions[i].mode = Mode::sticking;
    }
    solve(stuck);
    keep(stuck);
    return m_forces[closed];
}

Vec3 slipRate(const Combination &c, uint32_t i) {
    const Held &contact = c.held[i];
    return c.acceleration - c.moment.radius * glm::cross(c.spinAcceleration, contact.normal) -
           glm::cross(c.moment.spin, contact.across * c.moment.velocity);
}

namespace {

bool isWithinCone(const Combination &c, uint32_t i, double zero) {
    const Vec3 &n = c.held[i].normal;
    const double mu = c.held[i].friction, most = zero + roundingOfLimit(c.moment, mu);
    const double pressure = glm::dot(c.judged[i], n), limit = mu * pressure;
    if (pressure < -zero) return false;
    return limit * limit - squared(c.judged[i] - pressure * n) >= -2.0 * most * limit - zero * zero;
}

/// What a slip's rate may be off because its direction changes no more than that: rough contacts magnify it.
double unsettled(const Combination &c, uint32_t i) {
    return kSlipPerFriction * c.moment.settled * c.held[i].friction * std::abs(c.reactions[i].pressure);
}

/// Whether sticking contacts leave the ball a motion along all closed contacts. Two leave it the turning about the line
/// through both, three none: what the equations then give for a slip's rate is rounding, or its quotient by a small
/// angle.
bool isFreeToTurn(const Combination &c) {
    const double rounding = 4.0 * c.moment.rounding;
    uint32_t first = c.count(), second = c.count();
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (!c.sticks(i)) continue;
        if (first == c.count()) {
            first = i;
        } else if (second == c.count()) {
            second = i;
        } else {
            return false;
        }
    }
    if (second == c.count()) return true;
    const Vec3 line = hat(c.held[first].normal - c.held[second].normal);
    const Vec3 way = glm::cross(line, c.held[first].normal);
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (!c.isOpen(i) && std::abs(glm::dot(way, c.held[i].normal)) > rounding) return false;
    }
    return true;
}

/// Whether a slip starts at this moment in the direction that another, sticking contact leaves free.
bool isSpent(const Combination &c, uint32_t i) { return (c.spent >> i & 1U) && c.onlySticking() < c.count(); }

} // namespace

void judge(Combination &c) {
    for (uint32_t i = 0; i < c.count(); ++i) c.judged[i] = c.reactions[i].force;
    if (c.rolling == Vec3(0.0)) return;
    Combination free = c;
    free.rolling = Vec3(0.0);
    solve(free);
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.sticks(i) && c.held[i].resistance > 0.0) c.judged[i] = free.reactions[i].force;
    }
}

bool fits(const Combination &c, double zero) {
    for (uint32_t i = 0; i < c.count(); ++i) {
        const Reaction &reaction = c.reactions[i];
        const double apart = glm::dot(c.held[i].normal, c.acceleration) + curvature(c.moment, c.held[i]);
        const double leastPressure = -zero / (1.0 + c.held[i].friction);
        switch (reaction.mode) {
        case Mode::open:
            if (apart < -zero) return false;
            break;
        case Mode::starting:
            if (std::abs(apart) > zero || reaction.pressure < leastPressure) return false;
            if (!isFreeToTurn(c)) return false;
            if (glm::dot(slipRate(c, i), reaction.direction) <= (isSpent(c, i) ? -zero : zero + unsettled(c, i)))
                return false;
            break;
        case Mode::sticking:
            if (std::abs(apart) > zero || reaction.pressure < -zero) return false;
            if (c.held[i].isGlued) break;
            if (glm::length(slipRate(c, i)) > zero) return false;
            if (!isWithinCone(c, i, zero)) return false;
            break;
        default:
            if (std::abs(apart) > zero || reaction.pressure < leastPressure) return false;
        }
    }
    return true;
}

namespace {

/// Forces between two sticking contacts along the line through both.
class Prestress {
public:
    Prestress(Combination &c, uint32_t i, uint32_t j)
        : m_c(c)
        , m_contacts{i, j}
        , m_line(hat(c.held[i].normal - c.held[j].normal))
        , m_forces{c.reactions[i].force, c.reactions[j].force}
        , m_judged{c.judged[i], c.judged[j]}
        , m_resists(isResisted()) {}

    /// Takes the least with which the combination fits; none if there is no such prestress.
    bool find(double zero) {
        std::array<double, 16> amounts{};
        uint32_t count = 1;
        const std::array<Vec3, 2> along = judgedPerUnit();
        for (uint32_t k = 0; k < 2; ++k) {
            for (const double limit : limitsAt(m_contacts[k], m_judged[k], along[k])) {
                if (limit != 0.0) amounts[count++] = limit;
            }
        }
        const auto isLess = [](double a, double b) { return std::abs(a) < std::abs(b); };
        std::sort(amounts.begin(), amounts.begin() + count, isLess);
        for (uint32_t k = 0; k < count; ++k) {
            take(amounts[k]);
            if (fits(m_c, zero)) return true;
        }
        take(0.0);
        return false;
    }

private:
    Combination &m_c;
    std::array<uint32_t, 2> m_contacts;
    Vec3 m_line;
    std::array<Vec3, 2> m_forces, m_judged; ///< without prestress
    bool m_resists;

    /// Whether rolling resistance depends on it. It doesn't if it holds the ball, as three that stick do.
    bool isResisted() const {
        if (m_c.rolling == Vec3(0.0) || m_c.isHeld()) return false;
        uint32_t sticking = 0;
        for (uint32_t i = 0; i < m_c.count(); ++i) sticking += m_c.sticks(i) ? 1 : 0;
        return sticking == 2;
    }

    void take(double amount) {
        if (m_resists) {
            m_c.prestress = amount;
            solve(m_c);
            judge(m_c);
            return;
        }
        for (uint32_t k = 0; k < 2; ++k) {
            const Vec3 force = k == 0 ? amount * m_line : -amount * m_line;
            Reaction &reaction = m_c.reactions[m_contacts[k]];
            reaction.force = m_forces[k] + force;
            reaction.pressure = glm::dot(reaction.force, m_c.held[m_contacts[k]].normal);
            m_c.judged[m_contacts[k]] = m_judged[k] + force;
        }
    }

    /// What a unit changes of the forces by which friction is judged: of that without resistance at the contact that
    /// resists, of all at the other one.
    std::array<Vec3, 2> judgedPerUnit() const {
        std::array<Vec3, 2> changes{m_line, -m_line};
        if (!m_resists) return changes;
        Combination pressed = m_c;
        pressed.prestress = accelerationScale(m_c.moment);
        solve(pressed);
        for (uint32_t k = 0; k < 2; ++k) {
            if (m_c.held[m_contacts[k]].resistance > 0.0) continue;
            changes[k] = (pressed.reactions[m_contacts[k]].force - m_forces[k]) / pressed.prestress;
        }
        return changes;
    }

    /// The amounts with which friction at a contact is at the limit of its cone; 0 instead of one that doesn't exist.
    std::array<double, 2> limitsAt(uint32_t contact, const Vec3 &r, const Vec3 &along) const {
        // |r + s along|^2 = (1 + mu^2) N^2 with N = n.(r + s along), which is found: from s rounded by no more than the
        // forces, it would be lost where much friction needs hardly any N.
        const double mu = m_c.held[contact].friction;
        const Vec3 &n = m_c.held[contact].normal;
        const double rn = glm::dot(r, n), ln = glm::dot(along, n);
        const Vec3 perN = (along - ln * n) / ln, unpressed = r - rn * n - rn * perN;
        const double q2 = squared(perN) - mu * mu, q1 = glm::dot(unpressed, perN), q0 = squared(unpressed);
        const double discriminant = q1 * q1 - q2 * q0;
        if (m_c.held[contact].isGlued || !(discriminant >= 0.0)) return {};
        // q2 is rounding where the line is parallel to the cone: friction of 1 at perpendicular normals.
        const double q = -(q1 + std::copysign(std::sqrt(discriminant), q1));
        return {q2 != 0.0 ? (q / q2 - rn) / ln : 0.0, q != 0.0 ? (q0 / q - rn) / ln : 0.0};
    }
};

} // namespace

void share(Combination &c, double zero) {
    for (uint32_t i = 0; i < c.count(); ++i) {
        for (uint32_t j = 0; j < i; ++j) {
            if (c.sticks(i) && c.sticks(j) && Prestress(c, i, j).find(zero)) return;
        }
    }
}

} // namespace phys
