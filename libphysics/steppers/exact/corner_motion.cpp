// SPDX-License-Identifier: MIT
#include "corner_motion.h"

namespace phys {

namespace {

/// What the series leave out, in the units of the speeds.
constexpr double kLeftOut = 1e-17;

/// A determinant below this leaves no digit of the forces that could be trusted.
constexpr double kJams = 1e-9;

Vec3 termOf(const std::array<Taylor, 3> &vector, int k) { return {vector[0][k], vector[1][k], vector[2][k]}; }

void setTerm(std::array<Taylor, 3> &vector, int k, const Vec3 &value) {
    for (int axis = 0; axis < 3; ++axis) vector[static_cast<size_t>(axis)][k] = value[axis];
}

} // namespace

Vec3 slipAt(const CornerContact &contact, const CornerState &now) {
    return glm::cross(contact.normal, now.spin) + Vec3(0.0, 0.0, now.up);
}

CornerMotion::CornerMotion(const CornerLaw &law, const CornerState &now, int order)
    : m_law(law) {
    m_one[0] = 1.0;
    m_up[0] = now.up;
    setTerm(m_spin, 0, now.spin);
    for (int k = 0; k < order && m_isSolvable; ++k) {
        extendSlips(k);
        extendForces(k);
        extendMotion(k);
    }
}

/// Term k of the slips, and of dt/ds = 1/(1/r1 + 1/r2 + 1/r3): no rate has a slip below the fraction line.
void CornerMotion::extendSlips(int k) {
    m_inverse[k] = 0.0;
    for (int i = 0; i < 3; ++i) {
        if (!slipsAt(i)) continue;
        Slip &slip = m_slips[static_cast<size_t>(i)];
        const CornerState now{m_up[k], termOf(m_spin, k)};
        setTerm(slip.velocity, k, slipAt(m_law.contacts[static_cast<size_t>(i)], now));
        for (const Taylor &part : slip.velocity) slip.square[k] += productTerm(part, part, k);
        slip.speed[k] = k == 0 ? std::sqrt(slip.square[0]) : rootTerm(slip.square, slip.speed, k);
        slip.inverse[k] = quotientTerm(m_one, slip.speed, slip.inverse, k);
        for (size_t axis = 0; axis < 3; ++axis)
            slip.direction[axis][k] = quotientTerm(slip.velocity[axis], slip.speed, slip.direction[axis], k);
        m_inverse[k] += slip.inverse[k];
    }
    m_clock[k] = m_inverse[0] > 0.0 ? quotientTerm(m_one, m_inverse, m_clock, k) : m_one[k];
}

/// Term k of the forces: sum of force (normal - friction direction) = -gravity; without a floor the third unknown is
/// the acceleration upwards.
void CornerMotion::extendForces(int k) {
    for (int i = 0; i < 3; ++i) {
        const CornerContact &contact = m_law.contacts[static_cast<size_t>(i)];
        const bool isAir = i == 2 && !m_law.onFloor;
        Vec3 column = k > 0 ? Vec3(0.0) : isAir ? Vec3(0.0, 0.0, -1.0) : contact.normal;
        if (slipsAt(i)) column -= contact.friction * termOf(m_slips[static_cast<size_t>(i)].direction, k);
        setTerm(m_columns[static_cast<size_t>(i)], k, column);
    }
    if (k == 0) {
        const Vec3 a = termOf(m_columns[0], 0), b = termOf(m_columns[1], 0), c = termOf(m_columns[2], 0);
        const double determinant = glm::dot(c, glm::cross(a, b));
        m_isSolvable = std::abs(determinant) > kJams;
        if (!m_isSolvable) return;
        m_rows[0] = glm::cross(b, c) / determinant;
        m_rows[1] = glm::cross(c, a) / determinant;
        m_rows[2] = glm::cross(a, b) / determinant;
    }
    // The two walls first: their sum has the same bits in either order.
    std::array<Vec3, 3> known{Vec3(0.0), Vec3(0.0), Vec3(0.0)};
    for (size_t i = 0; i < 3; ++i) {
        for (int j = 1; j <= k; ++j) known[i] += force[i][k - j] * termOf(m_columns[i], j);
    }
    const Vec3 right = (k == 0 ? -m_law.gravity : Vec3(0.0)) - (known[0] + known[1] + known[2]);
    for (size_t i = 0; i < 3; ++i) force[i][k] = glm::dot(m_rows[i], right);
}

/// Term k + 1 of what moves: (2/5) R om' is the sum of -normal x friction.
void CornerMotion::extendMotion(int k) {
    if (!m_isSolvable) return;
    Vec3 spinRate(0.0);
    double power = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        const CornerContact &contact = m_law.contacts[i];
        if (contact.friction == 0.0) continue;
        Vec3 push;
        for (int axis = 0; axis < 3; ++axis)
            push[axis] = -contact.friction * productTerm(m_slips[i].direction[static_cast<size_t>(axis)], force[i], k);
        spinRate -= 2.5 * glm::cross(contact.normal, push);
        power += contact.friction * productTerm(m_slips[i].speed, force[i], k);
    }
    setTerm(m_spinRate, k, spinRate);
    m_upRate[k] = m_law.onFloor ? 0.0 : force[2][k];
    m_power[k] = power;

    const double share = 1.0 / (k + 1);
    const auto integral = [&](const Taylor &rate) { return share * productTerm(m_clock, rate, k); };
    time[k + 1] = share * m_clock[k];
    height[k + 1] = integral(m_up);
    heat[k + 1] = integral(m_power);
    m_up[k + 1] = integral(m_upRate);
    for (size_t axis = 0; axis < 3; ++axis) m_spin[axis][k + 1] = integral(m_spinRate[axis]);
}

double CornerMotion::goodFor() const {
    double s = kNever, slip = 1.0;
    for (int i = 0; i < 3; ++i) {
        if (slipsAt(i)) slip = std::min(slip, m_slips[static_cast<size_t>(i)].speed[0]);
    }
    for (const Taylor *series : {&time, &height, &heat}) s = std::min(s, series->goodFor(kLeftOut));
    for (const Taylor *series : {&m_up, &m_spin[0], &m_spin[1], &m_spin[2]})
        s = std::min(s, series->goodFor(kLeftOut * slip));
    return s;
}

CornerState CornerMotion::at(double s) const {
    return {m_up.at(s), {m_spin[0].at(s), m_spin[1].at(s), m_spin[2].at(s)}};
}

} // namespace phys
