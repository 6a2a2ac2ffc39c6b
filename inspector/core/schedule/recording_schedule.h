// SPDX-License-Identifier: GPL-3.0-or-later
// A recording's tilts as a schedule of the trade.
#pragma once

#include "core/recording/recording.h"
#include "core/schedule/trade_schedule.h"

namespace inspector {

// The tilts of the last run in it, that is from the last start, restart or other state that steps follow, from time 0
// on; ends with it, or at `duration` (s). Nothing in `switches` and one line in `error` if it can't be read.
TiltSchedule recordedSchedule(const QString &path, const Registry &registry, double duration, QString *error);

} // namespace inspector
