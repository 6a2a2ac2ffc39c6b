// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace inspector::gl {

/// A square, tileable texture of wood fibres along the rows: 128 is the mean. Deterministic.
std::vector<std::uint8_t> woodGrain(int size);

} // namespace inspector::gl
