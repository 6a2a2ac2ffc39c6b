// SPDX-License-Identifier: MIT
// Small linear systems, by Gaussian elimination with full pivoting. Overdetermined systems are allowed if they are
// consistent; in underdetermined ones the free unknowns are 0.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace phys::dense {

inline constexpr uint32_t kMostUnknowns = 20;
inline constexpr uint32_t kMostRows = 36;
inline constexpr double kNoPivot = 1e-13; // relative to the terms it is a sum of: a smaller factor is rounding

using Values = std::array<double, kMostUnknowns>;

class Equations {
public:
    explicit Equations(uint32_t unknowns = 0)
        : m_unknowns(unknowns) {}

    void begin(uint32_t unknowns) {
        m_unknowns = unknowns;
        m_count = 0;
        m_areSolved = false;
    }

    /// The same equations with other right-hand sides: `add` is called again for each; the factors it returns must not
    /// be changed.
    void again() { m_count = 0; }
    bool areSolved() const { return m_areSolved; }

    /// Adds an equation with this right-hand side and returns its factors, which are 0.
    Values &add(double value) {
        const uint32_t row = m_count++;
        if (!m_areSolved) {
            std::fill_n(m_rows[row].begin(), m_unknowns, 0.0);
            m_from[row] = row;
        }
        m_values[row] = value;
        return m_rows[row];
    }

    Values solve() {
        if (!m_areSolved) eliminate();
        std::array<double, kMostRows> values;
        for (uint32_t i = 0; i < m_count; ++i) values[i] = m_values[m_from[i]];
        for (uint32_t k = 0; k < m_rank; ++k) {
            for (uint32_t i = k + 1; i < m_count; ++i) values[i] -= m_rows[i][k] * values[k];
        }
        for (uint32_t i = m_rank; i-- > 0;) {
            for (uint32_t j = i + 1; j < m_rank; ++j) values[i] -= m_rows[i][j] * values[j];
            values[i] /= m_rows[i][i];
        }
        Values x{};
        for (uint32_t i = 0; i < m_rank; ++i) x[m_order[i]] = values[i];
        return x;
    }

private:
    uint32_t m_unknowns;
    uint32_t m_count = 0, m_rank = 0;
    bool m_areSolved = false;
    /// After solving: rows and columns in the order of pivots, with the multipliers of the elimination below.
    std::array<Values, kMostRows> m_rows;
    std::array<Values, kMostRows> m_sizes; ///< sums of the absolute terms of each factor: its rounding is a share
    std::array<double, kMostRows> m_values;
    std::array<uint32_t, kMostRows> m_from;      ///< number of each row's equation in the order of `add`
    std::array<uint32_t, kMostUnknowns> m_order; ///< number of each column's unknown

    void eliminate() {
        m_areSolved = true;
        for (uint32_t i = 0; i < m_unknowns; ++i) m_order[i] = i;
        for (uint32_t i = 0; i < m_count; ++i) {
            for (uint32_t j = 0; j < m_unknowns; ++j) m_sizes[i][j] = std::abs(m_rows[i][j]);
        }
        for (m_rank = 0; m_rank < std::min(m_unknowns, m_count) && bringPivot(); ++m_rank) eliminateBelow();
    }

    /// The largest factor that is more than rounding. False if there is none.
    bool bringPivot() {
        uint32_t row = m_rank, column = m_rank;
        double most = 0.0;
        for (uint32_t i = m_rank; i < m_count; ++i) {
            for (uint32_t j = m_rank; j < m_unknowns; ++j) {
                const double size = std::abs(m_rows[i][j]);
                if (size <= most || size <= kNoPivot * m_sizes[i][j]) continue;
                most = size;
                row = i;
                column = j;
            }
        }
        if (row != m_rank) {
            swapRows(m_rows, row);
            swapRows(m_sizes, row);
            std::swap(m_from[m_rank], m_from[row]);
        }
        if (column != m_rank) {
            for (uint32_t i = 0; i < m_count; ++i) std::swap(m_rows[i][m_rank], m_rows[i][column]);
            for (uint32_t i = m_rank; i < m_count; ++i) std::swap(m_sizes[i][m_rank], m_sizes[i][column]);
            std::swap(m_order[m_rank], m_order[column]);
        }
        return most > 0.0;
    }

    void swapRows(std::array<Values, kMostRows> &rows, uint32_t row) {
        std::swap_ranges(rows[row].begin(), rows[row].begin() + m_unknowns, rows[m_rank].begin());
    }

    void eliminateBelow() {
        const Values &pivot = m_rows[m_rank], &pivotSizes = m_sizes[m_rank];
        for (uint32_t i = m_rank + 1; i < m_count; ++i) {
            Values &row = m_rows[i];
            const double factor = row[m_rank] / pivot[m_rank];
            row[m_rank] = factor;
            if (factor == 0.0) continue;
            for (uint32_t j = m_rank + 1; j < m_unknowns; ++j) {
                row[j] -= factor * pivot[j];
                m_sizes[i][j] += std::abs(factor) * pivotSizes[j];
            }
        }
    }
};

} // namespace phys::dense
