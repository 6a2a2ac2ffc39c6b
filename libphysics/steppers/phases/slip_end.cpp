// SPDX-License-Identifier: MIT
#include "phases/slip_end.h"

#include "base/elementary.h"
#include "contact/held.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace phys {

namespace {

// Friction -B d changes a slip |u| d by (c - D d) B, D = (5/2, 7/2) across and along. So in units of B d turns at the
// rate turnOf(d)/|u|, and |u| falls at the rate fallOf(d).
double turnOf(const Vec2 &c, const Vec2 &d) { return glm::dot(c, quarterTurn(d)) - d.x * d.y; }
double fallOf(const Vec2 &c, const Vec2 &d) { return 2.5 + d.y * d.y - glm::dot(c, d); }

/// To which a slip's direction turns, near d: Newton's method. False if there is none.
bool findLimit(const Vec2 &c, Vec2 &d) {
    constexpr int kMost = 12;
    for (int i = 0; i < kMost; ++i) {
        const double rate = d.y * d.y - d.x * d.x - glm::dot(c, d), turn = -turnOf(c, d) / rate;
        if (!(rate < 0.0)) return false;
        d += turn * quarterTurn(d);
        d /= glm::length(d);
        if (std::abs(turn) <= 0x1p-50) return true;
    }
    return false;
}

/// When a slip ends whose direction is `angle` from its limit, in units of |u|/B; 0 if the series doesn't converge. The
/// equations are the same for any multiple of the slip, so this is a power series in the angle: model.md 14.2.
double timeToEnd(const Vec2 &c, const Vec2 &limit, double angle) {
    constexpr int kTerms = 32;
    constexpr double kTail = 1e-14;
    std::array<double, kTerms> fall{}, turn{}, time{};                          // terms of the rates and of the result
    Vec2 once(glm::dot(c, limit), glm::dot(c, quarterTurn(limit)));             // c.d and its derivative
    Vec2 twice(limit.x * limit.x - limit.y * limit.y, 2.0 * limit.x * limit.y); // cosine and sine of twice the angle
    double sum = 0.0, power = 1.0, before = kNever;
    for (size_t k = 0; k < kTerms; ++k) {
        fall[k] = (k == 0 ? 3.0 : 0.0) - 0.5 * twice.x - once.x;
        turn[k] = once.y - 0.5 * twice.y;
        const double next = 1.0 / (static_cast<double>(k) + 1.0);
        once = next * Vec2(once.y, -once.x);
        twice = 2.0 * next * quarterTurn(twice);
        double known = k == 0 ? -1.0 : 0.0;
        for (size_t j = 1; j <= k; ++j) known += fall[j] * time[k - j];
        for (size_t j = 2; j <= k; ++j) known -= turn[j] * static_cast<double>(k - j + 1) * time[k - j + 1];
        time[k] = known / (static_cast<double>(k) * turn[1] - fall[0]);
        const double term = power * time[k];
        sum += term;
        if (std::abs(before) + std::abs(term) <= kTail * sum) return sum;
        before = term;
        power *= angle;
    }
    return 0.0;
}

/// The least component across the support of a slip's direction that turns by a small angle.
double leastAcross(const Vec2 &from, const Vec2 &to) {
    const double least = std::min(from.x, to.x);
    return least < 0.0 ? -1.0 : least;
}

} // namespace

std::optional<SlipEnd> SlipEnd::of(const Moment &moment, const Bearing &rough, const Bearing &support) {
    constexpr double kSmall = 16.0;                // of the rounding of places
    constexpr double kFar = 0.5, kMostTurn = 1e-5; // rad: of the slip, and of the way
    constexpr double kLeast = 1e-6;                // of the friction
    const double B = rough.friction(), speed = glm::length(rough.reaction.slip);
    if (!(speed * speed <= kSmall * moment.rounding * moment.radius * B)) return std::nullopt;
    SlipEnd phase(moment, rough, support);
    const Vec2 c = phase.m_drive / B, d = phase.m_slip / speed;
    Vec2 limit = d;
    if (!findLimit(c, limit) || !(fallOf(c, limit) > 0.0)) return std::nullopt;
    const double angle = elementary::atan2(glm::dot(d, quarterTurn(limit)), glm::dot(d, limit));
    if (!(std::abs(angle) <= kFar)) return std::nullopt;
    if (!(support.reaction.pressure + B * (leastAcross(d, limit) - d.x) > kLeast * B)) return std::nullopt;
    phase.m_time = speed / B * timeToEnd(c, limit, angle);
    const double turn = phase.m_time * phase.m_curvature * glm::length(moment.velocity);
    if (!(phase.m_time > 0.0 && turn <= kMostTurn)) return std::nullopt;
    return phase;
}

SlipEnd::SlipEnd(const Moment &moment, const Bearing &rough, const Bearing &support)
    : m_contact(rough.contact)
    , m_up(rough.held.normal)
    , m_across(support.held.normal)
    , m_along(glm::cross(m_up, m_across))
    , m_drilling(glm::dot(moment.spin, m_up) * m_up)
    , m_radius(moment.radius)
    , m_slip(glm::dot(rough.reaction.slip, m_across), glm::dot(rough.reaction.slip, m_along))
    , m_gravity(glm::dot(moment.gravity, m_across), glm::dot(moment.gravity, m_along)) {
    if (!isFace(support.held)) m_curvature = 1.0 / m_radius;
    const double speed = glm::dot(moment.velocity, m_along);
    m_rolling = speed - 2.0 / 7.0 * m_slip.y;
    m_drive = {-m_curvature * speed * (speed - m_slip.y), m_gravity.y}; // what rolls turns with the way
    m_most = std::abs(m_drive.x) + std::abs(m_drive.y) + rough.friction();
}

Way SlipEnd::at(double t) const {
    const double angle = m_curvature * t * m_rolling; // up to its square
    const double pull = 5.0 / 7.0 * (m_gravity.y - 0.5 * angle * m_gravity.x);
    const double way = t * (m_rolling + 0.5 * t * pull) + 2.0 / 7.0 * meanTime(t) * m_slip.y;
    const double speed = m_rolling + t * pull + 2.0 / 7.0 * left(t) * m_slip.y;
    return {way * (m_along - 0.5 * angle * m_across),
            speed * ((1.0 - 0.5 * angle * angle) * m_along - angle * m_across)};
}

Place SlipEnd::placeAt(double t) const {
    const Way now = at(t);
    const Vec3 slip = m_slip.x * m_across + m_slip.y * m_along;
    const Way rolls{now.way - meanTime(t) * slip, now.velocity - left(t) * slip};
    return rolledPlace(now, rolls, m_up, m_drilling, m_radius, t);
}

/// All energy of the slip, and the work of what drives it.
Losses SlipEnd::losses(double t) const {
    const auto energy = [&](const Vec2 &u) { return m_slip.x * u.x / 5.0 + m_slip.y * u.y / 7.0; };
    const double all = energy(m_slip) + m_time * energy(m_drive);
    return {(1.0 - left(t) * left(t)) * all, 0.0};
}

} // namespace phys
