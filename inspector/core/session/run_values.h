// SPDX-License-Identifier: GPL-3.0-or-later
// With which parameters a run in the history was made.
#pragma once

#include "core/session/run_history.h"
#include "core/setup/handles.h"

#include <vector>

namespace inspector {

/// A parameter at the first and at the last step of a run.
struct RunValue {
    const phys_param_row *row;
    double first;
    double last;
};

/// Those that aren't initial, except the tilt, which the player changes all the time. The rows are those of the run's
/// last stepper, and live as long as the registry.
std::vector<RunValue> changedValues(const KeptRun &run, const Registry &registry);

} // namespace inspector
