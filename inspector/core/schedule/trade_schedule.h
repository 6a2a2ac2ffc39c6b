// SPDX-License-Identifier: GPL-3.0-or-later
// The tilt of the board over time, fixed in advance, so that every stepper gets the same input whatever its step size.
#pragma once

#include "core/setup/handles.h"
#include "core/setup/inputs.h"

#include <vector>

namespace inspector {

struct TiltSwitch {
    double time; ///< s, from which the tilt holds
    Tilt tilt;   ///< rad
};

struct TiltSchedule {
    QString name;                     ///< its source: "autopilot", "random:7" or a file
    std::vector<TiltSwitch> switches; ///< the first at 0, times ascending
    double duration = 0.0;            ///< s; the last tilt holds until then
};

/// s; a multiple of 1/60 s and of 10, 5, 2, 1, 0.5 and 0.1 ms, so that steps needn't be cut.
inline constexpr double kScheduleHold = 0.05;

/// The autopilot's tilts, at intervals of kScheduleHold, with the ball moved by stepper "exact"; ends at `duration` or
/// just before the ball leaves the maze. inputs: parameters and magnitude of gravity. `switches` is empty, with one
/// line in `error`, if it can't be made.
TiltSchedule autopilotSchedule(const Registry &registry, const Scene &scene, const Inputs &inputs, double duration,
                               QString *error);

/// A random tilt every half second, each within a player's range; the same for the same seed on every system.
TiltSchedule randomSchedule(uint64_t seed, double duration);

/// From a file: rows of `time tilt_x tilt_y` (s, degrees; separated by spaces or commas, # begins a comment), or a
/// table that this program wrote with --csv. A table ends the schedule with its last row, or `duration` earlier;
/// otherwise the last tilt holds until `duration`. `switches` is empty, with one line in `error`, if it can't be read.
TiltSchedule readSchedule(const QString &path, double duration, QString *error);

} // namespace inspector
