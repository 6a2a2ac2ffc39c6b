// SPDX-License-Identifier: GPL-3.0-or-later
// A recording's tilts as a schedule for the trade.
#pragma once

#include "core/recording/recording.h"
#include "core/schedule/trade_schedule.h"

namespace inspector {

/// The tilts of its last run (since the last start, restart or other state that is followed by steps), from time 0 on;
/// ends with the run, or at `duration` (s). `switches` is empty, with one line in `error`, if the recording can't be
/// read.
TiltSchedule recordedSchedule(const QString &path, const Registry &registry, double duration, QString *error);

} // namespace inspector
