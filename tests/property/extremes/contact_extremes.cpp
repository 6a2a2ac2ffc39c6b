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

/// Whether the ball's centre is at a place in the plane, within what the library takes for a touch.
bool isAt(const Experiment &ball, double x, double y) {
    const double slack = roundingDepth(ball.scene(), ball.state);
    return std::abs(ball.state.position.x - x) <= slack && std::abs(ball.state.position.y - y) <= slack;
}

/// By 5 % or more: the words of `grown`, `shrunk`, otherwise `kept`.
QByteArray change(double before, double after, const char *grown, const char *shrunk, const char *kept) {
    return after > 1.05 * before ? grown : after < 0.95 * before ? shrunk : kept;
}

double energyOf(const Experiment &ball) {
    double energy = 0.0;
    phys_energy(ball.scene(), &ball.params, &ball.state, &energy);
    return energy;
}

Outcome restitutionZero(const QByteArray &stepper, uint32_t model) {
    Experiment ball(leftWall(), stepper, model);
    ball.params.restitution_wall = 0.0;
    ball.setPosition(0.25, 0.0);
    ball.roll(-0.5, 0.25);
    Watch watch(ball);
    watch.step(256, kDt);
    const bool touches = isAt(ball, kRadius, ball.state.position.y);
    const bool slides = touches && ball.state.velocity.x == 0.0 && ball.state.velocity.y > 0.0;
    return outcome(watch, slides ? "slides on along the wall" : "leaves the wall");
}

Outcome elasticCorridor(const QByteArray &stepper, uint32_t model) {
    // 1/64 m to and fro at 2 m/s: a bounce in each step of 1/128 s.
    auto scene = support::openFloor(1.0).wall(-1, -1, 0, 1).wall(0x1p-6 + 2.0 * kRadius, -1, 1, 1).start(kRadius, 0.0);
    Experiment ball(scene, stepper, model);
    makeSmooth(ball);
    ball.params.restitution_wall = 1.0;
    ball.roll(2.0, 0.0);
    const uint64_t bounces = support::effort(10'000, 1'000'000, 10'000'000);
    const double before = energyOf(ball);
    Watch watch(ball);
    watch.step(bounces, kDt);
    // A rigid ball's velocity is put together from sevenths in each step: a rounding or two each.
    const double slack = support::rounding(8.0 * static_cast<double>(bounces), before);
    return outcome(watch, std::abs(energyOf(ball) - before) <= slack ? "keeps its energy" : "changes its energy");
}

Outcome elasticOnASlope(const QByteArray &stepper, uint32_t model) {
    Experiment ball(leftWall(), stepper, model);
    makeSmooth(ball);
    ball.setLaw(-0.5, 0.0);
    ball.params.restitution_wall = 1.0;
    ball.roll(0.53, 0.0); // no multiple of a step's change: symplectic Euler would lose nothing
    const double rest =
        -ball.params.gravity.x * kRadius - ball.params.gravity.z * kRadius; // energy in the wall's contact
    const double spin = 0.2 * 0.53 * 0.53;                                  // of a smooth rigid ball: it never changes
    const double fixed = rest + (model == PHYS_MODEL_RIGID ? spin : 0.0);
    const double before = energyOf(ball) - fixed;
    Watch watch(ball);
    watch.step(25'600, kDt);
    return outcome(watch, change(before, energyOf(ball) - fixed, "gains energy", "loses energy", "keeps its energy"));
}

Outcome narrowGap(const QByteArray &stepper, uint32_t model, double width) {
    auto scene = support::openFloor(4.0).wall(-4, -0.5, -width / 2, 0).wall(width / 2, -0.5, 4, 0).start(0x1p-10, 0.5);
    Experiment ball(scene, stepper, model);
    ball.params.restitution_wall = 0.25;
    ball.setLaw(0.0, -0.5, 0x1p-5);
    Watch watch(ball);
    watch.step(2560, kDt);
    if (width == 2.0 * kRadius) return outcome(watch, "undefined, but finite");
    if (ball.state.position.y <= 0.0) return outcome(watch, "passes");
    return outcome(watch, ball.state.flags & PHYS_AT_REST ? "rests in its mouth" : "hops in its mouth");
}

Outcome manyBoxes(const QByteArray &stepper, uint32_t model, bool duplicates) {
    auto one = support::openFloor(8.0).wall(-1, -8, 0, 8).start(0.5, -4.0);
    auto many = support::openFloor(8.0);
    for (int i = 0; i < 1000; ++i) {
        if (duplicates)
            many.wall(-1, -8, 0, 8);
        else
            many.wall(-1, -8.0 + 0.016 * i, 0, i == 999 ? 8.0 : -8.0 + 0.016 * (i + 1));
    }
    many.start(0.5, -4.0);
    Experiment a(one, stepper, model);
    Experiment b(many, stepper, model);
    for (Experiment *ball : {&a, &b}) {
        ball->setLaw(-0.5, 0.0);
        ball->roll(-0.5, 1.0);
    }
    Watch watchA(a);
    Watch watchB(b);
    bool same = true;
    for (int i = 0; i < 512 && same; ++i) {
        if (!watchA.step(1, kDt) || !watchB.step(1, kDt)) break;
        same = support::sameBits(a.state, b.state);
    }
    return outcome(watchB, same ? "as one box, to the last bit" : "not as one box");
}

/// The centre's distance from the face, in radii, > 0 outside: least .. most.
Outcome startInside(const QByteArray &stepper, uint32_t model, double least, double most) {
    return overDraws([&](support::Random &draw) {
        Experiment ball(leftWall(), stepper, model);
        ball.setPosition(draw.between(least, most) * kRadius, draw.between(-5.0, 5.0));
        const double dt = draw.between(0x1p-10, 0x1p-6);
        ball.step(dt);
        const double slack = roundingDepth(ball.scene(), ball.state);
        const bool out = depthOf(ball.scene(), ball.state) <= slack;
        Watch watch(ball);
        watch.step(16, dt);
        return outcome(watch, out && ball.state.position.x >= kRadius - slack ? "is pushed out" : "stays inside");
    });
}

Outcome startWedged(const QByteArray &stepper, uint32_t model) {
    auto scene = support::openFloor(1.0).wall(-1, -1, 0, 1).wall(1.5 * kRadius, -1, 1, 1).start(0.75 * kRadius, 0.0);
    Experiment ball(scene, stepper, model);
    Watch watch(ball);
    watch.step(1, kDt);
    return outcome(watch, "is pushed out");
}

Outcome startInACorner(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::squareRoom(1.0).start(kRadius, kRadius), stepper, model);
    ball.setLaw(-0.5, -0.25);
    Watch watch(ball);
    watch.step(512, kDt);
    const bool rests = isAt(ball, kRadius, kRadius) && ball.state.flags & PHYS_AT_REST;
    return outcome(watch, rests ? "rests there" : "hops there");
}

Outcome cornerFan(const QByteArray &stepper, uint32_t model) {
    auto scene = support::openFloor(4.0).wall(0, -2, 2, 0).start(-1.0, 1.0);
    bool bounces = true;
    for (int i = 0; i < 360; ++i) {
        Experiment ball(scene, stepper, model);
        ball.params.restitution_wall = 1.0;
        // Along the diagonal, as far beside the corner (0, 0) as 0.99 R to either side.
        const double offset = 0.99 * kRadius * (i - 179.5) / 179.5;
        ball.setPosition(-0.5 + offset * std::sqrt(0.5), 0.5 + offset * std::sqrt(0.5));
        ball.roll(0.75, -0.75);
        const double before = energyOf(ball);
        Watch watch(ball);
        if (!watch.step(128, kDt)) return outcome(watch, "");
        const bool turned = ball.state.velocity.x != 0.75 || ball.state.velocity.y != -0.75;
        bounces = bounces && turned && energyOf(ball) <= before * (1.0 + 1e-12);
    }
    return {bounces ? "bounces at each of 360 offsets" : "misses the corner or gains energy", {}};
}

Outcome zenoIntoACorner(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::squareRoom(1.0).start(0.25, 0.25), stepper, model);
    ball.setLaw(-0.5, -0.25);
    ball.params.restitution_wall = 0.5;
    Watch watch(ball);
    watch.step(3840, kDt);
    const bool rests = isAt(ball, kRadius, kRadius) && ball.state.flags & PHYS_AT_REST;
    return outcome(watch, rests ? "rests in the corner" : "hops in the corner");
}

Outcome thinBox(const QByteArray &stepper, uint32_t model) {
    auto scene = support::openFloor(8.0).wall(0.0, -1, 1e-5, 1).start(-2.0, 0.0);
    bool bounces = true;
    for (int phase = 0; phase < 16; ++phase) {
        Experiment ball(scene, stepper, model);
        ball.setPosition(-1.0 - phase / 64.0, 0.0);
        ball.roll(8.0, 0.0);
        Watch watch(ball);
        if (!watch.step(32, kDt)) return outcome(watch, "");
        bounces = bounces && ball.state.position.x < 0.0;
    }
    return {bounces ? "bounces off" : "goes through", {}};
}

Outcome dropOnTheFloor(const QByteArray &stepper, uint32_t model, double restitution) {
    return overDraws([&](support::Random &draw) -> Outcome {
        const double height = draw.between(0.5, 2.0) * kRadius;
        const double dt = draw.between(0x1p-10, 0x1p-9);
        Experiment ball(support::openFloor(1.0).start({0.0, 0.0, kRadius + height}), stepper, model);
        if (!ball.isReady()) return {phys_status_name(ball.status()), {}};
        ball.params.restitution_floor = restitution;
        Watch watch(ball);
        watch.step(static_cast<uint64_t>(4.0 / dt), dt);
        if (restitution < 1.0) {
            const bool rests = ball.state.position.z == kRadius && ball.state.flags & PHYS_AT_REST;
            return outcome(watch, rests ? "comes to rest" : "hops on");
        }
        double highest = 0.0;
        for (double time = 0.0; time < 1.0 && watch.step(1, dt); time += dt)
            highest = std::max(highest, ball.state.position.z - kRadius);
        return outcome(watch, change(height, highest, "bounces higher", "bounces lower", "keeps its height"));
    });
}

/// slowest, fastest: in units of sqrt(g R), aslant by up to half a radian.
Outcome lowKerb(const QByteArray &stepper, uint32_t model, double slowest, double fastest) {
    return overDraws([&](support::Random &draw) {
        auto scene = support::openFloor(4.0).box({{0.5, -4, 0}, {4, 4, 0.5 * kRadius}}).start(0.3, 0);
        Experiment ball(scene, stepper, model);
        ball.params.restitution_wall = 0.0;
        const double speed = draw.between(slowest, fastest) * std::sqrt(-ball.params.gravity.z * kRadius);
        const double angle = draw.between(-0.5, 0.5);
        const double dt = draw.between(0x1p-9, 0x1p-7);
        ball.roll(speed * std::cos(angle), speed * std::sin(angle));
        Watch watch(ball);
        watch.step(static_cast<uint64_t>((0.2 / (speed * std::cos(angle)) + 0.5) / dt), dt);
        return outcome(watch, ball.state.position.x > 0.5 ? "climbs it" : "stays below");
    });
}

Outcome offTheEdge(const QByteArray &stepper, uint32_t model) {
    Experiment ball(support::openFloor(1.0), stepper, model);
    ball.roll(1.0, 0.0);
    Watch watch(ball);
    watch.step(256, kDt);
    const uint64_t flown = PHYS_AIRBORNE | PHYS_OUT;
    // After 1 s of flight: (1/2) 8 m/s^2 1 s^2, less what a first order's step may take.
    const double fallen = kRadius - ball.state.position.z;
    const bool falls = (ball.state.flags & flown) == flown && std::abs(fallen - 4.0) <= 2.0 * 8.0 * kDt;
    return outcome(watch, falls && ball.state.velocity.x == 1.0 ? "falls freely" : "doesn't fall");
}

} // namespace

std::vector<Extreme> contactExtremes() {
    const auto gap = [](double width) {
        return [width](const QByteArray &stepper, uint32_t model) { return narrowGap(stepper, model, width); };
    };
    const auto boxes = [](bool duplicates) {
        return
            [duplicates](const QByteArray &stepper, uint32_t model) { return manyBoxes(stepper, model, duplicates); };
    };
    const auto inside = [](double least, double most) {
        return [=](const QByteArray &stepper, uint32_t model) { return startInside(stepper, model, least, most); };
    };
    const auto kerb = [](double slowest, double fastest) {
        return [=](const QByteArray &stepper, uint32_t model) { return lowKerb(stepper, model, slowest, fastest); };
    };
    const auto drop = [](double restitution) {
        return [=](const QByteArray &stepper, uint32_t model) { return dropOnTheFloor(stepper, model, restitution); };
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
        {"restitution 0 against a wall", restitutionZero, always("slides on along the wall")},
        {"restitution 1, a bounce in every step", elasticCorridor, always("keeps its energy")},
        {"restitution 1, bouncing on a slope", elasticOnASlope, elastic},
        {"restitution 1, dropped on the floor", drop(1.0), elasticDrop},
        {"restitution 0.5, dropped on the floor", drop(0.5), always("comes to rest")},
        {"infinitely many bounces into a corner", zenoIntoACorner, always("rests in the corner")},
        {"start in a corner, pressed into it", startInACorner, always("rests there")},
        {"start with less than half the ball inside a wall", inside(0.05, 0.95), always("is pushed out")},
        {"start with the centre inside a wall", inside(-0.95, -0.05), always("is pushed out")},
        {"start between walls closer than the ball", startWedged, always("PHYS_ERROR_STUCK")},
        {"a gap narrower than the ball", gap(0.75 * 2.0 * kRadius), mouth},
        {"a gap exactly as wide as the ball", gap(2.0 * kRadius), always("undefined, but finite")},
        {"a fan of hits on a corner", cornerFan, always("bounces at each of 360 offsets")},
        {"a wall a thousand times thinner than a step", thinBox, always("bounces off")},
        {"a wall of a thousand flush boxes", boxes(false), always("as one box, to the last bit")},
        {"a thousand boxes in one place", boxes(true), always("as one box, to the last bit")},
        {"a kerb half a radius high, restitution 0, above 3 sqrt(g R)", kerb(3.0, 5.0), always("climbs it")},
        {"the same below 1.5 sqrt(g R)", kerb(0.3, 1.5), always("stays below")},
        {"over the edge of the board", offTheEdge, always("falls freely")},
    };
}

} // namespace extremes
