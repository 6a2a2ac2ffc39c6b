// SPDX-License-Identifier: GPL-3.0-or-later
// Turns arrow keys into a tilt: smooth, up to kPlayTilt, and back to level when released.
#pragma once

#include "core/setup/inputs.h"

namespace inspector {

struct TiltKeys {
    bool left = false, right = false, up = false, down = false;
    double heading = 0.0; ///< rad from y towards x: the board direction of `up`; 0 is +y
    bool any() const { return left || right || up || down; }
};

/// The board follows the keys like a critically damped spring. The same keys and times give the same tilt.
class TiltControl {
public:
    static constexpr double kResponse = 0.12; ///< s, time constant

    void setKeys(TiltKeys keys) { m_keys = keys; }
    TiltKeys keys() const { return m_keys; }
    /// Called when something else has set the tilt; the control continues from there.
    void setTilt(Tilt tilt);
    /// seconds: since the last call, >= 0.
    Tilt advance(double seconds);
    Tilt tilt() const { return m_tilt; }
    /// Whether no key is held and the board is level.
    bool isAtRest() const { return !m_keys.any() && m_tilt == Tilt{}; }

private:
    TiltKeys m_keys;
    Tilt m_tilt;
    Tilt m_rate; ///< rad/s
};

} // namespace inspector
