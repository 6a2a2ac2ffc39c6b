// SPDX-License-Identifier: MIT
// The end of a slip so small that its own way is rounding, while the ball leans on a smooth face or edge across the
// face on which it slips: only the time that it takes matters. model.md 14.2.
#pragma once

#include "contact/modes.h"
#include "phases/phase.h"

#include <optional>

namespace phys {

class SlipEnd {
public:
    static constexpr uint64_t lookWork() { return 12; }

    /// rough: on which it slips; support: on which it leans. Nothing if the slip is larger, doesn't end or turns far,
    /// or if the pressure may end before.
    static std::optional<SlipEnd> of(const Moment &moment, const Bearing &rough, const Bearing &support);

    Way at(double t) const;
    Place placeAt(double t) const;
    Vec3 spinAt(double t) const { return placeAt(t).spin; }
    double least(const Vec3 &n, double, double, double) const { return -m_most * glm::length(n); }
    double mostAcceleration() const { return m_most; }
    double horizon() const { return m_time; }
    End end(double, Work &) const { return {m_time, Cause::grip, m_contact}; }
    Losses losses(double t) const;

private:
    uint32_t m_contact;
    Vec3 m_up, m_across, m_along; ///< normals of both contacts, and the direction along both
    Vec3 m_drilling;              ///< the part of the spin that lasts
    double m_radius;
    double m_curvature = 0.0; ///< 1/m, of the way
    Vec2 m_slip;              ///< across and along
    Vec2 m_gravity, m_drive;  ///< likewise; what changes the slip beside friction, m/s^2
    double m_rolling;         ///< along: the velocity minus 2/7 of the slip
    double m_most, m_time = 0.0;

    SlipEnd(const Moment &moment, const Bearing &rough, const Bearing &support);

    /// Share of the slip that is left, which falls evenly: how it does is rounding.
    double left(double t) const { return 1.0 - t / m_time; }
    /// Integral of that over the time.
    double meanTime(double t) const { return 0.5 * t * (1.0 + left(t)); }
};

} // namespace phys
