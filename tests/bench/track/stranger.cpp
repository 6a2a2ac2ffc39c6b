// SPDX-License-Identifier: MIT
// Fits the ball of another engine: the engine rolls it through a level, and it is sampled as by a camera. Prints the
// fit.
#include "core/track/fit_report.h"
#include "inspector/track/made_track.h"
#include "peers/engine.h"

#include <QCoreApplication>
#include <QTextStream>

using namespace inspector;

namespace {

constexpr double kRate = 60.0; // pictures a second
constexpr double kStep = 1.0 / 600.0;
constexpr double kDuration = 10.0;
constexpr double kNoise = 1e-4; // m
constexpr uint64_t kSeed = 3;

// The level's boxes that stand above the floor, seen from above.
bench::Scene sceneOf(const Scene &level) {
    bench::Scene scene;
    scene.radius = phys_scene_radius(level.get());
    phys_state start;
    phys_scene_start(level.get(), &start);
    scene.start.position = {start.position.x, start.position.y};
    scene.rolls = true;
    const phys_box *boxes = phys_scene_boxes(level.get());
    for (uint32_t i = 0; i < phys_scene_box_count(level.get()); ++i)
        if (boxes[i].max.z > start.position.z)
            scene.walls.push_back({boxes[i].min.x, boxes[i].min.y, boxes[i].max.x, boxes[i].max.y});
    return scene;
}

Track roll(bench::Engine &engine, const bench::Scene &scene) {
    Track track;
    support::Normal normal(kSeed);
    for (const TiltSwitch &change : randomSchedule(kSeed, kDuration).switches)
        track.tilts.push_back({change.time, change.tilt});
    engine.place(scene.start);
    size_t next = 0;
    for (int i = 0; i <= int(kDuration * kRate); ++i) {
        const bench::Ball ball = engine.ball();
        track.points.push_back({i / kRate, ball.position.x + kNoise * normal(), ball.position.y + kNoise * normal()});
        for (; next < track.tilts.size() && track.tilts[next].time < (i + 0.5) / kRate; ++next) {
            phys_vec3 gravity;
            phys_gravity_from_tilt(track.tilts[next].tilt.x, track.tilts[next].tilt.y, 9.81, &gravity);
            engine.setGravity(gravity);
        }
        engine.advance(kStep, int(std::lround(1.0 / kRate / kStep)));
    }
    return track;
}

} // namespace

// Usage: bench_stranger ENGINE MAZE.txt
int main(int argc, char **argv) {
    const QCoreApplication application(argc, argv);
    QTextStream out(stdout);
    QString error;
    const QStringList words = QCoreApplication::arguments();
    const Scene level = words.size() == 3 ? loadScene(words[2], &error) : nullptr;
    if (!level) {
        QTextStream(stderr) << "usage: bench_stranger ENGINE MAZE.txt " << error << '\n';
        return 2;
    }
    for (const bench::EngineKind &kind : bench::allEngines()) {
        if (words[1] != QString::fromStdString(kind.name)) continue;
        const bench::Scene scene = sceneOf(level);
        FitPlan plan{makeRegistry(&error),
                     level,
                     roll(*kind.make(scene, kStep), scene),
                     {initialInputs().params, 9.81, {}, 0.0, {}},
                     {},
                     {}};
        plan.track.name = words[1];
        plan.quantities = *parseFitQuantities(QStringLiteral("rolling_friction,restitution_wall,tilt,delay"), &error);
        const std::optional<TrackFit> fit = fitTrack(plan, {}, {}, &error);
        out << (fit ? fitReport(plan, *fit).join(QLatin1Char('\n')) : error) << '\n';
        return fit ? 0 : 1;
    }
    QTextStream(stderr) << "bench_stranger: no engine '" << words[1] << "'\n";
    return 2;
}
