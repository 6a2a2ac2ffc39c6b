// SPDX-License-Identifier: MIT
#include "base/utf8.h"

#include <algorithm>
#include <iterator>

namespace phys {

namespace {

/// Length of a character, by its first byte.
size_t bytesOf(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte >= 0xf0 ? 4 : byte >= 0xe0 ? 3 : byte >= 0xc0 ? 2 : 1;
}

} // namespace

bool isContinuation(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

Character firstCharacter(std::string_view text) {
    constexpr Character kNone{0, 0};
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80) return first >= 0x20 && first != 0x7f ? Character{1, first} : kNone;
    const size_t length = bytesOf(text.front());
    if (length == 1 || first > 0xf4 || length > text.size()) return kNone;
    uint32_t code = first & (0x7fU >> length);
    for (size_t i = 1; i < length; ++i) {
        if (!isContinuation(text[i])) return kNone;
        code = (code << 6) | (static_cast<unsigned char>(text[i]) & 0x3fU);
    }
    constexpr uint32_t kLeast[] = {0, 0, 0xa0, 0x800, 0x10000}; // 0xa0: those below are control characters
    const bool isSurrogate = code >= 0xd800 && code <= 0xdfff;
    return code < kLeast[length] || code > 0x10ffff || isSurrogate ? kNone : Character{length, code};
}

bool isUnseen(uint32_t code) {
    constexpr uint32_t kRanges[][2] = {{0xa0, 0xa0},     {0xad, 0xad},     {0x1680, 0x1680}, {0x2000, 0x200f},
                                       {0x2028, 0x202f}, {0x205f, 0x206f}, {0x3000, 0x3000}, {0xfeff, 0xfeff}};
    return std::any_of(std::begin(kRanges), std::end(kRanges),
                       [code](const auto &range) { return code >= range[0] && code <= range[1]; });
}

size_t wholeCharacters(std::string_view text) {
    size_t begin = text.size();
    while (begin > 0 && isContinuation(text[begin - 1])) --begin;
    const bool isIncomplete = begin > 0 && bytesOf(text[begin - 1]) > text.size() - begin + 1;
    return isIncomplete ? begin - 1 : text.size();
}

} // namespace phys
