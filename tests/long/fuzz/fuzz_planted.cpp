// SPDX-License-Identifier: MIT
// Tests the running of fuzzers: reads beyond the end of an input that begins with "no".
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 2 || data[0] != 'n' || data[1] != 'o') return 0;
    const volatile uint8_t behind = data[size];
    return behind - behind;
}
