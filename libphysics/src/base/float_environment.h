// SPDX-License-Identifier: MIT
// The floating-point environment belongs to the thread, and hosts change it: the rounding mode, subnormals flushed to
// zero (as a program linked with -ffast-math does), trapping exceptions. The library computes in the default
// environment and restores the host's.
#pragma once

#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace phys {

/// Sets the default environment for its lifetime: round to nearest, subnormals kept, no traps. The compiler doesn't
/// know about environments, but moves no memory access across a change of one: computations from memory to memory are
/// safe.
class FloatEnvironment {
public:
    FloatEnvironment(const FloatEnvironment &) = delete;
    FloatEnvironment &operator=(const FloatEnvironment &) = delete;

#if defined(__SSE2__)
    // Costs little more than reading a register if the host's environment is the default.
    FloatEnvironment()
        : m_host(_mm_getcsr())
        , m_isOther((m_host & ~kFlags) != kDefault) {
        if (m_isOther) write(kDefault);
    }
    ~FloatEnvironment() {
        if (m_isOther) write(m_host);
    }

private:
    static constexpr unsigned kFlags = 0x3f, kDefault = 0x1f80; // of MXCSR; all exceptions masked

    static void write(unsigned control) {
        asm volatile("" ::: "memory");
        _mm_setcsr(control);
        asm volatile("" ::: "memory");
    }

    unsigned m_host;
    bool m_isOther;
#else
    FloatEnvironment() {
        std::fegetenv(&m_host);
        std::fesetenv(FE_DFL_ENV);
    }
    ~FloatEnvironment() { std::fesetenv(&m_host); }

private:
    std::fenv_t m_host;
#endif
};

} // namespace phys
