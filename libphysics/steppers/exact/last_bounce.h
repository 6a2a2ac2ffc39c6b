// SPDX-License-Identifier: MIT
// Which of infinitely many bounces is treated as the last: model.md 6.4.
#pragma once

#include "exact/moving_ball.h"

namespace phys {

/// What is counted, by its cost: one of many bounces on a face, a hop along a face against resistance or friction, any
/// other hop, and a phase of series between hops with so many lasting contacts.
inline constexpr uint32_t kBounceCount = 1, kResistedCount = 5, kHopCount = 8;
constexpr uint32_t seriesCount(uint32_t contacts) { return 36 * contacts; }

/// Counts a phase of this length (s) as one of those, if it is short.
void countHop(uint32_t count, double time, MovingBall &ball);

/// After this many hops in a step, bounces may be taken together that are alike but for rounding.
inline constexpr uint32_t kSomeHops = 500 * kHopCount;
inline bool hasSomeHops(const MovingBall &ball) { return ball.hops >= kSomeHops; }

/// After this many hops in a step, bounces of a ball that hardly moves any more end far higher, so that it comes to
/// rest; a step in which it doesn't is refused. Those that take no more than that hardly ever exceed the work limit.
inline constexpr uint32_t kMostHops = 12'000;
inline constexpr uint32_t kManyHops = kMostHops * kHopCount;
inline bool hasManyHops(const MovingBall &ball) { return ball.hops >= kManyHops; }

/// Refuses a step in which what a ball with many hops has done since then may be inexact: it hasn't come to rest where
/// it was.
phys_status checkHops(const MovingBall &ball);

/// The largest height of last bounces at smooth contacts, m.
double lastHeight(const MovingBall &ball);

/// Speed after a bounce on one of the contacts below which it is the last: its height is at most rounding. acting: the
/// ball's acceleration then.
double lastBounce(const MovingBall &ball, const Contacts &contacts, const Contact &contact, const Vec3 &acting);

/// (m/s)^2: a bounce with a larger squared speed isn't the last, whatever the acceleration.
double squareOfFastBounce(const MovingBall &ball);

/// Whether friction at each bounce on a face ends the slip due to the flight before, or there is none.
bool endsSlips(const MovingBall &ball, const Contact &face);

/// Whether the bounces on a face end as one sum: nothing else is touched, and all further bounces are similar.
bool endsAsSeries(const MovingBall &ball, const Contacts &contacts, const Contact &face);

} // namespace phys
