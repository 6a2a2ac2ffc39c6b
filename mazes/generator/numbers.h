// SPDX-License-Identifier: MIT
// Decimal numbers in and out: exact, and the same whatever the locale.
#pragma once

#include "generator/length.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mazes {

// The shortest decimal that reads back as exactly this length, without exponent.
std::string metres(Length length);
std::string micrometres(Length length);

// A count of millionths, as a plain decimal: 250000 -> 0.25.
std::string millionths(std::int64_t count);

// Reads a plain decimal such as 12, 0.036 or .5 as a count of millionths. Nothing if it has a sign, an exponent, more
// than six decimals, more than nine digits before the point, or anything else in it.
std::optional<std::int64_t> parseMillionths(std::string_view text);

// Reads a whole number without sign; nothing if there is anything else or it doesn't fit 64 bits.
std::optional<std::uint64_t> parseWhole(std::string_view text);

} // namespace mazes
