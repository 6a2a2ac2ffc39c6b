// SPDX-License-Identifier: MIT
#include "generator/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace mazes {

namespace {

// The quotient is the double nearest to the decimal, so its shortest decimal is that very one.
std::string quotient(std::int64_t dividend, double divisor) {
    std::array<char, 64> text{};
    const double value = static_cast<double>(dividend) / divisor;
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    return {text.data(), result.ptr};
}

bool isDigits(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

} // namespace

std::string metres(Length length) { return quotient(length, 1e9); }

std::string micrometres(Length length) { return quotient(length, 1e3); }

std::string millionths(std::int64_t count) { return quotient(count, 1e6); }

std::optional<std::int64_t> parseMillionths(std::string_view text) {
    const std::size_t point = text.find('.');
    const std::string_view whole = text.substr(0, point);
    const std::string_view decimals = point == std::string_view::npos ? std::string_view{} : text.substr(point + 1);
    if (whole.size() + decimals.size() == 0 || whole.size() > 9 || decimals.size() > 6) return std::nullopt;
    if (!isDigits(whole) || !isDigits(decimals)) return std::nullopt;
    std::string digits(whole);
    digits.append(decimals).append(6 - decimals.size(), '0');
    std::int64_t count = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), count);
    return count;
}

std::optional<std::uint64_t> parseWhole(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

} // namespace mazes
