// SPDX-License-Identifier: MIT
#include "catalogue.h"
#include "expectations.h"
#include "watch.h"

#include "support/compare.h"
#include "support/effort.h"

#include <QByteArrayList>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <set>

namespace extremes {

using support::Experiment;
using support::SceneBuilder;

namespace {

/// Whether the ball is between the walls of a square room whose lower corner is (x, y).
bool isInRoom(const phys_state &state, double width, double x = 0.0, double y = 0.0) {
    return state.position.x > x && state.position.x < x + width && state.position.y > y && state.position.y < y + width;
}

Outcome stayInRoom(Experiment &ball, double width, uint64_t steps, double dt) {
    Watch watch(ball);
    watch.step(steps, dt);
    return outcome(watch, isInRoom(ball.state, width) ? "stays in the room" : "leaves the room");
}

/// On the floor of a square room of this width, clear of its walls.
void putAnywhere(Experiment &ball, support::Random &draw, double width) {
    ball.setPosition(draw.between(2.0 * kRadius, width - 2.0 * kRadius),
                     draw.between(2.0 * kRadius, width - 2.0 * kRadius));
}

void rollAnywhere(Experiment &ball, support::Random &draw, double speed) {
    const double angle = draw.between(0.0, 6.28);
    ball.roll(speed * std::cos(angle), speed * std::sin(angle));
}

bool hasSpeed(const Experiment &ball, const phys_vec3 &velocity) {
    return ball.state.velocity.x == velocity.x && ball.state.velocity.y == velocity.y;
}

Outcome keepSpeed(Experiment &ball, uint64_t steps, double dt) {
    const phys_vec3 given = ball.state.velocity;
    Watch watch(ball);
    watch.step(steps, dt);
    return outcome(watch, hasSpeed(ball, given) ? "keeps its speed to the last bit" : "changes its speed");
}

Outcome noResistance(const Trial &trial) {
    Experiment ball(support::openFloor(1e3), trial.stepper, trial.model);
    rollAnywhere(ball, trial.draw, trial.draw.between(0.0, 1.0));
    return keepSpeed(ball, support::effort(1000, 2000, 100'000), drawDt(trial.draw));
}

Outcome hugeResistance(const Trial &trial) {
    Experiment ball(support::openFloor(), trial.stepper, trial.model);
    ball.params.rolling_friction = ball.params.sliding_friction = 1e6;
    ball.params.gravity.x = trial.draw.between(-8.0, 8.0);
    rollAnywhere(ball, trial.draw, trial.draw.between(0.1, 2.0));
    Watch watch(ball);
    watch.step(1, drawDt(trial.draw));
    const bool rests = ball.state.flags & PHYS_AT_REST && hasSpeed(ball, {0.0, 0.0, 0.0});
    return outcome(watch, rests ? "stops in the first step" : "rolls on");
}

/// tilt: as a share of the limit, which setLaw makes exact.
Outcome stictionLimit(const Trial &trial, double tilt) {
    support::Random &draw = trial.draw;
    Experiment ball(support::openFloor(), trial.stepper, trial.model);
    const double limit = 5.0 / (4U << draw.below(8));
    const double pull = drawSign(draw) * tilt * limit;
    draw.below(2) ? ball.setLaw(pull, 0.0, limit) : ball.setLaw(0.0, pull, limit);
    const phys_vec3 given = ball.state.position;
    Watch watch(ball);
    watch.step(200, draw.between(0x1p-10, 0x1p-4));
    const bool isThere = ball.state.position.x == given.x && ball.state.position.y == given.y;
    return outcome(watch, isThere && ball.state.flags & PHYS_AT_REST ? "rests" : "starts");
}

Outcome tinySpeed(const Trial &trial) {
    Experiment ball(support::openFloor(), trial.stepper, trial.model);
    rollAnywhere(ball, trial.draw, 1e-300);
    return keepSpeed(ball, 500, drawDt(trial.draw));
}

Outcome tinySpeedWithResistance(const Trial &trial) {
    Experiment ball(support::openFloor(), trial.stepper, trial.model);
    ball.setLaw(0.0, 0.0, trial.draw.between(0.01, 1.0));
    rollAnywhere(ball, trial.draw, 1e-300);
    Watch watch(ball);
    watch.step(1, drawDt(trial.draw));
    return outcome(watch, ball.state.flags & PHYS_AT_REST ? "stops in the first step" : "rolls on");
}

Outcome hugeSpeedInACorridor(const Trial &trial) {
    auto scene = SceneBuilder().ball(0.006).floor(-1, -1, 1, 1).wall(-1, -1, 0, 1).wall(0.1, -1, 1, 1).start(0.05, 0.0);
    Experiment ball(scene, trial.stepper, trial.model);
    ball.params.restitution_wall = 1.0;
    ball.params.rolling_friction = ball.params.sliding_friction = 0.0;
    ball.setPosition(trial.draw.between(0.01, 0.09), trial.draw.between(-0.5, 0.5));
    ball.roll(drawSign(trial.draw) * 1e8, 0.0);
    Watch watch(ball);
    watch.step(1, 0.01);
    const bool inside = ball.state.position.x > 0.0 && ball.state.position.x < 0.1;
    return outcome(watch, inside ? "stays in the corridor" : "leaves the corridor");
}

Outcome hugeSpeedInTheOpen(const Trial &trial) {
    Experiment ball(support::openFloor(1e9), trial.stepper, trial.model);
    rollAnywhere(ball, trial.draw, 1e6);
    Watch watch(ball);
    watch.step(100, 0.01);
    const double way = std::hypot(ball.state.position.x, ball.state.position.y);
    return outcome(watch, std::abs(way - 1e6) <= 1e-7 ? "goes 1000 km in 1 s" : "is off its way");
}

Outcome fastInARoom(const Trial &trial) {
    Experiment ball(support::squareRoom(4.0), trial.stepper, trial.model);
    ball.params.restitution_wall = 1.0;
    ball.params.sliding_friction = 0.0;
    putAnywhere(ball, trial.draw, 4.0);
    rollAnywhere(ball, trial.draw, 1000.0);
    return stayInRoom(ball, 4.0, 200, trial.draw.between(0.0001, 0.001));
}

Outcome tinyRadius(const Trial &trial) {
    Experiment ball(support::squareRoom(1.0).ball(1e-8).start(0.5, 0.5), trial.stepper, trial.model);
    putAnywhere(ball, trial.draw, 1.0);
    rollAnywhere(ball, trial.draw, 1.0);
    return stayInRoom(ball, 1.0, 100, 0.01);
}

Outcome largeCoordinates(const Trial &trial) {
    support::Random &draw = trial.draw;
    const double at = 1e6;
    auto scene = SceneBuilder()
                     .ball(0.006)
                     .floor(at - 1, at - 1, at + 1, at + 1)
                     .wall(at - 1, at - 1, at, at + 1)
                     .wall(at + 0.25, at - 1, at + 1, at + 1)
                     .wall(at - 1, at - 1, at + 1, at)
                     .wall(at - 1, at + 0.25, at + 1, at + 1)
                     .start(at + 0.125, at + 0.125);
    Experiment ball(scene, trial.stepper, trial.model);
    ball.setPosition(at + draw.between(0.01, 0.24), at + draw.between(0.01, 0.24));
    ball.setLaw(draw.between(-1.0, 1.0), draw.between(-1.0, 1.0), 0x1p-7);
    rollAnywhere(ball, draw, draw.between(0.0, 1.0));
    const double dt = drawDt(draw);
    Watch watch(ball);
    watch.step(stepsFor(5.0, dt), dt);
    return outcome(watch, isInRoom(ball.state, 0.25, at, at) ? "stays in the room" : "leaves the room");
}

Outcome emptyStep(const Trial &trial) {
    Experiment ball(support::squareRoom(1.0), trial.stepper, trial.model);
    ball.setPosition(kRadius, trial.draw.below(2) ? kRadius : trial.draw.between(kRadius, 0.5));
    ball.roll(-trial.draw.between(0.0, 1.0), trial.draw.between(-1.0, 1.0));
    const phys_state before = ball.state;
    Watch watch(ball);
    watch.step(1, 0.0);
    return outcome(watch, support::sameBits(before, ball.state) ? "changes nothing" : "changes something");
}

Outcome tinyStep(const Trial &trial) {
    Experiment ball(support::openFloor(), trial.stepper, trial.model);
    const double pull = trial.draw.between(-1.0, 1.0);
    const double speed = trial.draw.between(-0.25, 0.25);
    const double start = trial.draw.between(1.0, 2.0);
    ball.setLaw(pull, 0.0);
    ball.setPosition(start, 0.0);
    ball.roll(speed, 0.0);
    const uint64_t steps = support::effort(1000, 10'000, 1'000'000);
    Watch watch(ball);
    watch.step(steps, 1e-9);
    const double t = static_cast<double>(steps) * 1e-9;
    const double way = speed * t + 0.5 * pull * t * t;
    // Each step's displacement is rounded to the last digit of the position: half an ulp of 2 against 0.25e-9, model.md
    // 10.6.
    const double slack = static_cast<double>(steps) * 0x1p-52 + std::abs(pull) * t * 1e-9;
    const bool right = std::abs(ball.state.position.x - start - way) <= slack;
    return outcome(watch, right ? "moves as it should" : "loses its way");
}

Outcome longStep(const Trial &trial) {
    support::Random &draw = trial.draw;
    Experiment ball(support::squareRoom(4.0), trial.stepper, trial.model);
    ball.setLaw(draw.between(-0.5, 0.5), draw.between(-0.5, 0.5), 0x1p-7);
    putAnywhere(ball, draw, 4.0);
    ball.roll(draw.between(-1.0, 1.0), draw.between(-1.0, 1.0));
    return stayInRoom(ball, 4.0, 200, 1.0);
}

Outcome flippingGravity(const Trial &trial) {
    support::Random &draw = trial.draw;
    Experiment ball(support::squareRoom(1.0), trial.stepper, trial.model);
    putAnywhere(ball, draw, 1.0);
    const double dt = drawDt(draw);
    Watch watch(ball);
    for (uint64_t i = 0; i < support::effort(200, 500, 5000); ++i) {
        ball.setLaw(draw.between(-2.0, 2.0), draw.between(-2.0, 2.0), 0x1p-7);
        if (!watch.step(1, dt)) break;
    }
    return outcome(watch, isInRoom(ball.state, 1.0) ? "stays in the room" : "leaves the room");
}

Outcome hugeGravity(const Trial &trial) {
    support::Random &draw = trial.draw;
    Experiment ball(support::squareRoom(4.0), trial.stepper, trial.model);
    putAnywhere(ball, draw, 4.0);
    ball.params.gravity = {draw.between(-1e6, 1e6), draw.between(-1e6, 1e6), -1e6};
    return stayInRoom(ball, 4.0, 200, draw.between(1e-5, 2e-4));
}

Outcome steepBoard(const Trial &trial) {
    support::Random &draw = trial.draw;
    Experiment ball(support::squareRoom(4.0), trial.stepper, trial.model);
    ball.params.gravity = {draw.between(-9.8, 9.8), draw.between(-9.8, 9.8), -1e-6};
    putAnywhere(ball, draw, 4.0);
    return stayInRoom(ball, 4.0, 1000, draw.between(0.001, 0.01));
}

Outcome hugeSpin(const Trial &trial) {
    support::Random &draw = trial.draw;
    Experiment ball(support::squareRoom(4.0), trial.stepper, trial.model);
    putAnywhere(ball, draw, 4.0);
    ball.state.spin = {drawSign(draw) * 1e6, draw.between(-3e6, 3e6), draw.between(-3e6, 3e6)};
    const double dt = draw.between(0x1p-8, 0x1p-6);
    const int steps = support::promiseOf(trial.stepper).inSteps ? 2 : 100; // of tens of thousands of substeps each
    return stayInRoom(ball, 4.0, steps, dt);
}

Outcome longRest(const Trial &trial) {
    Experiment ball(support::openFloor(), trial.stepper, trial.model);
    ball.setLaw(trial.draw.between(-0.25, 0.25), trial.draw.between(-0.25, 0.25), 0.375);
    const double dt = drawDt(trial.draw);
    Watch watch(ball);
    watch.step(1, dt);
    phys_state first = ball.state;
    watch.step(support::effort(2000, 10'000, 1'000'000), dt);
    first.time = ball.state.time;
    first.step = ball.state.step;
    return outcome(watch, support::sameBits(first, ball.state) ? "rests to the last bit" : "creeps");
}

} // namespace

std::vector<Extreme> scaleExtremes() {
    const auto stiction = [](double tilt) { return [tilt](const Trial &trial) { return stictionLimit(trial, tilt); }; };
    const Expected inTheRoom = always("stays in the room");
    // Friction turns spin into speed: thousands of m/s, between walls.
    const Expected spinning = [](const QByteArray &stepper, uint32_t model) -> QByteArray {
        const bool mayBeRefused = model == PHYS_MODEL_RIGID && stepper == "swept";
        return mayBeRefused ? "PHYS_ERROR_EVENT_CAP or stays in the room" : "stays in the room";
    };
    return {
        {"no resistance on the level", noResistance, always("keeps its speed to the last bit")},
        {"resistance a million times the weight", hugeResistance, always("stops in the first step")},
        {"a slope exactly at the stiction limit", stiction(1.0), always("rests")},
        {"a slope 1e-9 above the stiction limit", stiction(1.0 + 1e-9), always("starts")},
        {"a long rest", longRest, always("rests to the last bit")},
        {"1e-300 m/s", tinySpeed, always("keeps its speed to the last bit")},
        {"1e-300 m/s with resistance", tinySpeedWithResistance, always("stops in the first step")},
        {"1000 m/s in a room of 4 m, 1 ms", fastInARoom, inTheRoom},
        {"1e6 m/s in the open, 10 ms", hugeSpeedInTheOpen, always("goes 1000 km in 1 s")},
        {"1e8 m/s in a corridor of 0.1 m, 10 ms", hugeSpeedInACorridor,
         bySubsteps("PHYS_ERROR_SUBSTEP_CAP", "PHYS_ERROR_EVENT_CAP"), 10},
        {"a radius of 1e-8 m at 1 m/s, 10 ms", tinyRadius, bySubsteps("PHYS_ERROR_SUBSTEP_CAP", "stays in the room")},
        {"a room at coordinates of 1e6 m", largeCoordinates, inTheRoom},
        {"dt = 0", emptyStep, always("changes nothing")},
        {"dt = 1e-9 s", tinyStep, always("moves as it should")},
        {"dt = 1 s", longStep, inTheRoom},
        {"gravity turned in each step", flippingGravity, inTheRoom},
        {"gravity of 1e6 m/s^2", hugeGravity, inTheRoom},
        {"a board that stands on its edge", steepBoard, inTheRoom},
        {"a spin of 1e6 rad/s", hugeSpin, spinning},
    };
}

Outcome overDraws(const Extreme &extreme, const QByteArray &stepper, uint32_t model) {
    support::Random draw(support::testSeed());
    const Trial trial{stepper, model, draw};
    std::set<QByteArray> seen;
    for (uint64_t i = 0; i < support::effort(10, 25, 1000) / extreme.cost; ++i) {
        Outcome outcome = extreme.run(trial);
        if (!outcome.problem.isEmpty()) return outcome;
        seen.insert(outcome.text);
    }
    return {QByteArrayList(seen.begin(), seen.end()).join(kOr), {}};
}

bool isExpected(const QByteArray &text, const QByteArray &expected) {
    const QStringList may = QString(expected).split(kOr);
    const QStringList seen = QString(text).split(kOr);
    return std::all_of(seen.begin(), seen.end(), [&](const QString &one) { return may.contains(one); });
}

std::vector<Extreme> allExtremes() {
    std::vector<Extreme> all = contactExtremes();
    for (Extreme &extreme : scaleExtremes()) all.push_back(std::move(extreme));
    return all;
}

} // namespace extremes
