// SPDX-License-Identifier: MIT
// How often a test repeats: little in debug builds of the library, often in optimised ones, and as often as wanted with
// the environment variable PHYS_TEST_LONG set.
#pragma once

#include <QtGlobal>

#include <cstdint>

namespace support {

inline uint64_t effort([[maybe_unused]] uint64_t debug, [[maybe_unused]] uint64_t optimised, uint64_t asked) {
    if (qEnvironmentVariableIsSet("PHYS_TEST_LONG")) return asked;
#ifdef NDEBUG
    return optimised;
#else
    return debug;
#endif
}

} // namespace support
