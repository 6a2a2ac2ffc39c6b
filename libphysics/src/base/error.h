// SPDX-License-Identifier: MIT
// Failures: a status and one line of text.
#pragma once

#include "base/text.h"

#include <physics/physics.h>

namespace phys {

/// Writes the text (see writeText) to err, if that isn't null, and returns the status.
[[PHYS_CHECKED_FORMAT(3, 4)]] phys_status fail(phys_error *err, phys_status status, const char *format, ...);

} // namespace phys
