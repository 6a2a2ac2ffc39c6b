// SPDX-License-Identifier: MIT
// Rolling round a vertical edge, pressed against it: model.md 6.2. A pendulum with resistance; all angles at which
// something happens come from its energy, the times from a Taylor series.
#pragma once

#include "base/vec.h"

namespace phys {

/// A ball on the edge. Lengths are in units of the radius R, accelerations in units of |A|, times in sqrt(R/|A|), so
/// that a scene scaled by a power of four gives the same bits.
struct Pendulum {
    double across;     ///< A along the direction of motion
    double pressing;   ///< A towards the edge, > 0
    double resistance; ///< B
    double speed;      ///< >= 0

    /// Square of the speed after turning by an angle.
    double squaredSpeed(double angle) const;

    /// Centrifugal minus pressing acceleration after turning by an angle: the ball leaves where it rises through zero.
    double lift(double angle) const;

    /// Angle at which the ball stops / flies off; kNever if it doesn't before `end` (<= pi/2).
    double stopAngle(double end) const;
    double leaveAngle(double end) const;
};

/// Where the pendulum is.
struct Swing {
    double time, angle, speed;
};

/// Swings until it has turned by `angle`, stopped or the time is up, whatever comes first.
Swing swing(const Pendulum &pendulum, double angle, double time);

} // namespace phys
