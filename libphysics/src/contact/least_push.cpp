// SPDX-License-Identifier: MIT
#include "contact/least_push.h"

#include "base/subsets.h"
#include "contact/short_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace phys {

namespace {

constexpr int kMostPushSweeps = 4000;
constexpr double kRoundingOfSum = 4.0 * 0x1p-52; // of a sum, as a share of its terms

Vec3 sumOf(std::span<const Push> pushes) {
    Vec3 sum(0.0);
    for (const Push &push : pushes) sum += push.amount * push.normal;
    return sum;
}

double missingFrom(const Vec3 &sum, const Push &push) { return push.wanted - glm::dot(push.limit, sum); }

/// The largest violation by the amounts: too little along a limit, too much for a positive amount, or a pull. 0 or
/// less: they fit.
double misfit(std::span<const Push> pushes) {
    const Vec3 sum = sumOf(pushes);
    double worst = -INFINITY;
    for (const Push &push : pushes) {
        const double missing = missingFrom(sum, push);
        worst = std::max({worst, push.amount > 0.0 ? std::abs(missing) : missing, -push.amount});
    }
    return worst;
}

template<size_t Size>
using Few = std::array<const Push *, Size>;
template<size_t Size>
using Amounts = std::array<double, Size>;

/// The amounts with which these pushes alone give exactly what is wanted; nothing if their normals are dependent.
std::optional<Amounts<1>> amountsOf(const Few<1> &, const Amounts<1> &wanted) { return wanted; }

std::optional<Amounts<2>> amountsOf(const Few<2> &pushes, const Amounts<2> &wanted) {
    const auto [a, b] = pushes;
    // 1 - (a.limit . b.normal)(b.limit . a.normal) without cancellation
    const double determinant = glm::dot(glm::cross(a->limit, b->limit), glm::cross(a->normal, b->normal));
    if (determinant == 0.0) return {};
    return {{(wanted[0] - glm::dot(a->limit, b->normal) * wanted[1]) / determinant,
             (wanted[1] - glm::dot(b->limit, a->normal) * wanted[0]) / determinant}};
}

/// Three limits determine the sum; its components in the basis of the normals are the amounts.
std::optional<Amounts<3>> amountsOf(const Few<3> &pushes, const Amounts<3> &wanted) {
    const auto [a, b, c] = pushes;
    const Vec3 bc = glm::cross(b->normal, c->normal);
    const Vec3 ca = glm::cross(c->normal, a->normal);
    const Vec3 ab = glm::cross(a->normal, b->normal);
    const double volume = glm::dot(a->normal, bc);
    const double limitVolume = glm::dot(a->limit, glm::cross(b->limit, c->limit));
    if (volume == 0.0 || limitVolume == 0.0) return {};
    const Vec3 sum = (wanted[0] * glm::cross(b->limit, c->limit) + wanted[1] * glm::cross(c->limit, a->limit) +
                      wanted[2] * glm::cross(a->limit, b->limit)) /
                     limitVolume;
    return {{glm::dot(sum, bc) / volume, glm::dot(sum, ca) / volume, glm::dot(sum, ab) / volume}};
}

/// Tries subsets of positive amounts, of which it takes the one that fits with the least sum: more normals than
/// independent ones leave a choice, on which friction depends. Keeps the one with the smallest violation otherwise.
class Search {
public:
    Search(std::span<Push> pushes, double negligible, Work &work)
        : m_pushes(pushes)
        , m_negligible(negligible)
        , m_work(work) {}

    /// Whether the amounts of any subset fit: then the pushes have them.
    bool any() {
        if (std::none_of(m_pushes.begin(), m_pushes.end(), [](const Push &push) { return push.wanted > 0.0; })) {
            for (Push &push : m_pushes) push.amount = 0.0;
            return true;
        }
        if (any<1>()) return true;
        // Three that are dependent push no less than two of them.
        const bool areEnough = any<2>() && m_pushes.size() <= 3;
        return areEnough || any<3>();
    }

    double smallestMisfit() const { return m_smallestMisfit; }
    void takeBest() { set(m_best); }

private:
    template<size_t Size>
    bool any() {
        anySubset<Size>(static_cast<uint32_t>(m_pushes.size()), [&](const std::array<uint32_t, Size> &subset) {
            const bool fits = this->fits(subset);
            if (fits) consider();
            return fits && Size == 1; // no several ones push less
        });
        if (m_leastSum < INFINITY) set(m_least);
        return m_leastSum < INFINITY;
    }

    void set(const Amounts<kMostContacts> &amounts) {
        for (size_t i = 0; i < m_pushes.size(); ++i) m_pushes[i].amount = amounts[i];
    }
    void store(Amounts<kMostContacts> &amounts) const {
        for (size_t i = 0; i < m_pushes.size(); ++i) amounts[i] = m_pushes[i].amount;
    }

    void consider() {
        const double sum = sumOfAmounts();
        if (!(sum < m_leastSum - m_negligible)) return;
        m_leastSum = sum;
        store(m_least);
    }

    template<size_t Size>
    bool fits(const std::array<uint32_t, Size> &subset) {
        constexpr int kRounds = Size == 1 ? 1 : 3; // the later ones correct the rounding of the first
        m_work.add(Work::kPush * m_pushes.size());
        for (Push &push : m_pushes) push.amount = 0.0;
        Few<Size> chosen;
        for (size_t i = 0; i < Size; ++i) chosen[i] = &m_pushes[subset[i]];
        Vec3 sum(0.0);
        for (int round = 0; round < kRounds; ++round) {
            Amounts<Size> missing;
            for (size_t i = 0; i < Size; ++i) missing[i] = missingFrom(sum, *chosen[i]);
            const std::optional<Amounts<Size>> more = amountsOf(chosen, missing);
            if (!more) return false;
            sum = Vec3(0.0);
            for (size_t i = 0; i < Size; ++i) {
                Push &push = m_pushes[subset[i]];
                push.amount += (*more)[i];
                sum += push.amount * push.normal;
            }
        }
        const double missed = misfit(m_pushes);
        if (missed < m_smallestMisfit) {
            m_smallestMisfit = missed;
            store(m_best);
        }
        return missed <= m_negligible + kRoundingOfSum * sumOfAmounts();
    }

    double sumOfAmounts() const {
        double sum = 0.0;
        for (const Push &push : m_pushes) sum += push.amount;
        return sum;
    }

    std::span<Push> m_pushes;
    double m_negligible;
    Work &m_work;
    double m_leastSum = INFINITY, m_smallestMisfit = INFINITY;
    Amounts<kMostContacts> m_least, m_best;
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
            const double amount = std::max(0.0, push.amount + missingFrom(sum, push));
            sum += (amount - push.amount) * push.normal;
            largest = std::max(largest, std::abs(amount - push.amount));
            push.amount = amount;
        }
        if (largest <= negligible) return;
    }
}

/// Drops those that are rounding. Returns the sum.
Vec3 withoutPulls(std::span<Push> pushes) {
    for (Push &push : pushes) push.amount = std::max(0.0, push.amount);
    return sumOf(pushes);
}

} // namespace

Vec3 leastPush(std::span<Push> pushes, double negligible, Work &work) {
    Search search(pushes, negligible, work);
    if (!search.any()) {
        sweep(pushes, negligible, work);
        if (search.smallestMisfit() < misfit(pushes)) search.takeBest();
    }
    return withoutPulls(pushes);
}

std::optional<Vec3> leastPushOfFew(std::span<Push> pushes, double negligible, Work &work) {
    if (!Search(pushes, negligible, work).any()) return {};
    return withoutPulls(pushes);
}

} // namespace phys
