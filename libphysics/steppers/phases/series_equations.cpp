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

Vec3 axisOf(uint32_t i) { return {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0}; }

} // namespace

/// Force r per unit of a contact's unknown.
Vec3 Series::basis(const Contact &contact, uint32_t part) const {
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
    if (m_rolls < m_count && &contact == &m_contacts[m_rolls]) {
        spin -= kInertia * contact.held.resistance / m_moment.radius * glm::dot(force, contact.n[0]) * m_rolling[0];
    }
    return steadied(spin, k);
}

/// Term k of the normal acceleration, as far as forces are known.
double Series::apart(const Contact &contact, int k) const {
    double apart = 0.0;
    for (int j = 0; j <= contact.lastNormal(k); ++j) {
        apart += glm::dot(contact.n[j], m_a[k - j]);
        if (contact.isFlat) break;
        apart += glm::dot(contact.held.across * m_v[j], contact.held.across * m_v[k - j]) / m_moment.radius;
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
            const uint32_t width = other.mode == Mode::smooth || other.mode == Mode::slipping ? 1 : 3;
            for (uint32_t part = 0; part < width; ++part) {
                const Vec3 force = basis(other, part);
                Vec3 change = force;
                if (ofSlip) change -= R * glm::cross(spinPerForce(other, force, k), n0);
                factors[other.column + part] = glm::dot(axis, change);
            }
        }
        return factors;
    };
    if (contact.mode == Mode::sticking) {
        for (uint32_t i = 0; i < 3; ++i) add(axisOf(i), true, -glm::dot(axisOf(i), contact.rateKnown));
        return;
    }
    add(n0, false, -apart(contact, k));
    if (contact.mode == Mode::starting) {
        const double growth = unit() * mu * contact.N[0] / (contact.speed[0] * (k + 1));
        const Vec3 d0 = contact.d[0];
        for (uint32_t i = 0; i < 3; ++i) {
            const Vec3 across = axisOf(i) - d0[static_cast<int>(i)] * d0;
            const double known =
                contact.directionKnown[static_cast<int>(i)] - growth * glm::dot(across, contact.rateKnown);
            dense::Values &factors = add(growth * across, true, known);
            factors[contact.column + i] += 1.0;
            factors[contact.column + 3] -=
                (n0[static_cast<int>(i)] - mu * d0[static_cast<int>(i)]) / unitOfFriction(mu);
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
        for (uint32_t part = 0; part < 3 && !equations.areSolved(); ++part) {
            factors[contact.column + part] = (d0[static_cast<int>(part)] + mu * n0[static_cast<int>(part)]) / unit;
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
    for (uint32_t part = 0; part < 3 && !equations.areSolved(); ++part) {
        factors[a.column + part] = ofA[static_cast<int>(part)];
        factors[b.column + part] = ofB[static_cast<int>(part)];
    }
}

/// Whether the pressure of a contact that doesn't stick is zero, as that of the opposite one isn't.
bool Series::isIdleBesideOther(const Contact &contact) const {
    if (contact.mode != Mode::smooth && contact.mode != Mode::slipping) return false;
    return std::any_of(contacts().begin(), contacts().end(), [&](const Contact &other) {
        return isIdleBeside(contact.n[0], other.n[0], m_moment.gravity,
                            &contact < &other || other.mode == Mode::sticking);
    });
}

/// Of three slipping contacts with normals in one plane: whether and how they share a load.
void Series::findShared() {
    m_shared.rate = 0.0;
    uint32_t count = 0;
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = m_contacts[i];
        if (contact.needsRate()) return;
        if (contact.partner < m_count || !(contact.N[0] > 0.0)) continue;
        if (count == 3) return;
        m_shared.contacts[count++] = i;
    }
    if (count < 3) return;
    const Contact *of[3];
    std::array<Vec3, 3> pushes;
    for (size_t i = 0; i < 3; ++i) {
        of[i] = &m_contacts[m_shared.contacts[i]];
        pushes[i] = of[i]->n[0];
        if (of[i]->mode == Mode::slipping) pushes[i] -= of[i]->held.friction * of[i]->d[0];
    }
    m_shared.line = hat(glm::cross(of[0]->n[0], of[1]->n[0]));
    const double rounding = 4.0 * m_moment.rounding;
    for (const Contact *contact : of) {
        if (glm::length(contact->held.across * m_shared.line) > rounding) return;
        if (std::abs(glm::dot(contact->n[0], m_shared.line)) > rounding) return;
    }
    const auto across = [&](size_t i, size_t j) {
        return glm::dot(m_shared.line, glm::cross(pushes[i % 3], pushes[j % 3]));
    };
    m_shared.push = m_shared.turn = Vec3(0.0);
    for (size_t i = 0; i < 3; ++i) {
        m_shared.pressures[i] = across(i + 1, i + 2);
        const Vec3 push = m_shared.pressures[i] * pushes[i];
        m_shared.push += glm::dot(push, m_shared.line) * m_shared.line;
        m_shared.turn -= kInertia / m_moment.radius * glm::cross(of[i]->n[0], push);
    }
    for (size_t i = 0; i < 3; ++i) {
        if (of[i]->mode != Mode::slipping) continue;
        const Vec3 rate = m_shared.push - m_moment.radius * glm::cross(m_shared.turn, of[i]->n[0]);
        const Vec3 turned =
            -of[i]->held.friction / glm::length(of[i]->u[0]) * (rate - glm::dot(rate, of[i]->d[0]) * of[i]->d[0]);
        m_shared.rate += glm::dot(m_shared.line, glm::cross(turned, pushes[(i + 1) % 3] - pushes[(i + 2) % 3]));
    }
}

/// Term k of what is zero while any share of the load has the same sum of N.
double Series::imbalance(int k) const {
    const auto push = [&](size_t i, int j) {
        const Contact &contact = m_contacts[m_shared.contacts[i % 3]];
        const Vec3 rubs = contact.mode == Mode::slipping ? contact.held.friction * contact.d[j] : Vec3(0.0);
        return (j == 0 ? contact.n[0] : Vec3(0.0)) - rubs;
    };
    double sum = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        for (int j = 0; j <= k; ++j) sum += glm::dot(m_shared.line, glm::cross(push(i, j), push(i + 1, k - j)));
    }
    return sum;
}

/// Shares the load of order k such that the sums remain equal.
void Series::share(int k) {
    move(k);
    const double part = -imbalance(k + 1) * (k + 1) / (unit() * m_shared.rate);
    for (size_t i = 0; i < 3; ++i) {
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
        const Contact &contact = m_contacts[i];
        if (i == m_slaved) {
            dense::Values &factors = m_equations.add(m_given);
            if (!m_equations.areSolved()) factors[contact.column] = 1.0;
            continue;
        }
        addRows(contact, k, m_equations);
        if (!isIdleBesideOther(contact)) continue;
        dense::Values &factors = m_equations.add(0.0);
        if (!m_equations.areSolved()) factors[contact.column] = 1.0 + contact.held.friction;
    }
    for (uint32_t j = 0; j < m_count; ++j) {
        for (uint32_t i = 0; i < j; ++i) {
            if (m_contacts[i].mode == Mode::sticking && m_contacts[j].mode == Mode::sticking)
                addGauge(i, j, k, m_equations);
        }
    }
    const dense::Values x = m_equations.solve();
    Vec3 a(0.0), al(0.0);
    for (Contact &contact : contacts()) {
        const bool isOne = contact.mode == Mode::smooth || contact.mode == Mode::slipping;
        Vec3 force(0.0);
        for (uint32_t part = 0; part < (isOne ? 1U : 3U); ++part)
            force += x[contact.column + part] * basis(contact, part);
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
    for (Contact &contact : contacts()) contact.rateKnown += a - m_moment.radius * glm::cross(al, contact.n[0]);
    if (m_shared.rate != 0.0) share(k);
}

} // namespace phys
