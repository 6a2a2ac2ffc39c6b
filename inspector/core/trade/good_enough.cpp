// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/good_enough.h"

#include "core/trade/trade_answer.h"

#include <algorithm>

namespace inspector {

namespace {

constexpr int kBalls = 40; ///< gives the middle of a band to within a fifth
constexpr uint64_t kFirstSeed = 1000;

/// Indices of the eligible points, cheapest first.
std::vector<size_t> candidates(const TradePlan &plan, const TradeResult &result) {
    std::vector<size_t> order;
    for (size_t i = 0; i < result.points.size(); ++i) {
        const TradePoint &point = result.points[i];
        if (point.isValid && point.model == plan.inputs.params.model && point.cost.repeats > 0) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return result.points[a].cost.perSecond < result.points[b].cost.perSecond;
    });
    return order;
}

} // namespace

std::optional<double> errorOfSetting(const TradePlan &plan, const TradePoint &point, const TradeReference &reference,
                                     double until, const std::stop_token &stop) {
    QString note;
    const TradeError error = compareRun(runOf(plan, point), motionOf(reference, point.dt, until), stop, &note);
    return note.isEmpty() ? std::optional(error.positionLargest) : std::nullopt;
}

ValidationSchedules::ValidationSchedules(const TradePlan &plan, const std::stop_token &stop)
    : m_plan(plan)
    , m_stop(stop) {}

const ValidationSchedules::Validation &ValidationSchedules::prepared(int validation) {
    while (int(m_validations.size()) <= validation) {
        const TiltSchedule schedule = randomSchedule(kFirstSeed + m_validations.size(), m_plan.horizon);
        Validation next;
        next.reference =
            TradeReference::run(m_plan.registry, m_plan.scene, paramsFor(m_plan, m_plan.inputs.params.model),
                                segmentsOf(schedule, m_plan.inputs.gravity), nullptr);
        const BandPlan band{m_plan.registry, m_plan.scene, m_plan.inputs, m_plan.unknowns, kBalls, m_plan.horizon};
        if (next.reference) next.band = uncertaintyBand(band, *next.reference, m_stop).middleAt(m_plan.horizon);
        m_validations.push_back(std::move(next));
    }
    return m_validations[size_t(validation)];
}

std::optional<double> ValidationSchedules::shareOf(const TradePoint &point, int validation) {
    const Validation &with = prepared(validation);
    if (!with.reference || !(with.band > 0.0)) return 0.0;
    const std::optional<double> error = errorOfSetting(m_plan, point, *with.reference, m_plan.horizon, m_stop);
    return error ? std::optional(*error / with.band) : std::nullopt;
}

double shareOnSchedules(const TradePlan &plan, const TradeResult &result, const TradePoint &point) {
    double largest = 0.0;
    for (size_t i = 0; i < point.errors.size(); ++i) {
        const TradeSpan &span = result.spans[i][point.model];
        const double until = std::min(plan.horizon, span.compared);
        const double band = span.band.middleAt(until);
        if (band > 0.0) largest = std::max(largest, errorUntil(point.errors[i], until) / band);
    }
    return largest;
}

std::optional<GoodEnough> cheapestGoodEnough(const TradePlan &plan, const TradeResult &result,
                                             ValidationSchedules &validations) {
    std::vector<PassedOver> passedOver;
    for (const size_t index : candidates(plan, result)) {
        const TradePoint &point = result.points[index];
        double largest = shareOnSchedules(plan, result, point);
        if (largest >= plan.share) continue;
        bool isGood = true;
        for (int i = 0; isGood && i < validations.count(); ++i) {
            const std::optional<double> share = validations.shareOf(point, i);
            isGood = share && *share < plan.share;
            largest = std::max(largest, share.value_or(0.0));
            if (!isGood) passedOver.push_back({index, share});
        }
        if (isGood) return GoodEnough{index, largest, validations.count(), std::move(passedOver)};
    }
    return std::nullopt;
}

} // namespace inspector
