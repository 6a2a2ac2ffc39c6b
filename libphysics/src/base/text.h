// SPDX-License-Identifier: MIT
// Numbers in messages and from files, independent of the locale, unlike the C library's functions.
#pragma once

#include <cstdarg>
#include <cstddef>
#include <string_view>

/// Lets the compiler check a format against its arguments; MinGW's default printf attribute doesn't know %zu.
#if defined(__GNUC__) && !defined(__clang__)
#define PHYS_CHECKED_FORMAT(text, first) gnu::format(gnu_printf, text, first)
#else
#define PHYS_CHECKED_FORMAT(text, first) gnu::format(printf, text, first)
#endif

namespace phys {

/// Like snprintf, for what messages need: %c %d %g %s %u %x %zu %llu %%, with a precision for %g and %s and a width for
/// %x; %.*s is a text of that many bytes, NULs among them. %.17g is the shortest decimal that reads back, for a number
/// that was given: one just beyond a limit isn't shown as the limit. Invisible characters in texts are written as \n or
/// \x1b. Text that doesn't fit is cut off between two UTF-8 characters. size > 0.
[[PHYS_CHECKED_FORMAT(3, 4)]] void writeText(char *out, size_t size, const char *format, ...);
[[PHYS_CHECKED_FORMAT(3, 0)]] void writeTextOf(char *out, size_t size, const char *format, va_list arguments);

/// Parses the whole word as a number with '.' as the decimal point; false if it isn't one.
bool parseNumber(std::string_view word, double &out);
/// Whether a word that parseNumber() refuses is a number nevertheless: too large or too small for a double.
bool isBeyondDouble(std::string_view word);

} // namespace phys
