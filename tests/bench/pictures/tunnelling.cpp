// SPDX-License-Identifier: MIT
#include "chart/chart.h"
#include "peers/engine.h"
#include "pictures/pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

namespace bench {

namespace {

constexpr double kRadius = 0.005;                   // m
constexpr int kCells = 48;                          // along each axis
constexpr int kPhases = 24;                         // places of the wall inside one step
constexpr double kStepLow = 1e-3, kStepHigh = 0.1;  // s
constexpr double kSpeedLow = 0.05, kSpeedHigh = 50; // m/s

// From good to bad; the worst outcome of any phase is taken.
enum Outcome { RightSide, Refused, WrongSide, Missed };

Scene thinWallScene(double thickness) {
    Scene scene;
    scene.radius = kRadius;
    scene.walls = {{0, -1, thickness, 1}};
    scene.start = {{-1, 0}, {}};
    scene.restitution = 1;
    scene.gravity = steadyTilt(0, 0);
    return scene;
}

Outcome outcomeOf(Engine &engine, double speed, double dt, double phase) {
    constexpr int kSteps = 8;
    const double stepLength = speed * dt;
    const double start = -kRadius - stepLength * (1 + phase);
    engine.place({{start, 0}, {speed, 0}});
    try {
        engine.advance(dt, kSteps);
    } catch (const std::exception &) {
        return Refused;
    }
    const Ball ball = engine.ball();
    if (ball.position.x < 0) return RightSide;
    const double unhindered = start + kSteps * stepLength;
    return std::abs(ball.position.x - unhindered) < 1e-9 * stepLength ? Missed : WrongSide;
}

Outcome worstOutcome(Engine &engine, double speed, double dt) {
    Outcome worst = RightSide;
    for (int phase = 0; phase < kPhases; ++phase)
        worst = std::max(worst, outcomeOf(engine, speed, dt, (phase + 0.5) / kPhases));
    return worst;
}

double geometric(double low, double high, double share) { return low * std::pow(high / low, share); }

// Where speed * dt = length, from border to border.
Curve borderAt(const std::string &title, double length) {
    Curve border{title, Look::Predicted, {}, false};
    for (int cell = 0; cell <= kCells; ++cell) {
        const double dt = geometric(kStepLow, kStepHigh, static_cast<double>(cell) / kCells);
        const double speed = length / dt;
        if (speed >= kSpeedLow && speed <= kSpeedHigh) border.points.push_back({dt * 1e3, speed});
    }
    return border;
}

Chart mapOf(const EngineKind &kind, const std::string &variant, double thickness, bool isCareless) {
    Chart chart;
    char title[100];
    std::snprintf(title, sizeof title, "%s%s; wall %g R thick", kind.name.c_str(), variant.c_str(),
                  thickness / kRadius);
    chart.title = title;
    chart.x = {"step (ms)", true, kStepLow * 1e3, kStepHigh * 1e3};
    chart.y = {"speed (m/s)", true, kSpeedLow, kSpeedHigh};
    chart.map.classes = {"right side", "refused with a status", "wrong side", "missed"};
    chart.map.colours = {"#c7e9c0", "#fff7bc", "#fdae6b", "#cb181d"};
    const Scene scene = thinWallScene(thickness);
    const auto engine = kind.make(scene, kStepLow);
    engine->setGravity(scene.gravity.front());
    for (int column = 0; column < kCells; ++column)
        for (int row = 0; row < kCells; ++row) {
            const double dt = geometric(kStepLow, kStepHigh, (column + 0.5) / kCells);
            const double speed = geometric(kSpeedLow, kSpeedHigh, (row + 0.5) / kCells);
            const auto share = [](int cell) { return static_cast<double>(cell) / kCells; };
            chart.map.cells.push_back(
                {1e3 * geometric(kStepLow, kStepHigh, share(column)), geometric(kSpeedLow, kSpeedHigh, share(row)),
                 1e3 * geometric(kStepLow, kStepHigh, share(column + 1)),
                 geometric(kSpeedLow, kSpeedHigh, share(row + 1)), worstOutcome(*engine, speed, dt)});
        }
    if (isCareless)
        chart.curves = {borderAt("v dt = R + h/2 and h + 2R", kRadius + thickness / 2),
                        borderAt("", thickness + 2 * kRadius)};
    return chart;
}

} // namespace

// The borders are those of model.md 10.4 for a step that ignores the speed, as in most games; ours are below.
bool drawTunnelling(const std::filesystem::path &folder) {
    std::vector<Chart> panels;
    for (const EngineKind &kind : ourEngines({{"as_reported", 1}}))
        if (kind.name == PHYS_STEPPER_DEFAULT)
            for (const double thickness : {0.5, 1.0, 2.0})
                panels.push_back(mapOf(kind, " without substeps", thickness * kRadius, true));
    for (const EngineKind &kind : ourEngines())
        for (const char *name : {PHYS_STEPPER_DEFAULT, "swept", "exact"})
            if (kind.name == name) panels.push_back(mapOf(kind, "", kRadius, false));
    for (std::size_t panel = 1; panel < panels.size(); ++panel) panels[panel].hasLegend = false;
    return drawCharts(panels, 3, folder / "tunnelling");
}

} // namespace bench
