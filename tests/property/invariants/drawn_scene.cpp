// SPDX-License-Identifier: MIT
#include "drawn_scene.h"

#include <algorithm>
#include <utility>

namespace invariants {

using support::Random;
using support::SceneBuilder;

const std::array<Change, 6> kChanges{{
    {"mirrored in x", -1, 0, 0, 1, 1, 1},
    {"mirrored in y", 1, 0, 0, -1, 1, 1},
    {"x and y swapped", 0, 1, 1, 0, 1, 1},
    {"turned by a quarter", 0, -1, 1, 0, 1, 1},
    {"scaled by 4", 1, 0, 0, 1, 4, 2},
    {"gravity times 4", 1, 0, 0, 1, 1, 0.5},
}};

namespace {

constexpr double kWidth = 4.0;
constexpr int kCells = 8;

bool isClear(const SceneBuilder &scene, double x, double y) {
    const double reach = 1.5 * scene.radius();
    return std::none_of(scene.boxes().begin() + 1, scene.boxes().end(), [&](const phys_box &box) {
        return x > box.min.x - reach && x < box.max.x + reach && y > box.min.y - reach && y < box.max.y + reach;
    });
}

phys_vec3 turned(const phys_vec3 &v, const Change &c, double factor) {
    return {factor * (c.xx * v.x + c.xy * v.y), factor * (c.yx * v.x + c.yy * v.y), factor * v.z};
}

phys_box changed(const phys_box &box, const Change &change) {
    const phys_vec3 a = turned(box.min, change, change.length);
    const phys_vec3 b = turned(box.max, change, change.length);
    return {{std::min(a.x, b.x), std::min(a.y, b.y), a.z}, {std::max(a.x, b.x), std::max(a.y, b.y), b.z}};
}

/// The same ball and start with other boxes.
SceneBuilder withBoxes(const SceneBuilder &scene, const std::vector<phys_box> &boxes) {
    SceneBuilder other;
    other.ball(scene.radius()).start(scene.start());
    for (const phys_box &box : boxes) other.box(box);
    return other;
}

SceneBuilder drawScene(Random &random) {
    SceneBuilder scene;
    scene.ball(random.below(2) ? 0.03125 : 0.015625)
        .floor(-0.5, -0.5, kWidth + 0.5, kWidth + 0.5)
        .wall(-0.5, -0.5, kWidth + 0.5, 0.0)
        .wall(-0.5, kWidth, kWidth + 0.5, kWidth + 0.5)
        .wall(-0.5, 0.0, 0.0, kWidth)
        .wall(kWidth, 0.0, kWidth + 0.5, kWidth);
    const double cell = kWidth / kCells;
    for (int i = 0; i < kCells * kCells; ++i) {
        if (random.below(4) != 0) continue;
        const int column = i % kCells;
        const int row = i / kCells;
        const double x = cell * column;
        const double y = cell * row;
        scene.wall(x + random.between(0.0625, 0.1875), y + random.between(0.0625, 0.1875),
                   x + random.between(0.25, 0.4375), y + random.between(0.25, 0.4375));
    }
    double x = 0.0;
    double y = 0.0;
    do {
        x = random.between(0.0, kWidth);
        y = random.between(0.0, kWidth);
    } while (!isClear(scene, x, y));
    return scene.start(x, y);
}

} // namespace

Drawn draw(Random &random, uint32_t model) {
    Drawn drawn{drawScene(random), {}, {}, {}, 0x1p-7};
    phys_params_init(&drawn.params, sizeof drawn.params);
    drawn.params.model = model;
    drawn.params.restitution_wall = random.between(0.0, 1.0);
    drawn.params.rolling_friction = random.below(2) ? random.between(0.0, 0.0625) : 0.0;
    drawn.params.sliding_friction = random.between(0.0625, 0.5);
    drawn.params.wall_friction = random.below(2) ? random.between(0.0, 0.25) : 0.0;
    for (int i = 0; i < kSegments; ++i) {
        drawn.gravities.push_back({random.between(-2.0, 2.0), random.between(-2.0, 2.0), -random.between(8.0, 10.0)});
    }
    const double fastest = random.below(4) == 0 ? 16.0 : 1.0;
    drawn.start.position = drawn.scene.start();
    drawn.start.orientation[3] = 1.0;
    const double vx = random.between(-fastest, fastest);
    const double vy = random.between(-fastest, fastest);
    drawn.start.velocity = {vx, vy, 0.0};
    drawn.start.spin = {-vy / drawn.scene.radius(), vx / drawn.scene.radius(), 0.0};
    return drawn;
}

Drawn drawTiles(Random &random, uint32_t model) {
    Drawn drawn = draw(random, model);
    const double cell = kWidth / kCells;
    const auto start = random.below(kCells * kCells);
    std::vector<phys_box> boxes;
    for (uint32_t i = 0; i < kCells * kCells; ++i) {
        const double x = cell * (i % kCells);
        const double y = cell * static_cast<double>(i / kCells);
        const auto kind = random.below(8);
        if (kind == 0 && i != start) continue; // a hole
        boxes.push_back({{x, y, -cell}, {x + cell, y + cell, 0.0}});
        if (kind == 1 && i != start) boxes.push_back({{x, y, 0.0}, {x + cell, y + cell, cell}});
    }
    drawn.scene = withBoxes(drawn.scene, boxes);
    drawn.scene.start(cell * (start % kCells + 0.5), cell * (static_cast<double>(start / kCells) + 0.5));
    drawn.start.position = drawn.scene.start();
    return drawn;
}

Drawn changed(const Drawn &drawn, const Change &change) {
    std::vector<phys_box> boxes;
    for (const phys_box &box : drawn.scene.boxes()) boxes.push_back(changed(box, change));
    Drawn other = drawn;
    other.scene = SceneBuilder();
    other.scene.ball(change.length * drawn.scene.radius());
    for (const phys_box &box : boxes) other.scene.box(box);
    other.scene.start(turned(drawn.scene.start(), change, change.length));
    other.start = changed(drawn.start, change);
    const double acceleration = change.length / (change.time * change.time);
    for (phys_vec3 &gravity : other.gravities) gravity = turned(gravity, change, acceleration);
    other.dt = change.time * drawn.dt;
    return other;
}

phys_state changed(const phys_state &state, const Change &change) {
    phys_state other = state;
    other.time = change.time * state.time;
    other.position = turned(state.position, change, change.length);
    other.velocity = turned(state.velocity, change, change.length / change.time);
    // The spin is an axial vector: a reflection reverses it.
    const double hand = change.xx * change.yy - change.xy * change.yx;
    other.spin = turned(state.spin, change, hand / change.time);
    other.spin.z = hand / change.time * state.spin.z;
    return other;
}

Drawn cutIntoPieces(const Drawn &drawn, Random &random, int pieces) {
    Drawn other = drawn;
    std::vector<phys_box> boxes;
    for (const phys_box &box : drawn.scene.boxes()) {
        const bool alongX = random.below(2) == 0;
        const double low = alongX ? box.min.x : box.min.y;
        const double high = alongX ? box.max.x : box.max.y;
        double begin = low;
        for (int i = 1; i <= pieces; ++i) {
            const double end = i == pieces ? high : low + (high - low) * i / pieces;
            phys_box piece = box;
            (alongX ? piece.min.x : piece.min.y) = begin;
            (alongX ? piece.max.x : piece.max.y) = end;
            boxes.push_back(piece);
            begin = end;
        }
    }
    other.scene = withBoxes(drawn.scene, boxes);
    return other;
}

Drawn shuffled(const Drawn &drawn, Random &random) {
    std::vector<phys_box> boxes = drawn.scene.boxes();
    for (size_t i = boxes.size(); i > 1; --i) std::swap(boxes[i - 1], boxes[random.below(static_cast<uint32_t>(i))]);
    Drawn other = drawn;
    other.scene = withBoxes(drawn.scene, boxes);
    return other;
}

support::Experiment makeExperiment(const Drawn &drawn, const QByteArray &stepper) {
    support::Experiment ball(drawn.scene, stepper, drawn.params.model);
    ball.params = drawn.params;
    ball.state = drawn.start;
    return ball;
}

bool sameMotion(const phys_state &a, const phys_state &b) {
    const auto same = [](const phys_vec3 &p, const phys_vec3 &q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
    return a.time == b.time && a.step == b.step && a.flags == b.flags && same(a.position, b.position) &&
           same(a.velocity, b.velocity) && same(a.spin, b.spin);
}

} // namespace invariants
