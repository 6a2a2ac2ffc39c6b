// SPDX-License-Identifier: MIT
// A track as a camera would see it, of a ball on a board whose parameters are known.
#pragma once

#include "core/schedule/trade_schedule.h"
#include "core/setup/tables.h"
#include "core/track/ball_model.h"

#include <cmath>
#include <random>

namespace support {

struct MadeTrack {
    inspector::Track track;
    inspector::BoardParameters truth;
};

struct Recipe {
    double duration = 20.0; // s
    double rate = 60.0;     // pictures a second
    double noise = 1e-4;    // m
    uint64_t seed = 1;
};

// Numbers with the normal distribution, the same everywhere (Box and Muller).
class Normal {
public:
    explicit Normal(uint64_t seed)
        : m_numbers(seed) {}
    double uniform() { return (double(m_numbers() >> 11) + 0.5) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    double operator()() {
        const double radius = std::sqrt(-2.0 * std::log(uniform()));
        return radius * std::cos(6.283185307179586 * uniform());
    }

private:
    std::mt19937_64 m_numbers;
};

// Random tilts from the scene's start; ends early where the ball leaves the maze. Empty if "exact" refuses.
inline inspector::Track makeTrack(const inspector::Registry &registry, const inspector::Scene &scene,
                                  const inspector::BoardParameters &truth, const Recipe &recipe) {
    using namespace inspector;
    Track ideal;
    ideal.name = "made";
    const auto count = size_t(recipe.duration * recipe.rate);
    for (size_t i = 0; i <= count; ++i) ideal.points.push_back({double(i) / recipe.rate, 0.0, 0.0});
    for (const TiltSwitch &change : randomSchedule(recipe.seed, recipe.duration).switches)
        ideal.tilts.push_back({change.time, change.tilt});
    phys_state start;
    phys_scene_start(scene.get(), &start);
    phys_box bounds;
    phys_scene_bounds(scene.get(), &bounds);
    std::vector<TrackPoint> seen;
    const BallModel model(registry, scene, ideal, nullptr);
    model.run(truth, {start.position.x, start.position.y, 0.0, 0.0}, 0, count, seen);
    Track track = ideal;
    track.points.clear();
    Normal normal(recipe.seed ^ 0x9e3779b97f4a7c15U);
    for (const TrackPoint &point : seen) {
        double x = 0.0;
        double y = 0.0;
        truth.frame.toBoard(point.x, point.y, x, y);
        if (x < bounds.min.x || x > bounds.max.x || y < bounds.min.y || y > bounds.max.y) break;
        track.points.push_back({point.time, point.x + recipe.noise * normal(), point.y + recipe.noise * normal()});
    }
    return track;
}

// In the format of a camera's program: one row per picture, with the tilt of that moment.
inline QByteArray csvOf(const inspector::Track &track) {
    QByteArray csv = "t,x,y,tilt_x,tilt_y\n";
    size_t tilt = 0;
    for (const inspector::TrackPoint &point : track.points) {
        while (tilt + 1 < track.tilts.size() && track.tilts[tilt + 1].time <= point.time + 1e-9) ++tilt;
        const inspector::Tilt &now = track.tilts[tilt].tilt;
        for (const double number : {point.time, point.x, point.y, inspector::degrees(now.x), inspector::degrees(now.y)})
            csv += inspector::exactText(number) + ',';
        csv.back() = '\n';
    }
    return csv;
}

// A board with parameters drawn from the range of hand-built ones; offset and delay of the tilt are unknown.
inline inspector::BoardParameters drawTruth(uint32_t model, uint64_t seed) {
    using namespace inspector;
    Normal normal(seed * 7919U + 17U);
    BoardParameters truth{initialInputs().params, 9.81, {}, 0.0, {}};
    truth.params.model = model;
    truth.params.rolling_friction = normal.uniform(0.001, 0.01);
    truth.params.restitution_wall = normal.uniform(0.3, 0.7);
    truth.params.sliding_friction = normal.uniform(0.15, 0.4);
    truth.tiltOffset = {radians(normal.uniform(-1.0, 1.0)), radians(normal.uniform(-1.0, 1.0))};
    truth.delay = normal.uniform(0.0, 0.15);
    return truth;
}

} // namespace support
