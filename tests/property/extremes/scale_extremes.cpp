// SPDX-License-Identifier: MIT
#include "catalogue.h"
#include "expectations.h"
#include "watch.h"

#include "support/compare.h"
#include "support/effort.h"

#include <cmath>

namespace extremes {

using support::Experiment;
using support::SceneBuilder;

namespace {

/// Whether the ball is between the walls of a square room with its lower corner at (x, y).
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

Outcome noResistance(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::openFloor(1e3), stepper, model);
    ball.roll(0.3, -0.7);
    Watch watch(ball);
    watch.step(support::effort(10'000, 100'000, 1'000'000), 0.001);
    const bool kept = ball.state.velocity.x == 0.3 && ball.state.velocity.y == -0.7;
    return outcome(watch, kept ? "keeps its speed to the last bit" : "changes its speed");
}

Outcome hugeResistance(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::openFloor(), stepper, model);
    ball.params.rolling_friction = ball.params.sliding_friction = 1e6;
    ball.params.gravity.x = 2.0;
    ball.roll(1.0, -1.0);
    Watch watch(ball);
    watch.step(1, kDt);
    const bool rests = ball.state.flags & PHYS_AT_REST && ball.state.velocity.x == 0.0 && ball.state.velocity.y == 0.0;
    return outcome(watch, rests ? "stops in the first step" : "rolls on");
}

Outcome stictionLimit(const QByteArray &stepper, uint32_t model, double tilt) {
    return overDraws([&](support::Random &draw) {
        Experiment ball(support::openFloor(), stepper, model);
        ball.setLaw(0.3125 * tilt, 0.0, 0.3125);
        Watch watch(ball);
        watch.step(200, draw.between(0x1p-10, 0x1p-4));
        return outcome(watch, ball.state.position.x == 0.0 && ball.state.flags & PHYS_AT_REST ? "rests" : "starts");
    });
}

Outcome tinySpeed(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::openFloor(), stepper, model);
    ball.roll(1e-300, 0.0);
    Watch watch(ball);
    watch.step(1000, kDt);
    return outcome(watch, ball.state.velocity.x == 1e-300 ? "keeps its speed to the last bit" : "changes its speed");
}

Outcome tinySpeedWithResistance(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::openFloor(), stepper, model);
    ball.setLaw(0.0, 0.0, 0.125);
    ball.roll(1e-300, 1e-300);
    Watch watch(ball);
    watch.step(1, kDt);
    return outcome(watch, ball.state.flags & PHYS_AT_REST ? "stops in the first step" : "rolls on");
}

Outcome hugeSpeedInACorridor(const QByteArray &stepper, uint32_t model) {
    auto scene = SceneBuilder().ball(0.006).floor(-1, -1, 1, 1).wall(-1, -1, 0, 1).wall(0.1, -1, 1, 1).start(0.05, 0.0);
    Experiment ball(scene, stepper, model);
    ball.params.restitution_wall = 1.0;
    ball.params.rolling_friction = ball.params.sliding_friction = 0.0;
    ball.roll(1e6, 0.0);
    Watch watch(ball);
    watch.step(1, 0.01);
    const bool inside = ball.state.position.x > 0.0 && ball.state.position.x < 0.1;
    return outcome(watch, inside ? "stays in the corridor" : "leaves the corridor");
}

Outcome hugeSpeedInTheOpen(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::openFloor(1e9), stepper, model);
    ball.roll(1e6, 0.0);
    Watch watch(ball);
    watch.step(100, 0.01);
    return outcome(watch, ball.state.position.x == 1e6 ? "goes 1000 km in 1 s" : "is off its way");
}

Outcome fastInARoom(const QByteArray &stepper, uint32_t model) {
    return overDraws([&](support::Random &draw) {
        Experiment ball(support::squareRoom(4.0), stepper, model);
        ball.params.restitution_wall = 1.0;
        ball.params.sliding_friction = 0.0;
        const double angle = draw.between(0.0, 6.28);
        putAnywhere(ball, draw, 4.0);
        ball.roll(1000.0 * std::cos(angle), 1000.0 * std::sin(angle));
        return stayInRoom(ball, 4.0, 200, draw.between(0.0001, 0.001));
    });
}

Outcome tinyRadius(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::squareRoom(1.0).ball(1e-8).start(0.5, 0.5), stepper, model);
    ball.roll(1.0, 0.0);
    return stayInRoom(ball, 1.0, 100, 0.01);
}

Outcome largeCoordinates(const QByteArray &stepper, uint32_t model) {
    const double at = 1e6;
    auto scene = SceneBuilder()
                     .ball(0.006)
                     .floor(at - 1, at - 1, at + 1, at + 1)
                     .wall(at - 1, at - 1, at, at + 1)
                     .wall(at + 0.25, at - 1, at + 1, at + 1)
                     .wall(at - 1, at - 1, at + 1, at)
                     .wall(at - 1, at + 0.25, at + 1, at + 1)
                     .start(at + 0.125, at + 0.125);
    Experiment ball(scene, stepper, model);
    ball.setLaw(0.25, -0.125, 0x1p-7);
    ball.roll(0.5, 0.25);
    Watch watch(ball);
    watch.step(1000, 0.005);
    return outcome(watch, isInRoom(ball.state, 0.25, at, at) ? "stays in the room" : "leaves the room");
}

Outcome emptyStep(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::squareRoom(1.0), stepper, model);
    ball.setPosition(kRadius, kRadius);
    ball.roll(-1.0, -1.0);
    const phys_state before = ball.state;
    Watch watch(ball);
    watch.step(1, 0.0);
    return outcome(watch, support::sameBits(before, ball.state) ? "changes nothing" : "changes something");
}

Outcome tinyStep(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::openFloor(), stepper, model);
    ball.setLaw(0.5, 0.0);
    ball.setPosition(2.0, 0.0);
    ball.roll(0.125, 0.0);
    const uint64_t steps = support::effort(10'000, 1'000'000, 10'000'000);
    Watch watch(ball);
    watch.step(steps, 1e-9);
    const double t = static_cast<double>(steps) * 1e-9;
    const double way = 0.125 * t + 0.25 * t * t;
    // Each step's way is rounded to a place's last digit: half an ulp of 2 against 0.125e-9, model.md 10.6.
    const double slack = static_cast<double>(steps) * 0x1p-52 + 0.5 * t * 1e-9;
    const bool right = std::abs(ball.state.position.x - 2.0 - way) <= slack;
    return outcome(watch, right ? "moves as it should" : "loses its way");
}

Outcome longStep(const QByteArray &stepper, uint32_t model) {
    return overDraws([&](support::Random &draw) {
        Experiment ball(support::squareRoom(4.0), stepper, model);
        ball.setLaw(draw.between(-0.5, 0.5), draw.between(-0.5, 0.5), 0x1p-7);
        putAnywhere(ball, draw, 4.0);
        ball.roll(draw.between(-1.0, 1.0), draw.between(-1.0, 1.0));
        return stayInRoom(ball, 4.0, 200, 1.0);
    });
}

Outcome flippingGravity(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::squareRoom(1.0).start(kRadius, 0.5), stepper, model);
    Watch watch(ball);
    for (int i = 0; i < 4096; ++i) {
        ball.setLaw(i % 2 ? 1.25 : -1.25, i % 3 ? 0.625 : -1.25, 0x1p-7);
        if (!watch.step(1, kDt)) break;
    }
    return outcome(watch, isInRoom(ball.state, 1.0) ? "stays in the room" : "leaves the room");
}

Outcome hugeGravity(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::squareRoom(4.0), stepper, model);
    ball.params.gravity = {1e6, -0.5e6, -1e6};
    return stayInRoom(ball, 4.0, 1000, 1e-4);
}

Outcome steepBoard(const QByteArray &stepper, uint32_t model) {
    return overDraws([&](support::Random &draw) {
        Experiment ball(support::squareRoom(4.0), stepper, model);
        ball.params.gravity = {draw.between(-9.8, 9.8), draw.between(-9.8, 9.8), -1e-6};
        putAnywhere(ball, draw, 4.0);
        return stayInRoom(ball, 4.0, 1000, draw.between(0.001, 0.01));
    });
}

Outcome hugeSpin(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::squareRoom(4.0), stepper, model);
    ball.state.spin = {1e6, -2e6, 3e6};
    const int steps = support::promiseOf(stepper).inSteps ? 10 : 1000; // of tens of thousands of substeps each
    return stayInRoom(ball, 4.0, steps, kDt);
}

Outcome longRest(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::openFloor(), stepper, model);
    ball.setLaw(0.25, 0.125, 0.3125);
    Watch watch(ball);
    watch.step(1, 0.01);
    phys_state first = ball.state;
    watch.step(support::effort(50'000, 1'000'000, 10'000'000), 0.01);
    first.time = ball.state.time;
    first.step = ball.state.step;
    return outcome(watch, support::sameBits(first, ball.state) ? "rests to the last bit" : "creeps");
}

} // namespace

std::vector<Extreme> scaleExtremes() {
    const auto stiction = [](double tilt) {
        return [tilt](const QByteArray &stepper, uint32_t model) { return stictionLimit(stepper, model, tilt); };
    };
    const Expected inTheRoom = always("stays in the room");
    // Friction turns spin into speed: thousands of m/s, between walls.
    const Expected spinning = [](const QByteArray &stepper, uint32_t model) -> QByteArray {
        const bool isRefused = model == PHYS_MODEL_RIGID && stepper == "swept";
        return isRefused ? "PHYS_ERROR_EVENT_CAP" : "stays in the room";
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
        {"1e6 m/s in a corridor of 0.1 m, 10 ms", hugeSpeedInACorridor,
         bySubsteps("PHYS_ERROR_SUBSTEP_CAP", "PHYS_ERROR_EVENT_CAP")},
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

std::vector<Extreme> allExtremes() {
    std::vector<Extreme> all = contactExtremes();
    for (Extreme &extreme : scaleExtremes()) all.push_back(std::move(extreme));
    return all;
}

} // namespace extremes
