// SPDX-License-Identifier: MIT
// UTF-8, as far as texts from outside have to be checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace phys {

struct Character {
    size_t bytes;  ///< 0: no character of a line, but a control character or invalid UTF-8
    uint32_t code; ///< undefined for 0 bytes
};

/// Whether the byte belongs to a character that began before it.
bool isContinuation(char byte);
/// The first character of a text that isn't empty.
Character firstCharacter(std::string_view text);
/// Whether nobody sees it: blanks but for the usual one, ends of lines, directions, joiners, byte order marks.
bool isUnseen(uint32_t code);
/// How many of the text's bytes are left if an incomplete character at its end is dropped.
size_t wholeCharacters(std::string_view text);

} // namespace phys
