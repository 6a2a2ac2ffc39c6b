// SPDX-License-Identifier: MIT
#include "contact/slip_energy.h"

#include <cmath>
#include <glm/mat3x3.hpp>

namespace phys {

namespace {

/// Sweeps converge like a geometric series, soon unless rough contacts are nearly parallel or opposite.
constexpr int kSweepsBetween = 50;
constexpr int kMostNewtonSteps = 40;

/// An impulse of 1 changes the slip of its own contact by 7/2.
constexpr double kSlipShare = 2.0 / 7.0;

Vec3 clipped(const Vec3 &v, double most) {
    const double size = glm::length(v);
    return size > most ? most / size * v : v;
}

void apply(const Vec3 &normal, const Vec3 &impulse, double radius, Motion &motion) {
    motion.velocity += impulse;
    motion.spin -= 2.5 / radius * glm::cross(normal, impulse);
}

/// What a disc's impulse should be while all others stay.
Vec3 best(const FrictionDisc &disc, double radius, const Motion &motion) {
    return clipped(disc.impulse - kSlipShare * slipAt(motion, disc.normal, radius), disc.most);
}

/// Gauss-Seidel; each contact's minimum is a closed form because its slip answers alike in all directions.
/// True once nothing changes by more than `negligible`.
bool sweep(std::span<FrictionDisc> discs, double radius, double negligible, Motion &motion) {
    double largest = 0.0;
    for (int i = 0; i < kSweepsBetween; ++i) {
        largest = 0.0;
        for (FrictionDisc &disc : discs) {
            const Vec3 impulse = best(disc, radius, motion);
            const Vec3 change = impulse - disc.impulse;
            apply(disc.normal, change, radius, motion);
            disc.impulse = impulse;
            largest = std::max(largest, glm::length(change));
        }
        if (largest <= negligible) return true;
    }
    return false;
}

double residual(std::span<const FrictionDisc> discs, double radius, const Motion &motion) {
    double sum = 0.0;
    for (const FrictionDisc &disc : discs) {
        const Vec3 wrong = disc.impulse - best(disc, radius, motion);
        sum += glm::dot(wrong, wrong);
    }
    return sum;
}

/// A small dense linear system, solved by elimination with pivots.
class LinearSystem {
public:
    static constexpr size_t kMost = 3 * Contacts::kMost;

    explicit LinearSystem(size_t size)
        : m_size(size) {}

    double &at(size_t row, size_t column) { return m_rows[row][column]; }
    double &rightSide(size_t row) { return m_rows[row][m_size]; }

    /// The solution is in rightSide afterwards. False if there is none.
    bool solve() {
        for (size_t column = 0; column < m_size; ++column) {
            size_t pivot = column;
            for (size_t row = column + 1; row < m_size; ++row) {
                if (std::abs(at(row, column)) > std::abs(at(pivot, column))) pivot = row;
            }
            if (!(std::abs(at(pivot, column)) > kRounding)) return false;
            std::swap(m_rows[pivot], m_rows[column]);
            for (size_t row = 0; row < m_size; ++row) {
                if (row != column) eliminate(row, column);
            }
        }
        for (size_t row = 0; row < m_size; ++row) rightSide(row) /= at(row, row);
        return true;
    }

private:
    void eliminate(size_t row, size_t column) {
        const double factor = at(row, column) / at(column, column);
        for (size_t k = column; k <= m_size; ++k) m_rows[row][k] -= factor * m_rows[column][k];
    }

    size_t m_size;
    std::array<std::array<double, kMost + 1>, kMost> m_rows{};
};

/// Derivative of `clipped` at v.
glm::dmat3 clippingSlope(const Vec3 &v, double most) {
    const double size = glm::length(v);
    if (size <= most) return glm::dmat3(1.0);
    const Vec3 direction = v / size;
    return most / size * (glm::dmat3(1.0) - glm::outerProduct(direction, direction));
}

/// Change of the slip at one contact by an impulse of 1 at another.
glm::dmat3 slipSlope(const Vec3 &slipping, const Vec3 &pushed) {
    const glm::dmat3 across = glm::dmat3(1.0) - glm::outerProduct(slipping, slipping);
    const double cosine = glm::dot(slipping, pushed);
    return across * (glm::dmat3(1.0 + 2.5 * cosine) - 2.5 * glm::outerProduct(pushed, slipping));
}

/// A semismooth Newton step on `impulse = best(impulse)`; kept only if it comes nearer to that.
void newtonStep(std::span<FrictionDisc> discs, double radius, Motion &motion) {
    LinearSystem system(3 * discs.size());
    for (size_t i = 0; i < discs.size(); ++i) {
        const Vec3 target = discs[i].impulse - kSlipShare * slipAt(motion, discs[i].normal, radius);
        const glm::dmat3 slope = clippingSlope(target, discs[i].most);
        const Vec3 wrong = discs[i].impulse - clipped(target, discs[i].most);
        for (size_t j = 0; j < discs.size(); ++j) {
            glm::dmat3 block = kSlipShare * slope * slipSlope(discs[i].normal, discs[j].normal);
            if (i == j) block += glm::dmat3(1.0) - slope;
            // Along its normal an impulse stays 0.
            if (i == j) block += slope * glm::outerProduct(discs[i].normal, discs[i].normal);
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column < 3; ++column) system.at(3 * i + row, 3 * j + column) = block[column][row];
            }
        }
        for (int row = 0; row < 3; ++row) system.rightSide(3 * i + row) = -wrong[row];
    }
    if (!system.solve()) return;
    std::array<FrictionDisc, Contacts::kMost> next;
    Motion moved = motion;
    for (size_t i = 0; i < discs.size(); ++i) {
        next[i] = discs[i];
        Vec3 step{system.rightSide(3 * i), system.rightSide(3 * i + 1), system.rightSide(3 * i + 2)};
        step -= glm::dot(step, next[i].normal) * next[i].normal;
        next[i].impulse = clipped(discs[i].impulse + step, discs[i].most);
        apply(next[i].normal, next[i].impulse - discs[i].impulse, radius, moved);
    }
    const std::span<FrictionDisc> candidates(next.data(), discs.size());
    if (!(residual(candidates, radius, moved) < residual(discs, radius, motion))) return;
    std::copy(candidates.begin(), candidates.end(), discs.begin());
    motion = moved;
}

} // namespace

void minimiseSlipEnergy(std::span<FrictionDisc> discs, double radius, Motion &motion) {
    const double negligible = kRounding * (glm::length(motion.velocity) + radius * glm::length(motion.spin));
    if (discs.size() == 1) {
        apply(discs[0].normal, discs[0].impulse = best(discs[0], radius, motion), radius, motion);
        return;
    }
    for (int i = 0; i < kMostNewtonSteps && !sweep(discs, radius, negligible, motion); ++i) {
        newtonStep(discs, radius, motion);
    }
}

} // namespace phys
