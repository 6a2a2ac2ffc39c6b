// SPDX-License-Identifier: MIT
// A ball that slips on the floor while it stays at a smooth wall, model.md 6.5: the only smooth phase besides the pivot
// without a closed form. Integrated as a Taylor series in xi with the terms below rounding left out.
#pragma once

namespace phys {

class WallSlip {
public:
    struct Point {
        double time;
        double across, along; ///< slip velocity u, across the wall (along its normal) and along it
        double way;           ///< integral of `along`, m
        double path;          ///< length of the slip's way, m
    };

    WallSlip() = default;

    /// across, along: u at the start, across != 0. drive: g_t along the wall. away: g_t along its normal.
    /// friction: mu_s gn > 0.
    WallSlip(double across, double along, double drive, double away, double friction);

    /// When the slip ends, or the wall's force: then the ball leaves it slipping. kNever if neither does.
    double end() const { return m_last.time; }

    Point at(double t) const;

private:
    double m_across = 0.0, m_along = 0.0; // in units of |u|
    double m_drive = 0.0;                 // in units of the friction
    double m_speed = 1.0, m_friction = 1.0;
    double m_leaves = 2.0; // |u_along / u| at which the wall's force vanishes; above 1 if it never does
    Point m_last{};

    Point integrate(double time) const;
};

} // namespace phys
