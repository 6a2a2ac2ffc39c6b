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
    std::array<Values, kMostRows> m_given; ///< the factors as given, then their sizes: see `sizeOf`
    std::array<double, kMostRows> m_values;
    std::array<uint32_t, kMostRows> m_from;      ///< number of each row's equation in the order of `add`
    std::array<uint32_t, kMostUnknowns> m_order; ///< number of each column's unknown

    struct Pivot {
        uint32_t row, column;
        double size;
    };

    void eliminate() {
        m_areSolved = true;
        for (uint32_t i = 0; i < m_count; ++i) std::copy_n(m_rows[i].begin(), m_unknowns, m_given[i].begin());
        for (uint32_t i = 0; i < m_unknowns; ++i) m_order[i] = i;
        // The sizes are needed only once a pivot may be rounding: until then each one at most doubles the largest.
        double rounding = 0.0;
        bool areSizesKnown = false;
        for (m_rank = 0; m_rank < mostRank(); ++m_rank) {
            Pivot pivot = largest([](uint32_t, uint32_t) { return 0.0; });
            rounding = m_rank == 0 ? 2.0 * kNoPivot * pivot.size : 2.0 * rounding;
            if (!areSizesKnown && !(pivot.size > rounding)) {
                findSizes();
                areSizesKnown = true;
            }
            if (areSizesKnown) pivot = largest([this](uint32_t i, uint32_t j) { return kNoPivot * sizeOf(i, j); });
            if (!(pivot.size > 0.0)) return;
            bring(pivot);
            eliminateBelow();
            if (areSizesKnown) addSizes(m_rank);
        }
    }

    uint32_t mostRank() const { return std::min(m_unknowns, m_count); }

    /// The largest factor that exceeds roundingOf(row, column); of size 0 if there is none.
    template<class RoundingOf>
    Pivot largest(RoundingOf roundingOf) const {
        Pivot pivot{m_rank, m_rank, 0.0};
        for (uint32_t i = m_rank; i < m_count; ++i) {
            for (uint32_t j = m_rank; j < m_unknowns; ++j) {
                const double size = std::abs(m_rows[i][j]);
                if (size <= pivot.size || size <= roundingOf(i, j)) continue;
                pivot = {i, j, size};
            }
        }
        return pivot;
    }

    void bring(const Pivot &pivot) {
        if (pivot.row != m_rank) {
            Values &row = m_rows[pivot.row];
            std::swap_ranges(row.begin(), row.begin() + m_unknowns, m_rows[m_rank].begin());
            std::swap(m_from[m_rank], m_from[pivot.row]);
        }
        if (pivot.column != m_rank) {
            for (uint32_t i = 0; i < m_count; ++i) std::swap(m_rows[i][m_rank], m_rows[i][pivot.column]);
            std::swap(m_order[m_rank], m_order[pivot.column]);
        }
    }

    /// Leaves the multipliers in the pivot's column.
    void eliminateBelow() {
        const Values &pivot = m_rows[m_rank];
        for (uint32_t i = m_rank + 1; i < m_count; ++i) {
            Values &row = m_rows[i];
            const double factor = row[m_rank] / pivot[m_rank];
            row[m_rank] = factor;
            if (factor == 0.0) continue;
            for (uint32_t j = m_rank + 1; j < m_unknowns; ++j) row[j] -= factor * pivot[j];
        }
    }

    /// Sum of the absolute terms of a factor: its rounding is a share of that.
    double &sizeOf(uint32_t i, uint32_t j) { return m_given[m_from[i]][m_order[j]]; }

    void findSizes() {
        for (uint32_t i = 0; i < m_count; ++i) {
            for (uint32_t j = 0; j < m_unknowns; ++j) m_given[i][j] = std::abs(m_given[i][j]);
        }
        for (uint32_t pivot = 0; pivot < m_rank; ++pivot) addSizes(pivot);
    }

    void addSizes(uint32_t pivot) {
        for (uint32_t i = pivot + 1; i < m_count; ++i) {
            const double factor = std::abs(m_rows[i][pivot]);
            if (factor == 0.0) continue;
            for (uint32_t j = pivot + 1; j < m_unknowns; ++j) sizeOf(i, j) += factor * sizeOf(pivot, j);
        }
    }
};

} // namespace phys::dense
