// SPDX-License-Identifier: MIT
// Series in the unit of time that suits them, with the modes that hold in the moments to come: model.md 14.2.
#pragma once

#include "exact/touching.h"
#include "phases/series.h"

namespace phys {

/// Changes the response where its modes end at once. A ball that begins to slip is held by no resistance any more.
void buildSeries(MovingBall &ball, Touching &touching, Response &response, Series &series);

} // namespace phys
