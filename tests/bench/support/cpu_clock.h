// SPDX-License-Identifier: MIT
// CPU time of the calling thread, which other programs on a busy machine hardly affect.
#pragma once

#include <ctime>

namespace bench {

// s
inline double cpuTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template<typename Work>
double cpuTimeOf(Work &&work) {
    const double begin = cpuTime();
    work();
    return cpuTime() - begin;
}

} // namespace bench
