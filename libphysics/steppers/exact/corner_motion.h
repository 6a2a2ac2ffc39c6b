// SPDX-License-Identifier: MIT
// A ball held by two walls that still spins, or falls between them: model.md 6.5. As WallMotion, with three contacts
// and at most the vertical left to move in.
#pragma once

#include "base/vec.h"
#include "taylor.h"

#include <array>

namespace phys {

struct CornerContact {
    Vec3 normal{0.0};
    double friction = 0.0; ///< 0 also where the ball only drills
};

/// Two walls, and the floor or nothing.
struct CornerLaw {
    std::array<CornerContact, 3> contacts;
    bool onFloor = false; ///< whether contacts[2] is the floor; if not, it doesn't count
    Vec3 gravity{0.0};
};

struct CornerState {
    double up = 0.0; ///< velocity
    Vec3 spin{0.0};  ///< R om
};

/// Velocity of the ball's surface where it touches, along what it touches.
Vec3 slipAt(const CornerContact &contact, const CornerState &now);

/// In units in which speeds and accelerations are near 1.
class CornerMotion {
public:
    CornerMotion(const CornerLaw &law, const CornerState &now, int order = Taylor::kOrder);

    /// False if friction jams: the forces that it asks for have no solution.
    bool isSolvable() const { return m_isSolvable; }

    /// Whether anything slips; if not, s is the time.
    bool slips() const { return slipsAt(0) || slipsAt(1) || slipsAt(2); }

    /// Longest s up to which the series are good to rounding.
    double goodFor() const;

    CornerState at(double s) const;

    Taylor time, height, heat;   ///< since the start
    std::array<Taylor, 3> force; ///< normal forces per mass; without a floor force[2] is the acceleration upwards

private:
    using Vector = std::array<Taylor, 3>;
    struct Slip {
        Vector velocity, direction;
        Taylor square, speed, inverse;
    };

    CornerLaw m_law;
    Taylor m_up;
    Vector m_spin;
    std::array<Slip, 3> m_slips;
    std::array<Vector, 3> m_columns; // of the equations of the forces
    Vec3 m_rows[3];                  // of the inverse of their first terms
    Taylor m_one, m_inverse, m_clock;
    Vector m_spinRate;
    Taylor m_upRate, m_power;
    bool m_isSolvable = true;

    bool slipsAt(int contact) const { return m_law.contacts[static_cast<size_t>(contact)].friction > 0.0; }
    void extendSlips(int k);
    void extendForces(int k);
    void extendMotion(int k);
};

} // namespace phys
