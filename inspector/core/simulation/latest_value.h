// SPDX-License-Identifier: GPL-3.0-or-later
// The newest of a stream of values, passed from one thread to another without a lock: a triple buffer.
#pragma once

#include <array>
#include <atomic>

namespace inspector {

/// One thread publishes, one other takes. Neither ever blocks; values in between are dropped. The alignment keeps the
/// indices of the two sides on separate cache lines.
template<typename Value>
class LatestValue { // NOLINT(clang-analyzer-optin.performance.Padding)
public:
    explicit LatestValue(const Value &initial) { m_slots.fill(initial); }

    /// Publisher's side.
    void publish(const Value &value) {
        m_slots[m_written] = value;
        m_written = m_middle.exchange(m_written | kFresh, std::memory_order_acq_rel) & kIndex;
    }

    /// Taker's side: moves on to the newest value; false if there is none since the last call.
    bool take() {
        if (!isFresh()) return false;
        m_read = m_middle.exchange(m_read, std::memory_order_acq_rel) & kIndex;
        return true;
    }

    /// Taker's side: whether take() would find a newer value.
    bool isFresh() const { return (m_middle.load(std::memory_order_relaxed) & kFresh) != 0; }

    /// Taker's side: what the last successful take() found; the initial value before that.
    const Value &value() const { return m_slots[m_read]; }

private:
    static constexpr unsigned kIndex = 3;
    static constexpr unsigned kFresh = 4;

    std::array<Value, 3> m_slots;
    std::atomic<unsigned> m_middle{1};
    alignas(64) unsigned m_written = 0; ///< publisher's alone
    alignas(64) unsigned m_read = 2;    ///< taker's alone
};

} // namespace inspector
