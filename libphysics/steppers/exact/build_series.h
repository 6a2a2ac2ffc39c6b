// SPDX-License-Identifier: MIT
// Builds series in a suitable time unit, with the modes that hold from now on: model.md 14.2.
#pragma once

#include "exact/touching.h"
#include "phases/series.h"

namespace phys {

/// Changes the response if its modes end immediately; false if no others follow. No resistance acts on a ball that
/// begins to slip.
bool buildSeries(MovingBall &ball, Touching &touching, Response &response, Series &series);

} // namespace phys
