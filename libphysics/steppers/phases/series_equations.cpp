// SPDX-License-Identifier: MIT
// The equations of one order of the general phase: what the forces of all its contacts must be, model.md 14.1.
#include "contact/held.h"
#include "phases/series.h"

#include <algorithm>
#include <array>

namespace phys {

namespace {

/// Divisor for the equations of very rough contacts: beside longer rows the others would count as zero.
double unitOfFriction(double mu) { return std::max(mu, 1.0); }

Vec3 axisOf(int i) { return {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0}; }

} // namespace

/// Force r per unit of a contact's unknown.
Vec3 Series::basis(const Contact &contact, int part) const {
    switch (contact.mode) {
    case Mode::smooth:
        return contact.n[0];
    case Mode::slipping:
        return contact.n[0] - contact.held.friction * contact.d[0];
    default:
        return part < 3 ? axisOf(part) : Vec3(0.0);
    }
}

Vec3 Series::spinPerForce(const Contact &contact, const Vec3 &force, int k) const {
    if (contact.mode == Mode::smooth) return Vec3(0.0); // not even rounding
    Vec3 spin = -kInertia / m_moment.radius * glm::cross(contact.n[0], force);
    if (rolls(contact)) {
        spin -= kInertia * contact.held.resistance / m_moment.radius * glm::dot(force, contact.n[0]) * m_rolling[0];
    }
    return steadied(spin, k);
}

/// Term k of the normal acceleration, as far as forces are known.
double Series::apart(const Contact &contact, int k) const {
    double apart = glm::dot(contact.n[0], m_a[k]);
    if (contact.isFlat) return apart;
    Jet bend; // the products of the first half are also those of the second
    for (int j = 0; j <= k; ++j) {
        if (j > 0) apart += glm::dot(contact.n[j], m_a[k - j]);
        if (2 * j <= k) {
            bend[j] = glm::dot(contact.held.across * m_v[j], contact.held.across * m_v[k - j]) / m_moment.radius;
        }
        apart += bend[std::min(j, k - j)];
    }
    return apart;
}

void Series::addRows(const Contact &contact, int k, dense::Equations &equations) const {
    const double R = m_moment.radius, mu = contact.held.friction;
    const Vec3 n0 = contact.n[0];
    // axis . (effect of a force), summed over all unknowns.
    const auto add = [&](const Vec3 &axis, bool ofSlip, double value) -> dense::Values & {
        dense::Values &factors = equations.add(value);
        if (equations.areSolved()) return factors;
        for (const Contact &other : contacts()) {
            const int width = other.mode == Mode::smooth || other.mode == Mode::slipping ? 1 : 3;
            for (int part = 0; part < width; ++part) {
                const Vec3 force = basis(other, part);
                Vec3 change = force;
                if (ofSlip) change -= R * glm::cross(spinPerForce(other, force, k), n0);
                factors[other.column + part] = glm::dot(axis, change);
            }
        }
        return factors;
    };
    if (contact.mode == Mode::sticking) {
        for (int i = 0; i < 3; ++i) add(axisOf(i), true, -glm::dot(axisOf(i), contact.rateKnown));
        return;
    }
    add(n0, false, -apart(contact, k));
    if (contact.mode == Mode::starting) {
        const double growth = unit() * mu * contact.N[0] / (contact.speed[0] * (k + 1));
        const Vec3 d0 = contact.d[0];
        for (int i = 0; i < 3; ++i) {
            const Vec3 across = axisOf(i) - d0[i] * d0;
            const double known = contact.directionKnown[i] - growth * glm::dot(across, contact.rateKnown);
            dense::Values &factors = add(growth * across, true, known);
            factors[contact.column + i] += 1.0;
            factors[contact.column + 3] -= (n0[i] - mu * d0[i]) / unitOfFriction(mu);
        }
    } else if (contact.mode == Mode::spent) {
        const Vec3 d0 = contact.d[0], e = glm::cross(n0, d0);
        double across = 0.0, along = 0.0;
        for (int i = 2; i <= k; ++i) across += glm::dot(glm::cross(contact.u[i], contact.d[k + 1 - i]), n0);
        add(e, true, (k + 1) / unit() * across - glm::dot(e, contact.rateKnown));
        for (int j = 1; j <= k; ++j) {
            along += contact.N[k - j] * glm::dot(contact.n[j], d0) - mu * glm::dot(contact.r[k - j], contact.n[j]);
            if (j == k) continue;
            along -= mu * contact.N[k - j] * glm::dot(contact.d[j], d0);
            along += 0.5 * mu * contact.N[0] * glm::dot(contact.d[j], contact.d[k - j]);
        }
        const double unit = unitOfFriction(mu);
        dense::Values &factors = equations.add(along / unit);
        for (int part = 0; part < 3 && !equations.areSolved(); ++part) {
            factors[contact.column + part] = (d0[part] + mu * n0[part]) / unit;
        }
    }
}

/// For two sticking contacts: of the forces that press them against each other and move nothing, those with the least
/// friction, f_i.t_i + f_j.t_j = 0 with the tangents t of the line n_i - n_j through both. model.md 14.1.
void Series::addGauge(uint32_t i, uint32_t j, int k, dense::Equations &equations) {
    const Contact &a = m_contacts[i], &b = m_contacts[j];
    Jet cosine;
    for (int m = 0; m <= k; ++m) cosine[m] = dotTerm(a.n, b.n, m);
    const auto tangents = [&](int m) {
        return std::array{termOf(cosine, a.n, m) - b.n[m], termOf(cosine, b.n, m) - a.n[m]};
    };
    double known = 0.0;
    for (int m = 1; m <= k; ++m) {
        const auto [ofA, ofB] = tangents(m);
        known += glm::dot(a.r[k - m], ofA) + glm::dot(b.r[k - m], ofB);
    }
    const auto [ofA, ofB] = tangents(0);
    dense::Values &factors = equations.add(-known);
    for (int part = 0; part < 3 && !equations.areSolved(); ++part) {
        factors[a.column + part] = ofA[part];
        factors[b.column + part] = ofB[part];
    }
}

/// The same for the least prestress with which both stick: friction at one of them remains at its limit, so that r, but
/// for what resistance needs of it, is in its cone's surface, |r|^2 = (1 + mu^2) N^2.
void Series::addPrestress(const Contact &contact, int k, dense::Equations &equations) const {
    const Vec3 n0 = contact.n[0], resisting0 = resisting(contact, 0);
    const double steep = 1.0 + contact.held.friction * contact.held.friction;
    const auto judged = [&](int m) {
        Vec3 force = contact.r[m];
        for (int j = 0; j <= m && rolls(contact); ++j) force += contact.N[m - j] * resisting(contact, j);
        return force;
    };
    const Vec3 force0 = judged(0), known = judged(k);
    double left = glm::dot(force0, known) - steep * contact.N[0] * contact.N[k];
    for (int m = 1; m < k; ++m)
        left += 0.5 * (glm::dot(judged(m), judged(k - m)) - steep * contact.N[m] * contact.N[k - m]);
    const double unit = std::sqrt(steep * squared(force0));
    dense::Values &factors = equations.add(left / unit);
    const Vec3 perForce = (steep * contact.N[0] - glm::dot(force0, resisting0)) * n0 - force0;
    for (int part = 0; part < 3 && !equations.areSolved(); ++part)
        factors[contact.column + part] = perForce[part] / unit;
}

/// Whether the pressure of a contact that doesn't stick is zero, as that of the opposite one isn't.
bool Series::isIdleBesideOther(const Contact &contact) const {
    if (contact.mode != Mode::smooth && contact.mode != Mode::slipping) return false;
    return std::any_of(contacts().begin(), contacts().end(), [&](const Contact &other) {
        const bool presses = contact.N[0] > 0.0, otherPresses = other.N[0] > 0.0;
        if (contact.n[0] == -other.n[0] && presses != otherPresses) return otherPresses;
        return isIdleBeside(contact.n[0], other.n[0], m_moment.gravity,
                            &contact < &other || other.mode == Mode::sticking);
    });
}

/// Term j of the force per N of a contact that doesn't stick and whose normal doesn't turn.
Vec3 Series::pushPer(const Contact &contact, int j) {
    const Vec3 normal = j == 0 ? contact.n[0] : Vec3(0.0);
    return contact.mode == Mode::slipping ? normal - contact.held.friction * contact.d[j] : normal;
}

/// Contacts without pressure that leave those that press no unknown of their own: the equations can't tell how the load
/// is divided among all, and the law has: model.md 14.1.
void Series::keepIdle(const Vec3 &line, double rounding) {
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = m_contacts[i];
        if (contact.N[0] > 0.0 || isIdleBesideOther(contact)) continue;
        const bool isAcross = std::abs(glm::dot(contact.n[0], line)) > rounding;
        m_shared.isBarred = m_shared.isBarred || (isAcross && m_shared.count > 2);
        const bool isStraight = glm::length(contact.held.across * line) <= rounding;
        if (isAcross ? m_shared.count > 2 : isStraight) m_shared.idle |= 1U << i;
    }
}

/// Of slipping contacts that all press: whether and how they share a load.
void Series::findShared() {
    Shared &shared = m_shared;
    shared.rate = 0.0;
    shared.count = 0;
    shared.idle = 0;
    shared.isBarred = false;
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = m_contacts[i];
        if (contact.needsRate()) return;
        if (contact.partner < m_count || !(contact.N[0] > 0.0) || isIdleBesideOther(contact)) continue;
        if (shared.count == 4) return;
        shared.contacts[shared.count++] = i;
    }
    if (shared.count < 2 || m_count < 3) return;
    const auto of = [&](size_t i) -> const Contact & { return m_contacts[shared.contacts[i % shared.count]]; };
    const auto push = [&](size_t i) { return pushPer(of(i), 0); };
    const Vec3 line = hat(glm::cross(of(0).n[0], of(1).n[0]));
    const double rounding = 4.0 * m_moment.rounding;
    const double steepest = std::max(std::abs(glm::dot(of(2).n[0], line)), std::abs(glm::dot(of(3).n[0], line)));
    if (shared.count == 4 && steepest <= rounding) return;
    shared.line = shared.count == 4 ? Vec3(0.0) : line;
    for (size_t i = 0; i < shared.count; ++i) {
        if (glm::length(of(i).held.across * shared.line) > rounding) return;
        if (std::abs(glm::dot(of(i).n[0], shared.line)) > rounding) return;
    }
    if (shared.line != Vec3(0.0)) keepIdle(line, rounding);
    if (shared.count == 2 || shared.isBarred) return;
    shared.push = shared.turn = Vec3(0.0);
    double sign = 1.0;
    for (size_t i = 0; i < shared.count; ++i) {
        const Vec3 rest = shared.count == 3 ? shared.line : sign * push(i + 3);
        shared.pressures[i] = glm::dot(glm::cross(push(i + 1), push(i + 2)), rest);
        if (shared.count == 4) sign = -sign;
        const Vec3 force = shared.pressures[i] * push(i);
        shared.push += glm::dot(force, shared.line) * shared.line;
        shared.turn -= kInertia / m_moment.radius * glm::cross(of(i).n[0], force);
    }
    std::array<Vec3, 4> turned{};
    for (size_t i = 0; i < shared.count; ++i) {
        if (of(i).mode != Mode::slipping) continue;
        const Vec3 rate = shared.push - m_moment.radius * glm::cross(shared.turn, of(i).n[0]), d = of(i).d[0];
        turned[i] = -of(i).held.friction / glm::length(of(i).u[0]) * (rate - glm::dot(rate, d) * d);
    }
    const auto apart = [&](size_t i) { return push(i) - push(0); };
    const auto turns = [&](size_t i) { return turned[i] - turned[0]; };
    const Vec3 last = shared.count == 3 ? shared.line : apart(3);
    shared.rate = glm::dot(glm::cross(turns(1), apart(2)) + glm::cross(apart(1), turns(2)), last);
    if (shared.count == 4) shared.rate += glm::dot(glm::cross(apart(1), apart(2)), turns(3));
}

/// Term k of what is zero while any share of the load has the same sum of N: the determinant of the pushes'
/// differences.
double Series::imbalance(int k) const {
    const auto apart = [&](size_t i, int j) {
        return pushPer(m_contacts[m_shared.contacts[i]], j) - pushPer(m_contacts[m_shared.contacts[0]], j);
    };
    double sum = 0.0;
    for (int j = m_shared.count == 3 ? k : 0; j <= k; ++j) {
        Vec3 area(0.0);
        for (int m = 0; m <= j; ++m) area += glm::cross(apart(1, m), apart(2, j - m));
        sum += glm::dot(area, m_shared.count == 3 ? m_shared.line : apart(3, k - j));
    }
    return sum;
}

/// Shares the load of order k such that the sums remain equal.
void Series::share(int k) {
    move(k);
    const double part = -imbalance(k + 1) * (k + 1) / (unit() * m_shared.rate);
    for (size_t i = 0; i < m_shared.count; ++i) {
        Contact &contact = m_contacts[m_shared.contacts[i]];
        const double pressure = part * m_shared.pressures[i];
        contact.N[k] += pressure;
        contact.r[k] += pressure * basis(contact, 0);
    }
    m_a[k] += part * m_shared.push;
    m_al[k] += part * m_shared.turn;
}

void Series::solveOrder(int k) {
    // Only where slipping or rolling starts do the unknowns of an order contribute to directions, by the order.
    bool areSame = !m_rollStarts;
    for (const Contact &contact : contacts()) areSame = areSame && contact.mode != Mode::starting;
    if (k > (m_isSlaved ? 0 : 1) && areSame)
        m_equations.again();
    else
        m_equations.begin(m_unknowns);
    for (uint32_t i = 0; i < m_count; ++i) {
        Contact &contact = m_contacts[i];
        if (!m_equations.areSolved()) contact.isIdle = isIdleBesideOther(contact);
        if (i == m_slaved) {
            dense::Values &factors = m_equations.add(m_given);
            if (!m_equations.areSolved()) factors[contact.column] = 1.0;
            continue;
        }
        addRows(contact, k, m_equations);
        if (!(m_shared.idle >> i & 1U) && !contact.isIdle) continue;
        dense::Values &factors = m_equations.add(0.0);
        if (!m_equations.areSolved()) factors[contact.column] = 1.0 + contact.held.friction;
    }
    for (uint32_t j = 0; j < m_count; ++j) {
        for (uint32_t i = 0; i < j; ++i) {
            if (m_contacts[i].mode != Mode::sticking || m_contacts[j].mode != Mode::sticking) continue;
            if (m_prestressed < m_count)
                addPrestress(m_contacts[m_prestressed], k, m_equations);
            else
                addGauge(i, j, k, m_equations);
        }
    }
    const dense::Values x = m_equations.solve();
    Vec3 a(0.0), al(0.0);
    for (Contact &contact : contacts()) {
        const bool isOne = contact.mode == Mode::smooth || contact.mode == Mode::slipping;
        Vec3 force(0.0);
        for (int part = 0; part < (isOne ? 1 : 3); ++part) force += x[contact.column + part] * basis(contact, part);
        contact.r[k] += force;
        if (isOne)
            contact.N[k] = x[contact.column];
        else if (contact.mode == Mode::starting)
            contact.N[k] = x[contact.column + 3] / unitOfFriction(contact.held.friction);
        else
            contact.N[k] += glm::dot(force, contact.n[0]);
        a += force;
        al += spinPerForce(contact, force, k);
    }
    m_a[k] = m_free * (m_a[k] + a);
    m_al[k] += al;
    for (Contact &contact : contacts()) {
        if (contact.needsRate()) contact.rateKnown += a - m_moment.radius * glm::cross(al, contact.n[0]);
    }
    if (m_shared.rate != 0.0) share(k);
}

} // namespace phys
