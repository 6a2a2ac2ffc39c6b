// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of a step: the library's parameters, and the tilt of the board from which their gravity was computed.
#pragma once

#include <physics/physics.h>

namespace inspector {

/// Slope of the board along x and y, rad; positive makes the ball roll towards +x and +y.
struct Tilt {
    double x = 0.0;
    double y = 0.0;
    bool operator==(const Tilt &) const = default;
};

struct Inputs {
    phys_params params; ///< gravity included
    Tilt tilt;          ///< rad
    double gravity;     ///< magnitude, m/s^2
};

/// The largest tilt that sliders offer, degrees.
inline constexpr double kTiltLimit = 15.0;
/// The largest tilt in the game, for arrow keys and the autopilot alike, degrees.
inline constexpr double kPlayTilt = 8.0;

/// The library's defaults on a level board.
Inputs initialInputs();

/// Sets the direction of the gravity of `inputs` for this tilt. Each angle in (-pi/2, pi/2).
void tiltBoard(Inputs &inputs, Tilt tilt);

inline constexpr double radians(double degrees) { return degrees * 3.141592653589793 / 180.0; }
inline constexpr double degrees(double radians) { return radians * 180.0 / 3.141592653589793; }

} // namespace inspector
