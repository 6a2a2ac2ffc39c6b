// SPDX-License-Identifier: MIT
// Which of infinitely many bounces is the last: model.md 6.4.
#pragma once

#include "exact/moving_ball.h"

namespace phys {

/// As high as the last bounces rise at smooth contacts, m.
double lastHeight(const MovingBall &ball);

/// Speed after a bounce on one of the contacts below which it is the last: its height is no more than rounding.
/// acting: what accelerates the ball then.
double lastBounce(const MovingBall &ball, const Contacts &contacts, const Contact &contact, const Vec3 &acting);

/// (m/s)^2: a bounce faster than its root isn't the last, whatever accelerates the ball.
double squareOfFastBounce(const MovingBall &ball);

/// Whether friction ends at each bounce on a face what slip the flight before has made, or there is none.
bool endsSlips(const MovingBall &ball, const Contact &face);

/// Whether the bounces on a face end as one sum: nothing else is touched, and from now on each is like the one before.
bool endsAsSeries(const MovingBall &ball, const Contacts &contacts, const Contact &face);

} // namespace phys
