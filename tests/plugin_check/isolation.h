// SPDX-License-Identifier: MIT
// A part of the card in a process of its own, so that a crash or an endless loop is one line.
#pragma once

#include "measures.h"

#include <functional>

namespace plugin_check {

/// What the work says; that it crashes, isn't done in time, or prints, if it does. All parts together get a minute.
Measure isolated(const std::function<Measure()> &work);

} // namespace plugin_check
