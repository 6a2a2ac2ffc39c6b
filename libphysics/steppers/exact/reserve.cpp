// SPDX-License-Identifier: MIT
// How long contacts of the general phase stick, and which of them open or slip at once: model.md 14.1, 14.2.
#include "exact/series.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr double kLookAhead = 0x1p-6; // of the horizon: where a force that is zero shows its sign
constexpr double kParallel = 1e-12;   // square of the sine of the angle between normals

Vec3 unitOf(const Vec3 &v) {
    const double size = glm::length(v);
    return size > 0.0 ? v / size : Vec3(0.0);
}

/// Whether what is zero, give or take, falls in the moments to come: the sign of the first value that isn't.
bool falls(const Jet &f, double zero, double end) {
    double s = 0x1p-30 * end;
    while (s < end && std::abs(f.at(s)) <= 2.0 * zero) s *= 2.0;
    return f.at(std::min(s, end)) < -zero;
}

Jet product(const Jet &a, const Jet &b) {
    Jet all;
    for (int k = 0; k <= kOrder; ++k) all[k] = termOf(a, b, k);
    return all;
}

Jet dot(const VecJet &a, const VecJet &b) {
    Jet all;
    for (int k = 0; k <= kOrder; ++k) all[k] = dotTerm(a, b, k);
    return all;
}

/// constant + factor * a + b
Jet sum(double constant, double factor, const Jet &a, const Jet &b = {}) {
    Jet all;
    for (int k = 0; k <= kOrder; ++k) all[k] = factor * a[k] + b[k];
    all[0] += constant;
    return all;
}

/// (limit times the root of mu2)^2 less the square of what is needed. Its last term isn't known.
Jet squaresApart(double mu2, const Jet &limit2, const Jet &needed2) {
    Jet left = sum(0.0, -1.0, needed2, sum(0.0, mu2, limit2));
    left[kOrder] = 0.0;
    return left;
}

} // namespace

/// Without what rolling resistance needs: model.md 2.2.
VecJet Series::frictionOf(const Contact &contact) const {
    VecJet friction;
    for (int k = 0; k <= kOrder; ++k) friction[k] = contact.r[k] - termOf(contact.N, contact.n, k);
    if (m_rolls < m_count && &contact == &m_contacts[m_rolls]) {
        const double share = 5.0 / 7.0 * contact.held.resistance;
        for (int k = 0; k <= kOrder; ++k) {
            friction[k] += share * glm::cross(termOf(contact.N, m_rolling, k), contact.held.normal);
        }
    }
    return friction;
}

/// The other one if just two stick.
const Series::Contact *Series::otherSticking(const Contact &contact) const {
    const Contact *other = nullptr;
    for (const Contact &one : contacts()) {
        if (one.mode != Mode::sticking || &one == &contact) continue;
        if (other) return nullptr;
        other = &one;
    }
    return other;
}

/// A reserve that is none but for rounding.
double Series::noReserve(const Contact &contact, double pressure) const {
    const double mu = contact.held.friction;
    return 2.0 * (m_noForce + roundingOfLimit(m_moment, mu)) * mu * pressure;
}

/// (mu N)^2 less the square of the friction.
Series::Reserve Series::reserveOf(const Contact &contact) const {
    const VecJet friction = frictionOf(contact);
    Reserve beside;
    if (const Contact *other = otherSticking(contact); other && takeReserve(contact, *other, friction, beside)) {
        return beside;
    }
    const double mu = contact.held.friction;
    return {squaresApart(mu * mu, product(contact.N, contact.N), dot(friction, friction)),
            noReserve(contact, contact.N[0])};
}

/// Of two that stick: the reserve of the first in the direction that the other leaves its slip, without the forces
/// between both that rub across it; times what is 1 at the start. False if it would have to pull. model.md 14.1.
bool Series::takeReserve(const Contact &contact, const Contact &other, const VecJet &friction, Reserve &reserve) const {
    const Jet cosine = dot(contact.n, other.n), more = sum(1.0, 1.0, cosine), inertia = sum(4.5, 2.5, cosine);
    VecJet free, tangent;
    for (int k = 0; k <= kOrder; ++k) {
        free[k] = contact.crossNormal(other.n, k);
        tangent[k] = termOf(cosine, contact.n, k) - other.n[k];
    }
    const Jet squaredSine = dot(free, free), slide = dot(friction, tangent);
    const Jet most = sum(0.0, -1.0, slide, product(more, contact.N));
    if (!(more[0] > kParallel) || !(squaredSine[0] > kParallel) || !(most[0] > 0.0)) return false;
    const Jet limit = product(inertia, most);
    Jet needed = product(inertia, product(more, dot(friction, free)));
    if (m_rolls < m_count && &other == &m_contacts[m_rolls]) {
        needed = sum(0.0, -other.held.resistance, product(slide, dot(m_rolling, contact.n)), needed);
    }
    const double mu = contact.held.friction, unit = inertia[0] * more[0];
    reserve.left = squaresApart(mu * mu, product(squaredSine, product(limit, limit)), product(needed, needed));
    for (double &term : reserve.left.c) term /= unit * unit * squaredSine[0];
    reserve.none = noReserve(contact, std::max(contact.N[0], most[0] / more[0]));
    return true;
}

uint32_t Series::opening() const {
    uint32_t bits = 0;
    const double zero = m_noForce;
    for (uint32_t i = 0; i < m_count; ++i) {
        const Jet &N = m_contacts[i].N;
        if (N[0] <= zero && falls(N, zero, kLookAhead * horizon() / unit())) bits |= 1U << given(i);
    }
    return bits;
}

uint32_t Series::spent(std::span<Vec3> slips) const {
    uint32_t bits = 0;
    const double soon = kLookAhead * horizon() / unit();
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = m_contacts[i];
        if (contact.mode != Mode::sticking || contact.held.isGlued || contact.isKept) continue;
        const auto [left, none] = reserveOf(contact);
        if (left[0] > none || !falls(left, none, soon)) continue;
        const double most = contact.held.friction * contact.N[0];
        bits |= 1U << given(i);
        // Where all friction is less than rounding it has no direction yet.
        const VecJet friction = frictionOf(contact);
        slips[given(i)] = m_mirror.back(-unitOf(2.0 * left[0] < most * most ? friction[0] : friction.at(soon)));
    }
    return bits;
}

} // namespace phys
