// SPDX-License-Identifier: MIT
// Counts the cost of a step, so that no call takes too long.
#pragma once

#include <cstdint>

namespace phys {

/// Counted rather than timed, so that the same input always has the same result. A unit is a few nanoseconds.
class Work {
public:
    /// Limit for one step.
    static constexpr uint64_t kMost = 15'000'000;

    static constexpr uint64_t kEvent = 150;    ///< an event: its impacts and its lasting contacts
    static constexpr uint64_t kTouch = 40;     ///< what is touched, and which of it lasts, besides the boxes
    static constexpr uint64_t kObstacles = 30; ///< what many bounces may meet besides their face
    static constexpr uint64_t kBounce = 20;    ///< one of many bounces on a face
    static constexpr uint64_t kBox = 1;        ///< a test whether a box is near
    static constexpr uint64_t kSearch = 10;    ///< a near box, before it is tested against the path
    static constexpr uint64_t kImpact = 20;    ///< a contact's part in a round of impacts
    static constexpr uint64_t kPush = 4;       ///< one contact in one tried set of contacts that share an impact
    static constexpr uint64_t kDisc = 8;       ///< a contact's part in a sweep of friction
    static constexpr uint64_t kEquations = 45; ///< an unknown of the equations of one combination of modes
    static constexpr uint64_t kNewton = 120;   ///< a contact's part in the equations of all friction together
    static constexpr uint64_t kSeries = 850;   ///< an unknown or a normal of a set of power series
    static constexpr uint64_t kJet = 8;        ///< evaluation of a power series and its rate

    static constexpr uint64_t kSubstep = 20; ///< a substep, besides the boxes near it and several contacts
    static constexpr uint64_t kPlace = 18;   ///< a position at which swept tries the ball

    explicit Work(uint64_t most = kMost)
        : m_most(most) {}

    void add(uint64_t units) { m_done += units; }
    uint64_t done() const { return m_done; }
    bool isTooMuch() const { return m_done > m_most; }

private:
    uint64_t m_most;
    uint64_t m_done = 0;
};

} // namespace phys
