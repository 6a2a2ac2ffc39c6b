// SPDX-License-Identifier: MIT
// Random numbers that are the same everywhere, from a seed that a failing test prints.
#pragma once

#include <QString>
#include <QtGlobal>

#include <cstdint>

namespace support {

/// The environment variable PHYS_TEST_SEED, or a fixed number: by default every run is the same.
inline uint64_t testSeed() {
    bool isNumber = false;
    const uint64_t seed = qEnvironmentVariable("PHYS_TEST_SEED").toULongLong(&isNumber);
    return isNumber ? seed : 20240607;
}

/// SplitMix64.
class Random {
public:
    explicit Random(uint64_t seed)
        : m_state(seed) {}

    uint64_t bits() {
        uint64_t z = m_state += 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }

    /// In [low, high), a multiple of (high - low) / 2^20: short binary numbers, so that scenes are cut and moved
    /// without rounding.
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 44U) / 1048576.0);
    }

    /// In [0, count).
    uint32_t below(uint32_t count) { return static_cast<uint32_t>(bits() % count); }

private:
    uint64_t m_state;
};

} // namespace support
