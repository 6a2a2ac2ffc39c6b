// SPDX-License-Identifier: MIT
#include "base/error.h"

#include "base/utf8.h"

#include <algorithm>
#include <cstdarg>
#include <cstring>

namespace phys {

namespace {

constexpr size_t kLongestText = sizeof phys_error::text - 1; ///< of a message
constexpr size_t kLeastName = 64;                            ///< bytes of a long name that are shown in any case

} // namespace

phys_status fail(phys_error *err, phys_status status, const char *format, ...) {
    if (!err) return status;
    err->status = status;
    err->reserved = 0;
    va_list arguments;
    va_start(arguments, format);
    writeTextOf(err->text, sizeof err->text, format, arguments);
    va_end(arguments);
    return status;
}

phys_status failIn(phys_error *err, phys_status status, std::string_view file, const char *format, ...) {
    if (!err) return status;
    char text[kLongestText + 1];
    va_list arguments;
    va_start(arguments, format);
    writeTextOf(text, sizeof text, format, arguments);
    va_end(arguments);
    const std::string_view last = file.substr(file.size() - std::min(file.size(), kLongestText));
    char name[4 * kLongestText + 1]; // the most that writeText makes of a byte: \x1b
    writeText(name, sizeof name, "%.*s", static_cast<int>(last.size()), last.data());
    const size_t length = std::strlen(name);
    const size_t room = std::max(kLeastName, kLongestText - std::strlen(text));
    if (length <= room && last.size() == file.size()) return fail(err, status, "%s%s", name, text);
    constexpr std::string_view kLeftOut = "...";
    const char *end = name + length - (room - kLeftOut.size());
    while (isContinuation(*end)) ++end;
    return fail(err, status, "%s%s%s", kLeftOut.data(), end, text);
}

} // namespace phys

const char *phys_status_text(phys_status status) {
    switch (status) {
#define PHYS_CASE(name, value, text)                                                                                   \
    case name:                                                                                                         \
        return text;
        PHYS_STATUS_LIST(PHYS_CASE)
#undef PHYS_CASE
    default:
        return "unknown status";
    }
}

const char *phys_status_name(phys_status status) {
    switch (status) {
#define PHYS_CASE(name, value, text)                                                                                   \
    case name:                                                                                                         \
        return #name;
        PHYS_STATUS_LIST(PHYS_CASE)
#undef PHYS_CASE
    default:
        return "unknown";
    }
}
