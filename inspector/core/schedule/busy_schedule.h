// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/schedule/trade_schedule.h"

namespace inspector {

/// Of several random schedules, the one under which the ball, moved by stepper "exact", meets the most walls within
/// `horizon` (s), and then in total, while it stays in the maze. `switches` is empty, with one line in `error`, if
/// "exact" can't do any.
TiltSchedule busySchedule(const Registry &registry, const Scene &scene, const Inputs &inputs, double duration,
                          double horizon, QString *error);

} // namespace inspector
