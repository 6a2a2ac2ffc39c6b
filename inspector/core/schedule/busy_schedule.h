// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/schedule/trade_schedule.h"

namespace inspector {

// Of some random schedules the one under which the ball meets most walls within `horizon` (s), then altogether, while
// it stays in the maze; moved by stepper "exact". Nothing in `switches` and one line in `error` if "exact" can't do
// any.
TiltSchedule busySchedule(const Registry &registry, const Scene &scene, const Inputs &inputs, double duration,
                          double horizon, QString *error);

} // namespace inspector
