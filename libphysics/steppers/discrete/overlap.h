// SPDX-License-Identifier: MIT
// The collision of textbooks, definition D of model.md 10: what `as_reported` shows.
#pragma once

#include "contact_step.h"

namespace phys {

/// Pushes the ball out of what it overlaps, deepest first, at most 8 times, and reflects it each time. h: length of the
/// substep that ends `after` seconds into the step.
void collideAsReported(const StepContext &context, double h, double after, Ball &ball);

} // namespace phys
