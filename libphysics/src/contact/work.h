// SPDX-License-Identifier: MIT
// How much a step has done, so that none keeps its caller waiting.
#pragma once

#include <cstdint>

namespace phys {

/// Counted rather than timed, so that the same input always gets the same answer. A unit is some nanoseconds.
class Work {
public:
    /// Of one step.
    static constexpr uint64_t kMost = 20'000'000;

    static constexpr uint64_t kEvent = 150;     ///< an event: its impacts, and what lasts then
    static constexpr uint64_t kBounce = 20;     ///< one of many on a face: its event
    static constexpr uint64_t kBox = 1;         ///< a box of which it is looked whether it is near
    static constexpr uint64_t kSearch = 10;     ///< a box that is near, before it is looked at from the way
    static constexpr uint64_t kImpact = 20;     ///< a contact's part in a round of impacts
    static constexpr uint64_t kPush = 4;        ///< of contacts that share an impact: one in one set that is tried
    static constexpr uint64_t kDisc = 8;        ///< a contact's part in a sweep of friction
    static constexpr uint64_t kEquations = 120; ///< a set of modes, solved
    static constexpr uint64_t kSeries = 850;    ///< an unknown of a set of power series
    static constexpr uint64_t kJet = 8;         ///< a power series and its rate at a moment

    explicit Work(uint64_t most = kMost)
        : m_most(most) {}

    void add(uint64_t units) { m_done += units; }
    bool isTooMuch() const { return m_done > m_most; }
    /// How many quarters of the most it has done.
    uint64_t quarters() const { return 4 * m_done / m_most; }

private:
    uint64_t m_most;
    uint64_t m_done = 0;
};

} // namespace phys
