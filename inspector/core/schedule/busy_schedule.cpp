// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/busy_schedule.h"

#include "core/schedule/trade_reference.h"

#include <algorithm>
#include <tuple>

namespace inspector {

namespace {

constexpr uint64_t kSeeds = 12;

} // namespace

TiltSchedule busySchedule(const Registry &registry, const Scene &scene, const Inputs &inputs, double duration,
                          double horizon, QString *error) {
    TiltSchedule busiest;
    std::tuple<double, int, int> most{-1.0, -1, -1};
    phys_params params = inputs.params;
    params.options &= ~uint32_t(PHYS_OPTION_ORIENTATION);
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
        TiltSchedule schedule = randomSchedule(seed, duration);
        const std::optional<TradeReference> reference =
            TradeReference::run(registry, scene, params, segmentsOf(schedule, inputs.gravity), error);
        if (!reference) continue;
        const std::tuple busyness{std::min(horizon, reference->end()), countedImpacts(reference->impacts(), horizon),
                                  countedImpacts(reference->impacts(), reference->end())};
        if (!(busyness > most)) continue;
        most = busyness;
        schedule.name = QStringLiteral("busy, random:%1").arg(seed);
        schedule.duration = reference->end();
        busiest = std::move(schedule);
    }
    return busiest;
}

} // namespace inspector
