// SPDX-License-Identifier: MIT
// The ball's way between two events: a closed form in the time since the phase began, model.md 3.
#pragma once

#include "shared/closed_form.h"

namespace phys {

class Motion {
public:
    struct Point {
        Vec3 position, velocity;
    };

    static Motion rest(const Vec3 &p) { return {p, Vec3(0.0), Vec3(0.0)}; }

    /// Constant acceleration: flight, frictionless rolling, every straight way; holds until `end`.
    static Motion parabola(const Vec3 &p, const Vec3 &v, const Vec3 &a, double end = kNever);

    /// Rolling freely on the floor with v != 0, model.md 3.1; ends at the stop.
    static Motion rolling(const Vec3 &p, const Vec3 &v, const Vec2 &A, double B);

    /// Slipping freely on the floor, model.md 3.6: u is the slip velocity; ends when the slip does.
    static Motion slipping(const Vec3 &p, const Vec3 &v, const Vec2 &u, const Vec2 &A, double B);

    Point at(double t) const;

    /// As at(), but `position` counts from the start: small ways keep their digits.
    Point since(double t) const;
    double end() const { return m_end; }

    /// Slip velocity and the length of the slip's way so far; only for a slipping motion.
    ResistedLaw::Point slipAt(double t) const;

    /// Length of the way in the first t seconds, m; only for ways along which rolling resistance works.
    double path(double t) const;

    /// A bound from below of n . p'' for as long as the motion lasts, where rate = n . v now.
    double leastAcceleration(const Vec3 &n, double rate) const;

    /// p'' at the start, resistance included.
    Vec3 startAcceleration() const;

    /// Bound of |p''|.
    double mostAcceleration() const { return m_most; }

    const Vec3 &acceleration() const { return m_a; } ///< without resistance
    double resistance() const { return m_B; }
    bool slips() const { return m_kind == Kind::slipping; }

private:
    enum class Kind { parabola, rolling, slipping };

    Motion(const Vec3 &p, const Vec3 &v, const Vec3 &a);

    Kind m_kind = Kind::parabola;
    Vec3 m_p, m_v, m_a; // at the start; for slip m_v and m_a are those of q, the rolling-equivalent velocity
    double m_B = 0.0;
    double m_end = kNever;
    double m_most = 0.0;
    ResistedLaw m_law;
    Vec2 m_slipStart{0.0}, m_slipEnd{0.0}; // directions of slip

    double mostSlipAlong(const Vec2 &n) const;
};

} // namespace phys
