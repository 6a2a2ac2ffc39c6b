// SPDX-License-Identifier: MIT
// A few linear equations, by elimination with full pivoting. More of them than unknowns are allowed if they agree, and
// fewer: what they leave open is 0.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace phys::dense {

inline constexpr uint32_t kMostUnknowns = 20;
inline constexpr uint32_t kMostRows = 36;
inline constexpr double kNoPivot = 1e-10; // relative to the largest: a row that says nothing new

using Values = std::array<double, kMostUnknowns>;

struct Row {
    Values factors{};
    double value = 0.0;
};

class Equations {
public:
    explicit Equations(uint32_t unknowns)
        : m_unknowns(unknowns) {}

    Row &add() {
        m_rows[m_count] = Row{};
        return m_rows[m_count++];
    }

    Values solve() {
        std::array<uint32_t, kMostUnknowns> order{};
        for (uint32_t i = 0; i < m_unknowns; ++i) order[i] = i;
        uint32_t rank = 0;
        double largest = 0.0;
        for (; rank < std::min(m_unknowns, m_count); ++rank) {
            const double pivot = bringPivot(rank, order);
            largest = std::max(largest, pivot);
            if (pivot <= kNoPivot * largest) break;
            eliminate(rank, order);
        }
        Values x{};
        for (uint32_t i = rank; i-- > 0;) {
            double sum = m_rows[i].value;
            for (uint32_t j = i + 1; j < rank; ++j) sum -= m_rows[i].factors[order[j]] * x[order[j]];
            x[order[i]] = sum / m_rows[i].factors[order[i]];
        }
        return x;
    }

private:
    uint32_t m_unknowns;
    uint32_t m_count = 0;
    std::array<Row, kMostRows> m_rows;

    double bringPivot(uint32_t rank, std::array<uint32_t, kMostUnknowns> &order) {
        uint32_t row = rank, column = rank;
        double most = 0.0;
        for (uint32_t i = rank; i < m_count; ++i) {
            for (uint32_t j = rank; j < m_unknowns; ++j) {
                const double size = std::abs(m_rows[i].factors[order[j]]);
                if (size <= most) continue;
                most = size;
                row = i;
                column = j;
            }
        }
        std::swap(m_rows[rank], m_rows[row]);
        std::swap(order[rank], order[column]);
        return most;
    }

    void eliminate(uint32_t rank, const std::array<uint32_t, kMostUnknowns> &order) {
        const Row &pivot = m_rows[rank];
        for (uint32_t i = rank + 1; i < m_count; ++i) {
            Row &row = m_rows[i];
            const double factor = row.factors[order[rank]] / pivot.factors[order[rank]];
            if (factor == 0.0) continue;
            for (uint32_t j = rank; j < m_unknowns; ++j) row.factors[order[j]] -= factor * pivot.factors[order[j]];
            row.value -= factor * pivot.value;
        }
    }
};

} // namespace phys::dense
