// SPDX-License-Identifier: MIT
// The contacts of a ball at one moment, and which of them last.
#pragma once

#include "exact/moving_ball.h"

namespace phys {

class Touching {
public:
    Contacts contacts; ///< all contacts

    /// The lasting ones, with no velocity along their normals. They have numbers of their own, and are also in the form
    /// for the law.
    uint32_t count() const { return m_count; }
    std::span<const Held> held() const { return {m_held.data(), m_count}; }
    const Held &held(uint32_t lasting) const { return m_held[lasting]; }
    Held &held(uint32_t lasting) { return m_held[lasting]; }
    uint32_t numberOf(uint32_t lasting) const { return m_numbers[lasting]; }
    const Contact &contactOf(uint32_t lasting) const { return contacts[m_numbers[lasting]]; }
    /// Whether the contact with that number lasts.
    bool lasts(uint32_t number) const {
        return std::find(m_numbers.begin(), m_numbers.begin() + m_count, number) != m_numbers.begin() + m_count;
    }

    void holdNone() { m_count = 0; }
    /// At most kMostHeld.
    void hold(uint32_t number, const phys_params &params);
    /// All contacts with no velocity along their normals.
    void holdStill(const Vec3 &velocity, double negligible, const phys_params &params);

private:
    std::array<uint32_t, kMostHeld> m_numbers;
    std::array<Held, kMostHeld> m_held;
    uint32_t m_count = 0;
};

/// Bits of any contacts.
inline constexpr uint32_t kAll = ~0U;

/// Puts the ball exactly at the radius from the faces among contacts (bits), and in the middle between opposite ones:
/// if it were put at the radius from either, a ball at rest would be moved back and forth.
void takeFaces(const Contacts &contacts, uint32_t among, MovingBall &ball);

/// The same for edges and corners beside other contacts: impacts with nearly touched ones would drive the ball back and
/// forth without end. Whether that has moved the ball.
bool takeEdges(const Contacts &contacts, MovingBall &ball);

/// Removes the remaining velocity along the normals of lasting contacts. among: their bits.
void project(const Touching &touching, uint32_t among, MovingBall &ball);

} // namespace phys
