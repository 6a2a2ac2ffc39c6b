// SPDX-License-Identifier: MIT
// Failures: a status and one line of text.
#pragma once

#include "base/text.h"

#include <physics/physics.h>

#include <string_view>

namespace phys {

/// Writes the text (see writeText) to err, if that isn't null, and returns the status.
[[PHYS_CHECKED_FORMAT(3, 4)]] phys_status fail(phys_error *err, phys_status status, const char *format, ...);

/// Like fail, for what is wrong with a file: its name, and then the text. Of a name that is too long for both the
/// beginning is left out, as its end and the text say more.
[[PHYS_CHECKED_FORMAT(4, 5)]] phys_status failIn(phys_error *err, phys_status status, std::string_view file,
                                                 const char *format, ...);

} // namespace phys
