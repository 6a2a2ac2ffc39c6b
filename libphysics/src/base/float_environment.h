// SPDX-License-Identifier: MIT
// How a processor computes is a setting of the thread, and hosts change it: other rounding, subnormals flushed to zero
// (as a program linked with -ffast-math does), exceptions that trap. The library computes in the default setting and
// gives the host its own back.
#pragma once

#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace phys {

/// The default setting while it lives: to nearest, subnormals kept, nothing traps. The compiler knows nothing of
/// settings, but moves no memory access past a change of one: so what is computed from memory into memory is safe.
class FloatEnvironment {
public:
    FloatEnvironment(const FloatEnvironment &) = delete;
    FloatEnvironment &operator=(const FloatEnvironment &) = delete;

#if defined(__SSE2__)
    // Hardly more than the reading of a register where the host's setting is the default.
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
