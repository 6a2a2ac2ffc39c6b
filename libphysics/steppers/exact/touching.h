// SPDX-License-Identifier: MIT
// What a ball touches at a moment, and which of that lasts.
#pragma once

#include "exact/moving_ball.h"

namespace phys {

class Touching {
public:
    Contacts contacts; ///< all that is touched

    /// Those that last are without a velocity across. They have numbers of their own, and are there for the law, too.
    uint32_t count() const { return m_count; }
    std::span<const Held> held() const { return {m_held.data(), m_count}; }
    const Held &held(uint32_t lasting) const { return m_held[lasting]; }
    Held &held(uint32_t lasting) { return m_held[lasting]; }
    uint32_t numberOf(uint32_t lasting) const { return m_numbers[lasting]; }
    const Contact &contactOf(uint32_t lasting) const { return contacts[m_numbers[lasting]]; }
    /// Whether the contact of that number lasts.
    bool lasts(uint32_t number) const {
        return std::find(m_numbers.begin(), m_numbers.begin() + m_count, number) != m_numbers.begin() + m_count;
    }

    void holdNone() { m_count = 0; }
    /// No more than kMostHeld.
    void hold(uint32_t number, const phys_params &params);
    /// All contacts without a velocity across.
    void holdStill(const Vec3 &velocity, double negligible, const phys_params &params);

private:
    std::array<uint32_t, kMostHeld> m_numbers;
    std::array<Held, kMostHeld> m_held;
    uint32_t m_count = 0;
};

/// Puts the ball exactly at the radius of the faces that it touches, and amid those that face each other: at the radius
/// of either, a ball at rest would be moved to and fro.
void takeFaces(const Contacts &contacts, MovingBall &ball);

/// The same for edges and corners beside other contacts: hit where they are nearly touched, they drive the ball to and
/// fro without end.
void takeEdges(const Contacts &contacts, MovingBall &ball);

/// Removes what is left of the velocity across the lasting contacts.
void project(const Touching &touching, MovingBall &ball);

} // namespace phys
