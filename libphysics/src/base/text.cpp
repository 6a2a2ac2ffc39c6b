// SPDX-License-Identifier: MIT
#include "base/text.h"

#include "base/system.h"
#include "base/utf8.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <system_error>

namespace phys {

namespace {

struct Arguments {
    va_list list;
};

/// One conversion of a format, as far as it is supported.
struct Conversion {
    size_t width = 0;
    int precision = -1;  ///< not given
    int longs = 0;       ///< 1: long, 2: long long
    bool isView = false; ///< the precision is an argument: a length
    bool isSize = false;
    char kind = '%';
};

/// Parses what follows a % and advances `format`. The precision may be an argument.
Conversion readConversion(const char *&format, Arguments &arguments) {
    Conversion conversion;
    while (*format >= '0' && *format <= '9')
        conversion.width = 10 * conversion.width + static_cast<size_t>(*format++ - '0');
    if (*format == '.') {
        ++format;
        conversion.precision = 0;
        if (*format == '*') {
            ++format;
            conversion.precision = va_arg(arguments.list, int);
            conversion.isView = true;
        }
        while (*format >= '0' && *format <= '9') conversion.precision = 10 * conversion.precision + (*format++ - '0');
    }
    for (; *format == 'l'; ++format) ++conversion.longs;
    if (*format == 'z') {
        ++format;
        conversion.isSize = true;
    }
    if (*format) conversion.kind = *format++;
    return conversion;
}

#if defined(__cpp_lib_to_chars) // libstdc++ has from_chars for double, libc++ doesn't up to version 19
std::from_chars_result readDouble(const char *begin, const char *end, double &out) {
    return std::from_chars(begin, end, out);
}
#else
std::from_chars_result readDouble(const char *begin, const char *end, double &out) {
    if (begin == end || *begin == '+') return {begin, std::errc::invalid_argument}; // like from_chars
    const std::string text(begin, end);
    char *rest = nullptr;
    const double number = system::stringToDouble(text.c_str(), &rest);
    const bool isZero = text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == text.npos;
    const bool isOut = std::abs(number) > std::numeric_limits<double>::max() || (number == 0.0 && !isZero);
    out = number;
    return {begin + (rest - text.c_str()), isOut ? std::errc::result_out_of_range : std::errc()};
}
#endif

class Writer {
public:
    Writer(char *out, size_t size)
        : m_out(out)
        , m_room(size - 1) {}

    void add(std::string_view text) {
        const size_t taken = text.size() <= m_room - m_length ? text.size() : m_room - m_length;
        std::memcpy(m_out + m_length, text.data(), taken);
        m_length += taken;
        m_isCut |= taken < text.size();
    }

    template<class Number, class... How>
    void addNumber(size_t width, Number number, How... how) {
        char digits[400];
        const char *end = std::to_chars(digits, digits + sizeof digits, number, how...).ptr;
        const auto length = static_cast<size_t>(end - digits);
        for (size_t i = length; i < width; ++i) add("0");
        add({digits, length});
    }

    void addDouble(double number, int precision) {
        if (std::isnan(number)) return add("nan"); // without a sign
        const bool isWhole = precision >= std::numeric_limits<double>::max_digits10;
        addNumber(0, number, std::chars_format::general, isWhole ? digitsOf(number) : precision);
    }

    /// Text from outside may contain anything: characters that aren't visible are shown as their bytes, so that a
    /// message stays one line of UTF-8 and contains no terminal control sequences.
    void addShown(std::string_view text) {
        while (!text.empty()) {
            const size_t length = visibleCharacter(text);
            if (length > 0)
                add(text.substr(0, length));
            else
                addByte(static_cast<unsigned char>(text.front()));
            text.remove_prefix(std::max<size_t>(length, 1));
        }
    }

    void addConverted(const Conversion &conversion, Arguments &arguments) {
        switch (conversion.kind) {
        case 'c': {
            const char character = static_cast<char>(va_arg(arguments.list, int));
            return addShown({&character, 1});
        }
        case 's': {
            const char *text = va_arg(arguments.list, const char *);
            if (!text) return; // an empty std::string_view's
            return addShown({text, lengthOf(text, conversion)});
        }
        case 'g':
            return addDouble(va_arg(arguments.list, double), conversion.precision < 0 ? 6 : conversion.precision);
        case 'd':
            return addNumber(conversion.width, va_arg(arguments.list, int), 10);
        case 'u':
            return addNumber(conversion.width, unsignedArgument(conversion, arguments), 10);
        case 'x':
            return addNumber(conversion.width, unsignedArgument(conversion, arguments), 16);
        default:
            return add("%");
        }
    }

    /// Drops an incomplete character at the end.
    void finish() {
        if (m_isCut) m_length = wholeCharacters({m_out, m_length});
        m_out[m_length] = '\0';
    }

private:
    /// The fewest that read back, though not fewer than those of a computed number, so that both have exponents alike.
    static int digitsOf(double number) {
        int digits = 9;
        for (double read = 0.0; digits < std::numeric_limits<double>::max_digits10; ++digits) {
            char text[40];
            const auto end = std::to_chars(text, text + sizeof text, number, std::chars_format::general, digits).ptr;
            if (parseNumber({text, static_cast<size_t>(end - text)}, read) && read == number) break;
        }
        return digits;
    }

    static size_t lengthOf(const char *text, const Conversion &conversion) {
        if (conversion.precision < 0) return std::strlen(text);
        const auto most = static_cast<size_t>(conversion.precision);
        return conversion.isView ? most : strnlen(text, most);
    }

    void addByte(unsigned char byte) {
        if (byte == '\n') return add("\\n");
        if (byte == '\r') return add("\\r");
        if (byte == '\t') return add("\\t");
        add("\\x");
        addNumber(2, static_cast<unsigned>(byte), 16);
    }

    /// Number of bytes of the first character; 0 if nobody would see it as it is.
    static size_t visibleCharacter(std::string_view text) {
        const Character first = firstCharacter(text);
        return first.bytes == 0 || isUnseen(first.code) ? 0 : first.bytes;
    }

    static unsigned long long unsignedArgument(const Conversion &conversion, Arguments &arguments) {
        if (conversion.isSize) return va_arg(arguments.list, size_t);
        if (conversion.longs == 2) return va_arg(arguments.list, unsigned long long);
        if (conversion.longs == 1) return va_arg(arguments.list, unsigned long);
        return va_arg(arguments.list, unsigned);
    }

    char *m_out;
    size_t m_room, m_length = 0;
    bool m_isCut = false;
};

} // namespace

void writeTextOf(char *out, size_t size, const char *format, va_list arguments) {
    Writer writer(out, size);
    Arguments left;
    va_copy(left.list, arguments);
    while (*format) {
        const char *percent = std::strchr(format, '%');
        const size_t plain = percent ? static_cast<size_t>(percent - format) : std::strlen(format);
        writer.add({format, plain});
        format += plain;
        if (*format) writer.addConverted(readConversion(++format, left), left);
    }
    va_end(left.list);
    writer.finish();
}

void writeText(char *out, size_t size, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    writeTextOf(out, size, format, arguments);
    va_end(arguments);
}

namespace {

/// Parses the whole word; invalid_argument if it isn't a number.
std::errc readWord(std::string_view word, double &out) {
    if (word.find_first_not_of("0123456789+-.eE") != word.npos) // excludes "inf", "nan" and the like
        return std::errc::invalid_argument;
    const char *end = word.data() + word.size();
    const auto [rest, error] = readDouble(word.data(), end, out);
    return rest == end ? error : std::errc::invalid_argument;
}

} // namespace

bool parseNumber(std::string_view word, double &out) {
    double number = 0.0;
    if (readWord(word, number) != std::errc()) return false;
    out = number;
    return true;
}

bool isBeyondDouble(std::string_view word) {
    double number = 0.0;
    return readWord(word, number) == std::errc::result_out_of_range;
}

} // namespace phys
