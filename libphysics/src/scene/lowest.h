// SPDX-License-Identifier: MIT
// Keeps the lowest of many values that arrive in any order, in the caller's buffer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace phys {

/// A heap with the highest of the kept values on top. Counts all values that were added.
template<class T, class Less = std::less<>>
class Lowest {
public:
    explicit Lowest(std::span<T> out)
        : m_out(out) {}

    void add(const T &value) {
        ++m_count;
        if (m_stored < m_out.size()) {
            m_out[m_stored++] = value;
            std::push_heap(m_out.begin(), end(), Less{});
        } else if (m_stored > 0 && Less{}(value, m_out.front())) {
            std::pop_heap(m_out.begin(), end(), Less{});
            m_out[m_stored - 1] = value;
            std::push_heap(m_out.begin(), end(), Less{});
        }
    }
    /// Sorts the kept values in ascending order; call it after all were added.
    void sort() { std::sort_heap(m_out.begin(), end(), Less{}); }
    uint32_t count() const { return m_count; }

private:
    auto end() const { return m_out.begin() + static_cast<std::ptrdiff_t>(m_stored); }

    std::span<T> m_out;
    size_t m_stored = 0;
    uint32_t m_count = 0;
};

} // namespace phys
