// SPDX-License-Identifier: GPL-3.0-or-later
// Arrow keys to tilt: smooth, up to kPlayTilt, and back to level when released.
#pragma once

#include "core/setup/inputs.h"

namespace inspector {

struct TiltKeys {
    bool left = false, right = false, up = false, down = false;
    double heading = 0.0; // rad from y towards x: which way on the board `up` is; 0 is +y
    bool any() const { return left || right || up || down; }
};

// The board follows the keys like a damped spring without overshoot. The same keys and times give the same tilt.
class TiltControl {
public:
    static constexpr double kResponse = 0.12; // s, time constant

    void setKeys(TiltKeys keys) { m_keys = keys; }
    TiltKeys keys() const { return m_keys; }
    // The board was put to this tilt by something else; it starts from there.
    void setTilt(Tilt tilt);
    // seconds: since the last call, >= 0.
    Tilt advance(double seconds);
    Tilt tilt() const { return m_tilt; }
    // No key is held and the board is level: nothing to do.
    bool isAtRest() const { return !m_keys.any() && m_tilt == Tilt{}; }

private:
    TiltKeys m_keys;
    Tilt m_tilt;
    Tilt m_rate; // rad/s
};

} // namespace inspector
