// SPDX-License-Identifier: MIT
#include "chart/chart.h"
#include "peers/engine.h"
#include "pictures/pictures.h"

namespace bench {

namespace {

constexpr double kStep = 0.01;   // s
constexpr double kDuration = 20; // s
constexpr int kStepsPerSample = 5;
constexpr double kTilt = 0.05; // rad, towards the wall

// A wall at x = 0 against which the tilt presses the ball, which starts `gap` away from it.
Scene wallScene(double gap, double restitution) {
    Scene scene;
    scene.walls = {{-0.2, -2, 0, 2}};
    scene.start = {{scene.radius + gap, 0}, {}};
    scene.restitution = restitution;
    scene.gravity = steadyTilt(-kTilt, 0);
    return scene;
}

// Energy above that of a ball at rest against the wall; per mass, J/kg.
double energyOf(const Scene &scene, const Ball &ball) {
    const double height = ball.position.x - scene.radius;
    return (ball.velocity.x * ball.velocity.x + ball.velocity.y * ball.velocity.y) / 2 -
           scene.gravity.front().x * height;
}

Curve energyCurve(const std::string &title, Look look, const EngineKind &kind, const Scene &scene, double unit) {
    Curve curve{title, look, {}, false};
    const auto engine = kind.make(scene, kStep);
    engine->place(scene.start);
    engine->setGravity(scene.gravity.front());
    for (int sample = 0; sample * kStepsPerSample * kStep < kDuration; ++sample) {
        curve.points.push_back({sample * kStepsPerSample * kStep, energyOf(scene, engine->ball()) / unit});
        engine->advance(kStep, kStepsPerSample);
    }
    return curve;
}

// Full lines: as they are. Dashed: without the cures of model.md 10.3.
Chart energyChart(const std::string &title, const Scene &scene, double unit, const std::string &unitText) {
    Chart chart;
    chart.title = title;
    chart.x = {"time (s)"};
    chart.y = {"energy (" + unitText + ")"};
    for (const EngineKind &kind : ourEngines({{"as_reported", 1}}))
        chart.curves.push_back(energyCurve(kind.name + ", uncured", Look::Peer, kind, scene, unit));
    for (const EngineKind &kind : ourEngines())
        chart.curves.push_back(energyCurve(kind.name, Look::Ours, kind, scene, unit));
    return chart;
}

} // namespace

bool drawEnergy(const std::filesystem::path &folder) {
    const Scene elastic = wallScene(0.1, 1);
    const double startEnergy = energyOf(elastic, elastic.start);
    const Scene resting = wallScene(0, 0.8);
    const Scene restingElastic = wallScene(0, 1);
    const double perStep = resting.gravity.front().x * kStep;
    const double stepEnergy = perStep * perStep / 2; // energy of the speed that one step of falling gives
    std::vector<Chart> panels{
        energyChart("bounces, restitution 1, step 10 ms", elastic, startEnergy, "of the energy at the start"),
        energyChart("rests, restitution 0.8, step 10 ms", resting, stepEnergy, "of one step's fall"),
        energyChart("rests, restitution 1, step 10 ms", restingElastic, stepEnergy, "of one step's fall")};
    panels[1].hasLegend = panels[2].hasLegend = false;
    return drawCharts(panels, 3, folder / "energy");
}

} // namespace bench
