// SPDX-License-Identifier: MIT
// A list without allocation, with room for the ball's contacts at one moment. Only its elements are written and copied.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

namespace phys {

/// Most contacts of one moment. Three normals span all forces; a ball hardly touches more.
inline constexpr uint32_t kMostContacts = 32;

template<class T>
class ShortList {
    static_assert(std::is_trivially_default_constructible_v<T>, "or all places would be written at once");

public:
    ShortList() {} // a defaulted one may clear the elements
    ShortList(const ShortList &other) { *this = other; }
    ShortList &operator=(const ShortList &other) {
        m_count = other.m_count;
        std::copy(other.begin(), other.end(), begin());
        return *this;
    }
    ~ShortList() = default;

    uint32_t count() const { return m_count; }
    bool empty() const { return m_count == 0; }
    bool isFull() const { return m_count == kMostContacts; }
    T *begin() { return m_items.data(); }
    T *end() { return begin() + m_count; }
    const T *begin() const { return m_items.data(); }
    const T *end() const { return begin() + m_count; }
    T &operator[](uint32_t i) { return m_items[i]; }
    const T &operator[](uint32_t i) const { return m_items[i]; }

    void clear() { m_count = 0; }
    void add(const T &item) { m_items[m_count++] = item; }
    void shorten(uint32_t count) { m_count = count; }

private:
    std::array<T, kMostContacts> m_items;
    uint32_t m_count = 0;
};

} // namespace phys
