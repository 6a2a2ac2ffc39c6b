// SPDX-License-Identifier: MIT
// Numbers in messages and from files: the same under every locale, which the C library's functions aren't.
#pragma once

#include <cstdarg>
#include <cstddef>
#include <string_view>

/// Lets the compiler check a format against its arguments; MinGW's other kind of printf knows no %zu.
#if defined(__GNUC__) && !defined(__clang__)
#define PHYS_CHECKED_FORMAT(text, first) gnu::format(gnu_printf, text, first)
#else
#define PHYS_CHECKED_FORMAT(text, first) gnu::format(printf, text, first)
#endif

namespace phys {

/// As snprintf, for what messages need: %c %d %g %s %u %x %zu %llu %%, with a precision for %g and %s and a width for
/// %x. Of texts and characters what isn't visible is written as \n or \x1b. What finds no room is cut off between two
/// characters of UTF-8. size > 0.
[[PHYS_CHECKED_FORMAT(3, 4)]] void writeText(char *out, size_t size, const char *format, ...);
[[PHYS_CHECKED_FORMAT(3, 0)]] void writeTextOf(char *out, size_t size, const char *format, va_list arguments);

/// The number that the whole of a word is, with '.' as the decimal point; false if it is none.
bool parseNumber(std::string_view word, double &out);
/// Whether a word that parseNumber() refuses is a number nevertheless: too large or too small for a double.
bool isBeyondDouble(std::string_view word);

} // namespace phys
