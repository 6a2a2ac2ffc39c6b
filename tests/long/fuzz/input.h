// SPDX-License-Identifier: MIT
// Reads a fuzzer's bytes as one value after another; zeros follow the last byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace fuzz {

class Input {
public:
    Input(const uint8_t *data, size_t size)
        : m_data(data)
        , m_size(size) {}

    template<class T>
    T take() {
        T value{};
        const size_t length = m_size < sizeof value ? m_size : sizeof value;
        std::memcpy(&value, m_data, length);
        m_data += length;
        m_size -= length;
        return value;
    }

    /// A number that is often useful: mostly a small multiple of 1/8, sometimes any bits.
    double number() {
        const auto kind = take<uint8_t>();
        if (kind >= 250) return take<double>();
        return take<int8_t>() / 8.0;
    }

    bool isEmpty() const { return m_size == 0; }

private:
    const uint8_t *m_data;
    size_t m_size;
};

/// Ends the process in a way that the fuzzer reports.
inline void demand(bool holds) {
    if (!holds) __builtin_trap();
}

} // namespace fuzz
