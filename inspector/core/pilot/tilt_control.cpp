// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pilot/tilt_control.h"

#include "base/elementary.h"

#include <cmath>

namespace inspector {

namespace {

/// Below these values the board counts as level and at rest: a tenth of what is visible.
constexpr double kStillTilt = radians(1e-3);
constexpr double kStillRate = radians(1e-2);

/// A critically damped spring towards `target`, solved exactly over the time, so the frame rate doesn't matter:
/// x - target = (c + d t) exp(-t / tau),  d = rate + c / tau.
void follow(double target, double seconds, double &tilt, double &rate) {
    const double tau = TiltControl::kResponse;
    const double c = tilt - target;
    const double d = rate + c / tau;
    const double decay = phys::elementary::exp(-seconds / tau);
    tilt = target + (c + d * seconds) * decay;
    rate = (d - (c + d * seconds) / tau) * decay;
    if (target == 0.0 && std::abs(tilt) < kStillTilt && std::abs(rate) < kStillRate) tilt = rate = 0.0;
}

/// Rounded to 1e-9, so that a heading along an axis tilts the board about one axis only.
double rounded(double share) { return std::round(share * 1e9) / 1e9; }

Tilt wantedTilt(const TiltKeys &keys) {
    const double limit = radians(kPlayTilt);
    const double right = int(keys.right) - int(keys.left);
    const double up = int(keys.up) - int(keys.down);
    const double c = rounded(std::cos(keys.heading));
    const double s = rounded(std::sin(keys.heading));
    return {limit * (c * right + s * up), limit * (c * up - s * right)};
}

} // namespace

void TiltControl::setTilt(Tilt tilt) {
    m_tilt = tilt;
    m_rate = {};
}

Tilt TiltControl::advance(double seconds) {
    const Tilt wanted = wantedTilt(m_keys);
    follow(wanted.x, seconds, m_tilt.x, m_rate.x);
    follow(wanted.y, seconds, m_tilt.y, m_rate.y);
    return m_tilt;
}

} // namespace inspector
