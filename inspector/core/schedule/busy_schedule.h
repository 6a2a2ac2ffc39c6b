// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/schedule/trade_schedule.h"

namespace inspector {

/// Draws several random schedules and returns the one under which the ball, moved by stepper "exact", hits the most
/// walls within `horizon` (s), and on ties in total, while it stays in the maze. `switches` is empty, with one line in
/// `error`, if "exact" fails on all of them.
TiltSchedule busySchedule(const Registry &registry, const Scene &scene, const Inputs &inputs, double duration,
                          double horizon, QString *error);

} // namespace inspector
