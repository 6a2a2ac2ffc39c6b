// SPDX-License-Identifier: MIT
// The textbook collision, definition D of model.md 10, which `as_reported` selects.
#pragma once

#include "contact_step.h"

namespace phys {

/// Pushes the ball out of overlapping boxes, deepest first, at most 8 times, and reflects it each time. h: length of
/// the substep, which ends `after` seconds into the step.
void collideAsReported(const StepContext &context, double h, double after, Ball &ball);

} // namespace phys
