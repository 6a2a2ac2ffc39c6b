// SPDX-License-Identifier: MIT
#include "chart/chart.h"
#include "peers/engine.h"
#include "pictures/pictures.h"
#include "reference/event_driven.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bench {

namespace {

constexpr double kRoundingError = 1e-12; // m: smaller errors are rounding and have no meaningful slope
constexpr int kFewestSteps = 16;
constexpr int kHalvings = 10;
const std::vector<Setting> kResistance{{"rolling_friction", 0.005}};

// The slope of the line through log(error) over log(step), by least squares.
double slopeOf(const std::vector<ChartPoint> &points) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const ChartPoint &point : points) {
        if (point.y < kRoundingError) continue;
        const double x = std::log(point.x);
        const double y = std::log(point.y);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return n < 2 ? 0 : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::string titleOf(const std::string &name, const std::vector<ChartPoint> &points) {
    const double slope = slopeOf(points);
    if (slope == 0) return name + ", rounding";
    char text[80];
    std::snprintf(text, sizeof text, "%s, slope %.2f", name.c_str(), slope);
    return text;
}

// Mean error over scenes that last one tilt period each, at halved steps.
template<class ErrorOf>
Chart convergenceChart(const std::string &title, const std::vector<EngineKind> &kinds, double duration,
                       ErrorOf errorOf) {
    Chart chart;
    chart.title = title;
    chart.x = {"step (s)", true};
    chart.y = {"position error (m)", true};
    for (const EngineKind &kind : kinds) {
        Curve curve{"", Look::Ours, {}, true};
        for (int halving = 0; halving < kHalvings; ++halving) {
            const double dt = duration / (kFewestSteps << halving);
            curve.points.push_back({dt, std::max(errorOf(kind, dt), 1e-17)});
        }
        curve.title = titleOf(kind.name, curve.points);
        chart.curves.push_back(std::move(curve));
    }
    return chart;
}

// Rolling with resistance across the tilt: A = (-0.6, 0.2), B = 0.1, v = (1, 0.3) m/s; the position after 2 s was
// computed with 50 digits (model.md 12.1).
Chart smoothChart() {
    constexpr double kShare = 7.0 / 5.0; // a rolling ball has 5/7 of what acts
    Scene scene;
    scene.rolls = true;
    scene.start = {{0, 0}, {1, 0.3}};
    scene.tiltPeriod = scene.duration = 2;
    scene.gravity = {{-0.6 * kShare, 0.2 * kShare, -kStrength}};
    const Vec2 end{0.66173608811146707468, 0.87942790288305788119};
    const auto kinds = ourEngines({{"rolling_friction", 0.1 * kShare / kStrength}});
    return convergenceChart("smooth: rolling with resistance, 2 s", kinds, scene.duration,
                            [=](const EngineKind &kind, double dt) {
                                const auto engine = kind.make(scene, dt);
                                run(*engine, scene, dt);
                                return distance(engine->ball().position, end);
                            });
}

// The time of an impact within a step is effectively random, so that only a mean over many starts has a slope.
std::vector<Scene> impactScenes() {
    constexpr int kStarts = 32;
    std::vector<Scene> scenes;
    for (int start = 0; start < kStarts; ++start) {
        Scene scene;
        scene.walls = {{-1, -1, 0, 3}};
        scene.start = {{0.6 + 0.01 * start / kStarts, 0}, {-0.7, 0.2}};
        scene.restitution = 0.8;
        scene.tiltPeriod = scene.duration = 2;
        scene.gravity = steadyTilt(-0.04, 0.01);
        scenes.push_back(scene);
    }
    return scenes;
}

double meanError(const EngineKind &kind, double dt, const std::vector<Scene> &scenes, const std::vector<Ball> &ends) {
    double sum = 0;
    for (std::size_t index = 0; index < scenes.size(); ++index) {
        const auto engine = kind.make(scenes[index], dt);
        run(*engine, scenes[index], dt);
        sum += distance(engine->ball().position, ends[index].position);
    }
    return sum / static_cast<double>(scenes.size());
}

// Rolling with resistance, which isn't a parabola, so that the order shows; compared with the stepper that is exact for
// any step.
Chart resistanceChart(const EngineKind &exact) {

    std::vector<Scene> scenes = impactScenes();
    std::vector<Ball> ends;
    ends.reserve(scenes.size());
    for (Scene &scene : scenes) {
        scene.rolls = true;
        const auto engine = exact.make(scene, scene.duration);
        run(*engine, scene, scene.duration);
        ends.push_back(engine->ball());
    }
    return convergenceChart("across impacts, with resistance", ourEngines(kResistance), scenes.front().duration,
                            [&](const EngineKind &kind, double dt) { return meanError(kind, dt, scenes, ends); });
}

Chart impactChart() {
    const std::vector<Scene> scenes = impactScenes();
    std::vector<Ball> ends;
    ends.reserve(scenes.size());
    for (const Scene &scene : scenes) ends.push_back(eventDriven<long double>(scene).balls.back());
    return convergenceChart("across impacts: mean of 32 starts, 2 s", ourEngines(), scenes.front().duration,
                            [&](const EngineKind &kind, double dt) { return meanError(kind, dt, scenes, ends); });
}

} // namespace

bool drawConvergence(const std::filesystem::path &folder) {
    // The slopes differ, so each plot needs a legend and hence a picture of its own.
    bool drawn = drawCharts({smoothChart()}, 1, folder / "convergence_smooth");
    drawn = drawCharts({impactChart()}, 1, folder / "convergence_impacts") && drawn;
    for (const EngineKind &kind : ourEngines(kResistance))
        if (kind.exactInDt) drawn = drawCharts({resistanceChart(kind)}, 1, folder / "convergence_resistance") && drawn;
    return drawn;
}

} // namespace bench
