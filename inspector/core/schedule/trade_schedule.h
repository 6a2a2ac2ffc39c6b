// SPDX-License-Identifier: GPL-3.0-or-later
// The tilt of the board over time, decided before anybody steps: every stepper gets the very same input, whatever its
// step size.
#pragma once

#include "core/setup/handles.h"
#include "core/setup/inputs.h"

#include <vector>

namespace inspector {

struct TiltSwitch {
    double time; // s, from which on the tilt holds
    Tilt tilt;   // rad
};

struct TiltSchedule {
    QString name;                     // what made it: "autopilot", "random:7" or a file
    std::vector<TiltSwitch> switches; // the first at 0, times ascending
    double duration = 0.0;            // s; the last tilt holds until then
};

// s; a whole number of steps of 1/60 s, 10, 5, 2, 1, 0.5 and 0.1 ms, so that no step has to be cut.
inline constexpr double kScheduleHold = 0.05;

// What the autopilot does, asked every kScheduleHold, with the ball moved by stepper "exact"; ends at `duration` or
// just before the ball leaves the maze. inputs: parameters and strength of gravity. Nothing in `switches` and one line
// in `error` if it can't be made.
TiltSchedule autopilotSchedule(const Registry &registry, const Scene &scene, const Inputs &inputs, double duration,
                               QString *error);

// Another tilt every half second, each within what a player can do; the same for the same seed, everywhere.
TiltSchedule randomSchedule(uint64_t seed, double duration);

// From a file: rows of `time tilt_x tilt_y` (s, degrees; separated by blanks or commas, # begins a comment), or a
// table that this program wrote with --csv. It ends with the last row of a table; `duration` ends it earlier, and
// rows without a table's end hold until `duration`. Nothing in `switches` and one line in `error` if it can't be read.
TiltSchedule readSchedule(const QString &path, double duration, QString *error);

} // namespace inspector
