// SPDX-License-Identifier: MIT
#include "contact/least_push.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace phys {

namespace {

constexpr int kMostPushSweeps = 4000;

Vec3 sumOf(std::span<const Push> pushes) {
    Vec3 sum(0.0);
    for (const Push &push : pushes) sum += push.amount * push.normal;
    return sum;
}

/// By how much the amounts miss: a push gives less than is wanted, or would have to pull. 0 or less: they fit.
double misfit(std::span<const Push> pushes) {
    const Vec3 sum = sumOf(pushes);
    double worst = -INFINITY;
    for (const Push &push : pushes) {
        worst = std::max({worst, push.wanted - glm::dot(push.normal, sum), -push.amount});
    }
    return worst;
}

/// Subsets of pushes with their amounts are tried until one fits; until then the one that misses least is kept.
class Search {
public:
    Search(std::span<Push> pushes, double negligible, Work &work)
        : m_pushes(pushes)
        , m_negligible(negligible)
        , m_work(work) {}

    bool one() {
        return std::any_of(m_pushes.begin(), m_pushes.end(), [&](Push &a) { return fits({{&a, a.wanted}}); });
    }

    bool two() {
        for (size_t i = 0; i < m_pushes.size(); ++i) {
            for (size_t j = i + 1; j < m_pushes.size(); ++j) {
                if (fitsTwo(m_pushes[i], m_pushes[j])) return true;
            }
        }
        return false;
    }

    bool three() {
        for (size_t i = 0; i < m_pushes.size(); ++i) {
            for (size_t j = i + 1; j < m_pushes.size(); ++j) {
                for (size_t k = j + 1; k < m_pushes.size(); ++k) {
                    if (fitsThree(m_pushes[i], m_pushes[j], m_pushes[k])) return true;
                }
            }
        }
        return false;
    }

    double least() const { return m_least; }
    void takeBest() {
        for (Push &push : m_pushes) push.amount = 0.0;
        for (size_t i = 0; i < m_bestCount; ++i) m_best[i].first->amount = m_best[i].second;
    }

private:
    using Amount = std::pair<Push *, double>;

    bool fits(std::initializer_list<Amount> amounts) {
        m_work.add(Work::kPush * m_pushes.size());
        for (Push &push : m_pushes) push.amount = 0.0;
        for (const auto &[push, amount] : amounts) push->amount = amount;
        const double missed = misfit(m_pushes);
        if (missed < m_least) {
            m_least = missed;
            m_bestCount = amounts.size();
            std::copy(amounts.begin(), amounts.end(), m_best.begin());
        }
        return missed <= m_negligible;
    }

    bool fitsTwo(Push &a, Push &b) {
        const double cosine = glm::dot(a.normal, b.normal);
        const Vec3 axis = glm::cross(a.normal, b.normal);
        const double determinant = glm::dot(axis, axis); // 1 - cosine^2 without cancellation
        if (determinant == 0.0) return false;
        return fits(
            {{&a, (a.wanted - cosine * b.wanted) / determinant}, {&b, (b.wanted - cosine * a.wanted) / determinant}});
    }

    /// Three independent normals determine the sum; its shares along them are the amounts.
    bool fitsThree(Push &a, Push &b, Push &c) {
        const Vec3 bc = glm::cross(b.normal, c.normal);
        const Vec3 ca = glm::cross(c.normal, a.normal);
        const Vec3 ab = glm::cross(a.normal, b.normal);
        const double volume = glm::dot(a.normal, bc);
        if (volume == 0.0) return false;
        const Vec3 sum = (a.wanted * bc + b.wanted * ca + c.wanted * ab) / volume;
        return fits(
            {{&a, glm::dot(sum, bc) / volume}, {&b, glm::dot(sum, ca) / volume}, {&c, glm::dot(sum, ab) / volume}});
    }

    std::span<Push> m_pushes;
    double m_negligible;
    Work &m_work;
    double m_least = INFINITY;
    std::array<Amount, 3> m_best{};
    size_t m_bestCount = 0;
};

/// For nearly parallel or opposite normals, where rounding keeps every subset from fitting.
void sweep(std::span<Push> pushes, double negligible, Work &work) {
    for (Push &push : pushes) push.amount = 0.0;
    Vec3 sum(0.0);
    for (int i = 0; i < kMostPushSweeps && !work.isTooMuch(); ++i) {
        work.add(Work::kPush * pushes.size());
        double largest = 0.0;
        for (Push &push : pushes) {
            const double amount = std::max(0.0, push.amount + push.wanted - glm::dot(push.normal, sum));
            sum += (amount - push.amount) * push.normal;
            largest = std::max(largest, std::abs(amount - push.amount));
            push.amount = amount;
        }
        if (largest <= negligible) return;
    }
}

} // namespace

Vec3 leastPush(std::span<Push> pushes, double negligible, Work &work) {
    Search search(pushes, negligible, work);
    if (!search.one() && !search.two() && !search.three()) {
        sweep(pushes, negligible, work);
        if (search.least() < misfit(pushes)) search.takeBest();
    }
    for (Push &push : pushes) push.amount = std::max(0.0, push.amount);
    return sumOf(pushes);
}

} // namespace phys
