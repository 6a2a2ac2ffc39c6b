// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace inspector::gl {

/// A square, tileable texture of wood fibres along the rows: 128 is the mean. Deterministic.
std::vector<std::uint8_t> woodGrain(int size);

/// A square texture, then each of its mipmaps down to a single texel. size is a power of two.
std::vector<std::vector<std::uint8_t>> mipmapsOf(std::vector<std::uint8_t> pixels, int size);

} // namespace inspector::gl
