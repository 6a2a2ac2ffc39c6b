// SPDX-License-Identifier: MIT
// How much a test repeats: little where the library is compiled for debugging, much where it's optimised, and as much
// as anyone may want with the environment variable PHYS_TEST_LONG set.
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
