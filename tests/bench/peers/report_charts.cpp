// SPDX-License-Identifier: MIT
#include "chart/chart.h"
#include "peers/front.h"
#include "peers/report.h"

#include <algorithm>

namespace bench {

namespace {

// An error of exactly zero has no logarithm; it is drawn here.
constexpr double kLeastError = 1e-17; // radii

ChartPoint pointOf(const Trial &trial) {
    return {trial.secondsPerSimulated * 1e6, std::max(trial.medianLargest(), kLeastError)};
}

Chart chartOf(const SceneGroup &group, const std::vector<Trial> &trials) {
    Chart chart;
    chart.title = group.name + ": " + group.question;
    chart.x = {"CPU time per simulated second (µs)", true};
    chart.y = {"largest position error (ball radii)", true};
    Curve front{"cheapest for its error", Look::Front, {}, false};
    for (const Trial *trial : paretoFront(trials, group.name)) front.points.push_back(pointOf(*trial));
    chart.curves.push_back(front);
    for (const Trial *trial : trialsOf(trials, group.name)) {
        auto curve = std::find_if(chart.curves.begin(), chart.curves.end(),
                                  [&](const Curve &c) { return c.title == trial->engine; });
        if (curve == chart.curves.end())
            curve = chart.curves.insert(curve, {trial->engine, trial->ours ? Look::Ours : Look::Peer, {}, true});
        if (!trial->answered()) continue;
        curve->points.push_back(pointOf(*trial));
        if (trial->dt == group.scenes.front().tiltPeriod)
            chart.labels.push_back({curve->points.back().x, curve->points.back().y, "one call per tilt"});
    }
    // Ordered by cost: the largest step is measured last.
    for (Curve &curve : chart.curves)
        std::sort(curve.points.begin(), curve.points.end(),
                  [](const ChartPoint &a, const ChartPoint &b) { return a.x < b.x; });
    return chart;
}

} // namespace

bool writeCharts(const std::vector<SceneGroup> &groups, const std::vector<Trial> &trials,
                 const std::filesystem::path &folder) {
    bool drawn = true;
    std::vector<Chart> small;
    for (const SceneGroup &group : groups) {
        const Chart chart = chartOf(group, trials);
        std::string name = group.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        if (name.starts_with("maze"))
            drawn = drawCharts({chart}, 1, folder / name) && drawn;
        else
            small.push_back(chart);
    }
    // The legend is the same for all panels.
    for (std::size_t panel = 1; panel < small.size(); ++panel) small[panel].hasLegend = false;
    return (small.empty() || drawCharts(small, 2, folder / "scenes")) && drawn;
}

} // namespace bench
