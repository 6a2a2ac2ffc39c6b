// SPDX-License-Identifier: MIT
#include "base/error.h"

#include <cstdarg>

namespace phys {

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
