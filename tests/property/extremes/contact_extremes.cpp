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

SceneBuilder leftWall() { return support::openFloor(10.0).wall(-5, -10, 0, 10).start(kRadius, 0.0); }

/// No friction anywhere: a rigid ball keeps its spin and loses nothing to slip.
void makeSmooth(Experiment &ball) {
    ball.params.rolling_friction = 0.0;
    ball.params.sliding_friction = 0.0;
}

/// Whether the ball's centre is at this place in the plane, within the library's contact tolerance.
bool isAt(const Experiment &ball, double x, double y) {
    const double slack = roundingDepth(ball.scene(), ball.state);
    return std::abs(ball.state.position.x - x) <= slack && std::abs(ball.state.position.y - y) <= slack;
}

/// `grown` or `shrunk` if the value changed by at least this share, otherwise `kept`.
QByteArray change(double share, double before, double after, const char *grown, const char *shrunk, const char *kept) {
    return after > (1.0 + share) * before ? grown : after < (1.0 - share) * before ? shrunk : kept;
}

double energyOf(const Experiment &ball) {
    double energy = 0.0;
    phys_energy(ball.scene(), &ball.params, &ball.state, &energy);
    return energy;
}

/// Stopped by a wall after an oblique approach. pull: the strongest acceleration into the wall, m/s^2.
Outcome restitutionZero(const Trial &trial, double pull) {
    support::Random &draw = trial.draw;
    Experiment ball(leftWall(), trial.stepper, trial.model);
    const double side = drawSign(draw);
    ball.setLaw(-draw.between(0.5, 1.0) * pull, side * draw.between(0.0, 0.5) * pull);
    ball.params.restitution_wall = 0.0;
    ball.setPosition(draw.between(0.1, 0.5), draw.between(-1.0, 1.0));
    const double speed = draw.between(0.1, 1.0);
    ball.roll(-speed, side * draw.between(0.1, 1.0));
    const double dt = drawDt(draw);
    Watch watch(ball);
    watch.step(stepsFor(0.5 / speed + 0.5, dt), dt);
    const bool slides = ball.state.velocity.x == 0.0 && side * ball.state.velocity.y > 0.0;
    if (!slides) return outcome(watch, "leaves the wall");
    const bool isAtWall = isAt(ball, kRadius, ball.state.position.y);
    return outcome(watch, isAtWall ? "slides on along the wall" : "stops before the wall");
}

Outcome elasticCorridor(const Trial &trial) {
    const double speed = trial.draw.between(0.5, 4.0);
    const double dt = drawDt(trial.draw);
    const double room = trial.draw.between(0.5, 1.0) * speed * dt; // one or two bounces in each step
    auto scene = support::openFloor(1.0).wall(-1, -1, 0, 1).wall(room + 2.0 * kRadius, -1, 1, 1).start(kRadius, 0.0);
    Experiment ball(scene, trial.stepper, trial.model);
    makeSmooth(ball);
    ball.params.restitution_wall = 1.0;
    ball.roll(speed, 0.0);
    const uint64_t steps = support::effort(1000, 10'000, 100'000);
    const double before = energyOf(ball);
    Watch watch(ball);
    watch.step(steps, dt);
    // A rigid ball's velocity is recomposed from sevenths in each step: one or two roundings per bounce.
    const double slack = support::rounding(16.0 * static_cast<double>(steps), before);
    return outcome(watch, std::abs(energyOf(ball) - before) <= slack ? "keeps its energy" : "changes its energy");
}

Outcome elasticOnASlope(const Trial &trial) {
    Experiment ball(leftWall(), trial.stepper, trial.model);
    makeSmooth(ball);
    const double pull = trial.draw.between(0.25, 1.0);
    const double speed = trial.draw.between(0.25, 0.75);
    const double dt = trial.draw.between(0x1p-9, 0x1p-6);
    ball.setLaw(-pull, 0.0);
    ball.params.restitution_wall = 1.0;
    ball.roll(speed, 0.0);
    const double rest =
        -ball.params.gravity.x * kRadius - ball.params.gravity.z * kRadius; // energy in the wall's contact
    const double spin = 0.2 * speed * speed;                                // of a smooth rigid ball: it never changes
    const double fixed = rest + (trial.model == PHYS_MODEL_RIGID ? spin : 0.0);
    const double before = energyOf(ball) - fixed;
    Watch watch(ball);
    watch.step(stepsFor(20.0 * 2.0 * speed / pull, dt), dt); // twenty bounces
    return outcome(watch,
                   change(1e-3, before, energyOf(ball) - fixed, "gains energy", "loses energy", "keeps its energy"));
}

/// width: of the gap, in diameters.
Outcome narrowGap(const Trial &trial, double least, double most) {
    support::Random &draw = trial.draw;
    const double width = draw.between(least, most) * 2.0 * kRadius;
    auto scene = support::openFloor(4.0).wall(-4, -0.5, -width / 2, 0).wall(width / 2, -0.5, 4, 0);
    Experiment ball(scene, trial.stepper, trial.model);
    ball.params.restitution_wall = draw.between(0.0, 0.5);
    const double pull = draw.between(0.25, 1.0);
    const double there = std::sqrt(kRadius * kRadius - 0.25 * width * width); // from which it is too slow to climb out
    ball.setPosition(0.0, there + draw.between(0.0, 1.0) * (kRadius - there));
    ball.setLaw(draw.between(-0.25, 0.25) * pull, -pull, draw.between(0.0, 0x1p-5));
    const double dt = drawDt(draw);
    const bool isUndecided = least == most; // some steps in it take all the passes that there may be
    Watch watch(ball);
    watch.step(stepsFor(isUndecided ? 1.0 : 5.0, dt), dt);
    if (isUndecided) return outcome(watch, "undefined, but finite");
    if (ball.state.position.y <= 0.0) return outcome(watch, "passes");
    return outcome(watch, ball.state.flags & PHYS_AT_REST ? "rests in its mouth" : "hops in its mouth");
}

Outcome manyBoxes(const Trial &trial, bool duplicates) {
    support::Random &draw = trial.draw;
    auto one = support::openFloor(8.0).wall(-1, -8, 0, 8);
    auto many = support::openFloor(8.0);
    double end = -8.0;
    for (int i = 0; i < 1000; ++i) {
        const double begin = end;
        end = i == 999 ? 8.0 : -8.0 + 0.016 * (i + draw.between(0.1, 1.0));
        if (duplicates)
            many.wall(-1, -8, 0, 8);
        else
            many.wall(-1, begin, 0, end);
    }
    Experiment a(one, trial.stepper, trial.model);
    Experiment b(many, trial.stepper, trial.model);
    const phys_vec3 place{draw.between(kRadius, 0.5), draw.between(-4.0, 4.0), 0.0};
    const phys_vec3 velocity{draw.between(-1.0, 0.0), draw.between(-1.0, 1.0), 0.0};
    const phys_vec3 pull{draw.between(-1.0, -0.25), draw.between(-0.5, 0.5), 0.0};
    for (Experiment *ball : {&a, &b}) {
        ball->setPosition(place.x, place.y);
        ball->setLaw(pull.x, pull.y);
        ball->roll(velocity.x, velocity.y);
    }
    const double dt = drawDt(draw);
    Watch watchA(a);
    Watch watchB(b);
    bool same = true;
    for (int i = 0; i < 256 && same; ++i) {
        if (!watchA.step(1, dt) || !watchB.step(1, dt)) break;
        same = support::sameBits(a.state, b.state);
    }
    return outcome(watchB, same ? "as one box, to the last bit" : "not as one box");
}

/// The centre's distance from the face, in radii, > 0 outside: least .. most.
Outcome startInside(const Trial &trial, double least, double most) {
    support::Random &draw = trial.draw;
    Experiment ball(leftWall(), trial.stepper, trial.model);
    ball.setPosition(draw.between(least, most) * kRadius, draw.between(-5.0, 5.0));
    const double dt = drawDt(draw);
    ball.step(dt);
    const double slack = roundingDepth(ball.scene(), ball.state);
    const bool out = depthOf(ball.scene(), ball.state) <= slack;
    Watch watch(ball);
    watch.step(16, dt);
    return outcome(watch, out && ball.state.position.x >= kRadius - slack ? "is pushed out" : "stays inside");
}

Outcome startWedged(const Trial &trial) {
    const double width = trial.draw.between(0.5, 1.9) * kRadius;
    auto scene = support::openFloor(1.0).wall(-1, -1, 0, 1).wall(width, -1, 1, 1);
    Experiment ball(scene, trial.stepper, trial.model);
    ball.setPosition(trial.draw.between(0.0, 1.0) * width, trial.draw.between(-0.5, 0.5));
    Watch watch(ball);
    watch.step(1, drawDt(trial.draw));
    return outcome(watch, "is pushed out");
}

Outcome startInACorner(const Trial &trial) {
    Experiment ball(support::squareRoom(1.0).start(kRadius, kRadius), trial.stepper, trial.model);
    ball.setLaw(trial.draw.between(-1.0, -0.01), trial.draw.between(-1.0, -0.01));
    Watch watch(ball);
    watch.step(512, drawDt(trial.draw));
    const bool rests = isAt(ball, kRadius, kRadius) && ball.state.flags & PHYS_AT_REST;
    return outcome(watch, rests ? "rests there" : "hops there");
}

/// Comes from one direction and passes the corner (0, 0) at up to 0.99 R on either side.
Outcome cornerFan(const Trial &trial) {
    auto scene = support::openFloor(4.0).wall(0, -2, 2, 0).start(-1.0, 1.0);
    const double angle = trial.draw.between(0.2, 1.3);
    const double speed = trial.draw.between(0.5, 4.0);
    const double dt = drawDt(trial.draw);
    const double x = std::cos(angle);
    const double y = -std::sin(angle);
    bool bounces = true;
    for (int i = -18; i <= 18; ++i) {
        Experiment ball(scene, trial.stepper, trial.model);
        ball.params.restitution_wall = 1.0;
        ball.params.sliding_friction = ball.params.wall_friction = 0.0;
        const double offset = 0.99 * kRadius * i / 18;
        ball.setPosition(-0.5 * x - offset * y, -0.5 * y + offset * x);
        ball.roll(speed * x, speed * y);
        const phys_vec3 given = ball.state.velocity;
        const double before = energyOf(ball);
        Watch watch(ball);
        if (!watch.step(stepsFor(1.0 / speed, dt), dt)) return outcome(watch, "");
        const bool turned = ball.state.velocity.x != given.x || ball.state.velocity.y != given.y;
        bounces = bounces && turned && std::abs(energyOf(ball) - before) <= 1e-12 * before;
    }
    return {bounces ? "bounces at each of 37 offsets" : "misses the corner, or gains or loses energy", {}};
}

Outcome zenoIntoACorner(const Trial &trial) {
    support::Random &draw = trial.draw;
    Experiment ball(support::squareRoom(1.0), trial.stepper, trial.model);
    ball.setPosition(draw.between(kRadius, 0.5), draw.between(kRadius, 0.5));
    ball.setLaw(draw.between(-1.0, -0.25), draw.between(-1.0, -0.25));
    ball.params.restitution_wall = draw.between(0.25, 0.625);
    const double dt = drawDt(draw);
    Watch watch(ball);
    watch.step(stepsFor(20.0, dt), dt);
    const bool rests = isAt(ball, kRadius, kRadius) && ball.state.flags & PHYS_AT_REST;
    return outcome(watch, rests ? "rests in the corner" : "hops in the corner");
}

Outcome thinBox(const Trial &trial) {
    const double speed = trial.draw.between(1.0, 8.0);
    const double dt = drawDt(trial.draw);
    auto scene = support::openFloor(8.0).wall(0.0, -1, 1e-3 * speed * dt, 1);
    Experiment ball(scene, trial.stepper, trial.model);
    ball.setPosition(-trial.draw.between(kRadius, 1.0), trial.draw.between(-0.5, 0.5));
    ball.roll(speed, 0.0);
    Watch watch(ball);
    watch.step(stepsFor(1.5 / speed, dt), dt);
    return outcome(watch, ball.state.position.x < 0.0 && ball.state.velocity.x < 0.0 ? "bounces off" : "goes through");
}

Outcome dropOnTheFloor(const Trial &trial, double restitution) {
    const double height = trial.draw.between(0.25, 3.0) * kRadius;
    const double dt = drawDt(trial.draw);
    Experiment ball(support::openFloor(1.0).start({0.0, 0.0, kRadius + height}), trial.stepper, trial.model);
    if (!ball.isReady()) return {phys_status_name(ball.status()), {}};
    ball.params.restitution_floor = restitution;
    Watch watch(ball);
    watch.step(stepsFor(4.0, dt), dt);
    if (restitution < 1.0) {
        const bool rests = ball.state.position.z == kRadius && ball.state.flags & PHYS_AT_REST;
        return outcome(watch, rests ? "comes to rest" : "hops on");
    }
    double highest = 0.0;
    for (double time = 0.0; time < 2.0 && watch.step(1, dt); time += dt)
        highest = std::max(highest, ball.state.position.z - kRadius);
    return outcome(watch, change(0.05, height, highest, "bounces higher", "bounces lower", "keeps its height"));
}

/// slowest, fastest: in units of sqrt(g R), at an angle of up to half a radian.
Outcome lowKerb(const Trial &trial, double slowest, double fastest) {
    support::Random &draw = trial.draw;
    auto scene = support::openFloor(4.0).box({{0.5, -4, 0}, {4, 4, 0.5 * kRadius}}).start(0.3, 0);
    Experiment ball(scene, trial.stepper, trial.model);
    ball.params.restitution_wall = 0.0;
    const double speed = draw.between(slowest, fastest) * std::sqrt(-ball.params.gravity.z * kRadius);
    const double angle = draw.between(-0.5, 0.5);
    const double dt = drawDt(draw);
    ball.roll(speed * std::cos(angle), speed * std::sin(angle));
    Watch watch(ball);
    watch.step(stepsFor(0.2 / (speed * std::cos(angle)) + 0.5, dt), dt);
    return outcome(watch, ball.state.position.x > 0.5 ? "climbs it" : "stays below");
}

/// Faster than sqrt(g R), so that it flies immediately.
Outcome offTheEdge(const Trial &trial) {
    Experiment ball(support::openFloor(1.0), trial.stepper, trial.model);
    const double speed = trial.draw.between(1.0, 3.0);
    const double dt = drawDt(trial.draw);
    ball.roll(speed, trial.draw.between(-0.5, 0.5));
    const double begun = 1.0 / speed;
    Watch watch(ball);
    watch.step(stepsFor(begun + 1.0, dt), dt);
    const uint64_t flown = PHYS_AIRBORNE | PHYS_OUT;
    const double time = ball.state.time - begun;
    // (1/2) 8 m/s^2 t^2, less what a step of a first-order scheme may take.
    const double fallen = kRadius - ball.state.position.z;
    const bool falls = (ball.state.flags & flown) == flown && std::abs(fallen - 4.0 * time * time) <= 2.0 * 8.0 * dt;
    return outcome(watch, falls && ball.state.velocity.x == speed ? "falls freely" : "doesn't fall");
}

} // namespace

std::vector<Extreme> contactExtremes() {
    const auto zero = [](double pull) { return [=](const Trial &trial) { return restitutionZero(trial, pull); }; };
    const auto gap = [](double least, double most) {
        return [=](const Trial &trial) { return narrowGap(trial, least, most); };
    };
    const auto boxes = [](bool duplicates) { return [=](const Trial &trial) { return manyBoxes(trial, duplicates); }; };
    const auto inside = [](double least, double most) {
        return [=](const Trial &trial) { return startInside(trial, least, most); };
    };
    const auto kerb = [](double slowest, double fastest) {
        return [=](const Trial &trial) { return lowKerb(trial, slowest, fastest); };
    };
    const auto drop = [](double restitution) {
        return [=](const Trial &trial) { return dropOnTheFloor(trial, restitution); };
    };
    const Expected elastic = [](const QByteArray &stepper, uint32_t) -> QByteArray {
        return stepper == "explicit-euler"     ? "gains energy"
               : stepper == "symplectic-euler" ? "loses energy"
                                               : "keeps its energy";
    };
    const Expected elasticDrop = [](const QByteArray &stepper, uint32_t) -> QByteArray {
        return stepper == "symplectic-euler" ? "bounces lower" : "keeps its height";
    };
    const Expected mouth = always("rests in its mouth");
    return {
        {"restitution 0 against a wall, tilted to it", zero(1.0), always("slides on along the wall")},
        {"restitution 0 against a wall, level", zero(0.0), always("slides on along the wall")},
        {"restitution 1, a bounce in every step", elasticCorridor, always("keeps its energy")},
        {"restitution 1, bouncing on a slope", elasticOnASlope, elastic},
        {"restitution 1, dropped from up to 3 R on the floor", drop(1.0), elasticDrop},
        {"the same with restitution 0.5", drop(0.5), always("comes to rest")},
        {"infinitely many bounces into a corner", zenoIntoACorner, always("rests in the corner")},
        {"start in a corner, pressed into it", startInACorner, always("rests there")},
        {"start with less than half the ball inside a wall", inside(0.05, 0.95), always("is pushed out")},
        {"start with the centre inside a wall", inside(-0.95, -0.05), always("is pushed out")},
        {"start between walls closer than the ball", startWedged, always("PHYS_ERROR_STUCK")},
        {"a gap of half to nine tenths of the ball", gap(0.5, 0.9), mouth},
        {"a gap exactly as wide as the ball", gap(1.0, 1.0), always("undefined, but finite")},
        {"a fan of hits on a corner", cornerFan, always("bounces at each of 37 offsets")},
        {"a wall a thousand times thinner than a step", thinBox, always("bounces off")},
        {"a wall of a thousand flush boxes", boxes(false), always("as one box, to the last bit")},
        {"a thousand boxes in one place", boxes(true), always("as one box, to the last bit")},
        {"a kerb half a radius high, restitution 0, above 4 sqrt(g R)", kerb(4.0, 6.0), always("climbs it")},
        {"the same below 1.5 sqrt(g R)", kerb(0.3, 1.5), always("stays below")},
        {"over the edge of the board", offTheEdge, always("falls freely")},
    };
}

} // namespace extremes
