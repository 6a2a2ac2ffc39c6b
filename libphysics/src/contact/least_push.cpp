// SPDX-License-Identifier: MIT
#include "contact/least_push.h"

#include "contact/short_list.h"

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

/// The largest violation by the amounts: too little along a normal, too much for a positive amount, or a pull. 0 or
/// less: they fit.
double misfit(std::span<const Push> pushes) {
    const Vec3 sum = sumOf(pushes);
    double worst = -INFINITY;
    for (const Push &push : pushes) {
        const double missing = push.wanted - glm::dot(push.normal, sum);
        worst = std::max({worst, push.amount > 0.0 ? std::abs(missing) : missing, -push.amount});
    }
    return worst;
}

/// Tries subsets of positive amounts, of which it takes the one that fits with the least sum: more normals than
/// independent ones leave a choice, on which friction depends. Keeps the one with the smallest violation otherwise.
class Search {
public:
    Search(std::span<Push> pushes, double negligible, Work &work)
        : m_pushes(pushes)
        , m_negligible(negligible)
        , m_work(work) {}

    bool one() {
        return std::any_of(m_pushes.begin(), m_pushes.end(), [&](Push &a) { return fits<1>({&a}, {a.wanted}); });
    }

    bool two() {
        Fitting fitting;
        for (size_t i = 0; i < m_pushes.size(); ++i) {
            for (size_t j = i + 1; j < m_pushes.size(); ++j) {
                if (fitsTwo(m_pushes[i], m_pushes[j])) consider(fitting);
            }
        }
        return take(fitting);
    }

    bool three() {
        Fitting fitting;
        for (size_t i = 0; i < m_pushes.size(); ++i) {
            for (size_t j = i + 1; j < m_pushes.size(); ++j) {
                for (size_t k = j + 1; k < m_pushes.size(); ++k) {
                    if (fitsThree(m_pushes[i], m_pushes[j], m_pushes[k])) consider(fitting);
                }
            }
        }
        return take(fitting);
    }

    double least() const { return m_least; }
    void takeBest() {
        for (Push &push : m_pushes) push.amount = 0.0;
        for (size_t i = 0; i < m_bestCount; ++i) m_best[i]->amount = m_bestAmounts[i];
    }

private:
    /// The amounts of least sum so far.
    struct Fitting {
        double sum = INFINITY;
        std::array<double, kMostContacts> amounts;
    };
    void consider(Fitting &fitting) const {
        double sum = 0.0;
        for (const Push &push : m_pushes) sum += push.amount;
        if (!(sum < fitting.sum - m_negligible)) return;
        fitting.sum = sum;
        for (size_t i = 0; i < m_pushes.size(); ++i) fitting.amounts[i] = m_pushes[i].amount;
    }
    bool take(const Fitting &fitting) {
        if (fitting.sum == INFINITY) return false;
        for (size_t i = 0; i < m_pushes.size(); ++i) m_pushes[i].amount = fitting.amounts[i];
        return true;
    }

    template<size_t Count>
    bool fits(const std::array<Push *, Count> &pushes, const std::array<double, Count> &amounts) {
        m_work.add(Work::kPush * m_pushes.size());
        for (Push &push : m_pushes) push.amount = 0.0;
        for (size_t i = 0; i < Count; ++i) pushes[i]->amount = amounts[i];
        const double missed = misfit(m_pushes);
        if (missed < m_least) {
            m_least = missed;
            m_bestCount = Count;
            std::copy(pushes.begin(), pushes.end(), m_best.begin());
            std::copy(amounts.begin(), amounts.end(), m_bestAmounts.begin());
        }
        return missed <= m_negligible;
    }

    /// amountsFor(wanted): the amounts of a subset. Its residual is corrected where rounding keeps the amounts from
    /// fitting.
    template<size_t Count, class AmountsFor>
    bool fitsCorrected(const std::array<Push *, Count> &pushes, AmountsFor amountsFor) {
        constexpr int kMostCorrections = 3;
        std::array<double, Count> wanted, amounts{};
        for (size_t i = 0; i < Count; ++i) wanted[i] = pushes[i]->wanted;
        for (int correction = 0; correction <= kMostCorrections; ++correction) {
            const std::array<double, Count> more = amountsFor(wanted);
            Vec3 sum(0.0);
            for (size_t i = 0; i < Count; ++i) sum += (amounts[i] += more[i]) * pushes[i]->normal;
            if (fits(pushes, amounts)) return true;
            if (std::any_of(amounts.begin(), amounts.end(), [&](double amount) { return amount < -m_negligible; }))
                break;
            for (size_t i = 0; i < Count; ++i) wanted[i] = pushes[i]->wanted - glm::dot(pushes[i]->normal, sum);
        }
        return false;
    }

    bool fitsTwo(Push &a, Push &b) {
        const double cosine = glm::dot(a.normal, b.normal);
        const Vec3 axis = glm::cross(a.normal, b.normal);
        const double determinant = glm::dot(axis, axis); // 1 - cosine^2 without cancellation
        if (determinant == 0.0) return false;
        return fitsCorrected<2>({&a, &b}, [&](const std::array<double, 2> &wanted) {
            return std::array{(wanted[0] - cosine * wanted[1]) / determinant,
                              (wanted[1] - cosine * wanted[0]) / determinant};
        });
    }

    /// Three independent normals determine the sum; its components in their basis are the amounts.
    bool fitsThree(Push &a, Push &b, Push &c) {
        const Vec3 bc = glm::cross(b.normal, c.normal);
        const Vec3 ca = glm::cross(c.normal, a.normal);
        const Vec3 ab = glm::cross(a.normal, b.normal);
        const double volume = glm::dot(a.normal, bc);
        if (volume == 0.0) return false;
        return fitsCorrected<3>({&a, &b, &c}, [&](const std::array<double, 3> &wanted) {
            const Vec3 sum = (wanted[0] * bc + wanted[1] * ca + wanted[2] * ab) / volume;
            return std::array{glm::dot(sum, bc) / volume, glm::dot(sum, ca) / volume, glm::dot(sum, ab) / volume};
        });
    }

    std::span<Push> m_pushes;
    double m_negligible;
    Work &m_work;
    double m_least = INFINITY;
    std::array<Push *, 3> m_best{};
    std::array<double, 3> m_bestAmounts{};
    size_t m_bestCount = 0;
};

/// For nearly parallel or opposite normals, where no subset fits because of rounding. Ends where the amounts grow
/// without limit, or converge too slowly.
void sweep(std::span<Push> pushes, double negligible, Work &work) {
    for (Push &push : pushes) push.amount = 0.0;
    Vec3 sum(0.0);
    constexpr int kRound = 64;
    constexpr double kTooSlow = 0.99; // in a round
    double largest = INFINITY, lastRound = INFINITY;
    for (int i = 0; i < kMostPushSweeps && !work.isTooMuch(); ++i) {
        if (i % kRound == 0 && largest > kTooSlow * std::exchange(lastRound, largest)) return;
        work.add(Work::kPush * pushes.size());
        largest = 0.0;
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
