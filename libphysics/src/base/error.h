// SPDX-License-Identifier: MIT
// One way to fail: a status and one line of text.
#pragma once

#include "base/text.h"

#include <physics/physics.h>

namespace phys {

/// Writes the text (as writeText does) to err, if there is one, and returns the status.
[[PHYS_CHECKED_FORMAT(3, 4)]] phys_status fail(phys_error *err, phys_status status, const char *format, ...);

} // namespace phys
