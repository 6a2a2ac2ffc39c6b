// SPDX-License-Identifier: MIT
// A ball that goes round a smooth edge (model.md 14.2), against closed forms of the pendulum.
#include "phases/pendulum.h"

#include <QtTest>

namespace {

using phys::Pendulum;
using phys::Vec3;

constexpr double kSwingRadius = 0.03125, kPendulumGravity = 9.81; // of the ball, m; m/s^2
constexpr int kAlongEdge = 1;
constexpr double kStartAngle = 0.7;               // rad from straight above the edge, at the start
constexpr double kPendulumError = 16.0 * 0x1p-52; // of sums of 25 terms of order 1, in units of R and sqrt(R g)
const double kPendulumTime = std::sqrt(kSwingRadius / kPendulumGravity);

Vec3 normalAt(double angle) { return {std::sin(angle), 0.0, std::cos(angle)}; }
Vec3 tangentAt(double angle) { return {std::cos(angle), 0.0, -std::sin(angle)}; }

/// The speed that the ball has there if it started at rest above the edge.
double speedAt(double angle) { return std::sqrt(2.0 * kPendulumGravity * kSwingRadius * (1.0 - std::cos(angle))); }

phys::Reaction pressingBy(double pressure, phys::Mode mode) {
    return {mode, pressure, Vec3(0.0), Vec3(0.0), Vec3(0.0)};
}

/// From kStartAngle with this speed; along the edge with 0.3 m/s and 0.5 m/s^2.
Pendulum swinging(double speed, double wanted = 1.0) {
    phys::Moment moment;
    moment.radius = kSwingRadius;
    moment.gravity = {0.0, 0.5, -kPendulumGravity};
    moment.velocity = speed * tangentAt(kStartAngle) + Vec3(0.0, 0.3, 0.0);
    moment.spin = {1.0, 2.0, 3.0};
    const double pressure = kPendulumGravity * std::cos(kStartAngle) - speed * speed / kSwingRadius;
    const phys::Held edge{normalAt(kStartAngle), {1.0, 0.0, 1.0}, 0.0, 0.0, false};
    return {moment, {4, edge, pressingBy(pressure, phys::Mode::smooth)}, true, wanted};
}

constexpr double kTiltedGravity = 1.25, kRollingResistance = 0.01;       // of the board, along its plane, m/s^2; mu_r
constexpr double kResistingPull = kRollingResistance * kPendulumGravity; // m/s^2

Vec3 uprightNormalAt(double angle) { return {std::sin(angle), std::cos(angle), 0.0}; }
Vec3 uprightTangentAt(double angle) { return {std::cos(angle), -std::sin(angle), 0.0}; }

/// On a floor, beside an upright edge onto which gravity pulls it at the angle 0.
phys::Moment rollingMoment(double angle, double speed) {
    phys::Moment moment;
    moment.radius = kSwingRadius;
    moment.gravity = {0.0, -kTiltedGravity, -kPendulumGravity};
    moment.velocity = speed * uprightTangentAt(angle);
    moment.spin = glm::cross(Vec3(0.0, 0.0, 1.0), moment.velocity) / kSwingRadius + Vec3(0.0, 0.0, 4.0);
    return moment;
}

Pendulum rolling(double angle, double speed, double resistance = kResistingPull) {
    const double pressure = kTiltedGravity * std::cos(angle) - 1.4 * speed * speed / kSwingRadius;
    const Vec3 heading = (speed < 0.0 ? -1.0 : 1.0) * uprightTangentAt(angle);
    const Vec3 up(0.0, 0.0, 1.0);
    const phys::Held edge{uprightNormalAt(angle), {1.0, 1.0, 0.0}, 0.0, 0.0, false},
        floor{up, up, 1.0, resistance, false};
    return {rollingMoment(angle, speed),
            {1, edge, pressingBy(pressure, phys::Mode::smooth)},
            {0, floor, pressingBy(1.0, phys::Mode::sticking)},
            heading,
            1.0};
}

double squareOf(const Vec3 &v) { return glm::dot(v, v); }

Vec3 pendulumNormal(const phys::Way &now) { return normalAt(kStartAngle) + now.way / kSwingRadius; }

} // namespace

class PendulumTest : public QObject {
    Q_OBJECT

private slots:
    void aBallFromRestAtTheTopFollowsTheSeparatrix();
    void itLeavesTheEdgeWhereTheCosineIsTwoThirds();
    void aFasterBallLeavesTheEdgeSooner();
    void energyIsKept();
    void theBallStaysAtTheEdge();
    void alongTheEdgeItFalls();
    void theSpinLasts();
    void fewTermsSufficeForAShortTime();
    void theLeastAccelerationIsABound();
    void aRollingBallHasFiveSeventhsOfTheForce();
    void aRollingBallHasFiveSeventhsOfTheWork();
    void aRollingBallLeavesTheEdgeWhereThePressureEnds();
    void resistanceStopsARollingBall();
    void withoutResistanceARollingBallTurnsRound();
    void aRollingBallStartsFromRest();
    void aRollingBallKeepsItsDrilling();
    void theLossesAreTheWorkOfResistance();
    void theLeastAccelerationOfARollingBallIsABound();
};

/// tan(angle/4) grows like exp(t sqrt(g/R)).
void PendulumTest::aBallFromRestAtTheTopFollowsTheSeparatrix() {
    const Pendulum phase = swinging(speedAt(kStartAngle));
    for (const double share : {0.1, 0.5, 1.0}) {
        const double t = share * phase.horizon();
        const double angle = 4.0 * std::atan(std::exp(t / kPendulumTime) * std::tan(kStartAngle / 4.0));
        const phys::Way now = phase.at(t);
        Vec3 across = now.velocity;
        across[kAlongEdge] = 0.0;
        Vec3 way = now.way;
        way[kAlongEdge] = 0.0;
        QVERIFY(glm::length(way - kSwingRadius * (normalAt(angle) - normalAt(kStartAngle))) <
                kPendulumError * kSwingRadius);
        QVERIFY(glm::length(across - speedAt(angle) * tangentAt(angle)) <
                kPendulumError * std::sqrt(kSwingRadius * kPendulumGravity));
    }
}

void PendulumTest::itLeavesTheEdgeWhereTheCosineIsTwoThirds() {
    const Pendulum phase = swinging(speedAt(kStartAngle));
    phys::Work work;
    const phys::End end = phase.end(phase.horizon(), work);
    QVERIFY(end.cause == phys::Cause::release && end.contact == 4);
    QVERIFY(std::abs(pendulumNormal(phase.at(end.after)).z - 2.0 / 3.0) < kPendulumError);
}

/// m v^2/R = m g cos, and v^2 = v_0^2 + 2 g R (cos_0 - cos).
void PendulumTest::aFasterBallLeavesTheEdgeSooner() {
    const double speed = 1.2 * speedAt(kStartAngle);
    const Pendulum phase = swinging(speed);
    phys::Work work;
    const phys::End end = phase.end(phase.horizon(), work);
    const double cosine = (2.0 * std::cos(kStartAngle) + speed * speed / (kPendulumGravity * kSwingRadius)) / 3.0;
    QVERIFY(std::abs(pendulumNormal(phase.at(end.after)).z - cosine) < kPendulumError);
}

void PendulumTest::energyIsKept() {
    const auto energy = [](const phys::Way &now) { // across the edge, in units of g R
        const double x = now.velocity.x, z = now.velocity.z;
        return 0.5 * (x * x + z * z) / (kPendulumGravity * kSwingRadius) + now.way.z / kSwingRadius;
    };
    const Pendulum phase = swinging(-0.4);
    for (const double share : {0.25, 0.5, 1.0}) {
        const double change = energy(phase.at(share * phase.horizon())) - energy(phase.at(0.0));
        QVERIFY(std::abs(change) < kPendulumError);
    }
}

void PendulumTest::theBallStaysAtTheEdge() {
    const Pendulum phase = swinging(-0.4);
    for (const double share : {0.25, 0.5, 1.0}) {
        Vec3 normal = pendulumNormal(phase.at(share * phase.horizon()));
        normal[kAlongEdge] = 0.0;
        QVERIFY(std::abs(glm::length(normal) - 1.0) < kPendulumError);
    }
}

void PendulumTest::alongTheEdgeItFalls() {
    const Pendulum phase = swinging(0.2);
    const double t = 0.5 * phase.horizon();
    QCOMPARE(phase.at(t).way[kAlongEdge], 0.3 * t + 0.25 * t * t);
    QCOMPARE(phase.at(t).velocity[kAlongEdge], 0.3 + 0.5 * t);
}

void PendulumTest::theSpinLasts() {
    const Pendulum phase = swinging(0.2);
    const phys::Place place = phase.placeAt(0.01);
    QVERIFY(place.spin == Vec3(1.0, 2.0, 3.0));
    QVERIFY(glm::length(place.turning - 0.01 * Vec3(1.0, 2.0, 3.0)) < kPendulumError);
}

void PendulumTest::fewTermsSufficeForAShortTime() {
    for (const double units : {0.02, 0.05, 0.12}) {
        const double soon = units * kPendulumTime;
        const phys::Way few = swinging(0.3, soon).at(soon), all = swinging(0.3).at(soon);
        QVERIFY(swinging(0.3, soon).horizon() < swinging(0.3).horizon());
        QVERIFY(glm::length(few.way - all.way) < 4.0 * 0x1p-52 * kSwingRadius);
        QVERIFY(glm::length(few.velocity - all.velocity) < 4.0 * 0x1p-52 * 0.3);
    }
}

void PendulumTest::aRollingBallHasFiveSeventhsOfTheForce() {
    const Pendulum phase = rolling(0.3, 0.05);
    const double pause = 1e-4 * phase.horizon();
    for (const double share : {0.25, 0.5, 0.75}) {
        const double t = share * phase.horizon();
        const Vec3 normal = uprightNormalAt(0.3) + phase.at(t).way / kSwingRadius, tangent(normal.y, -normal.x, 0.0);
        const Vec3 rate = (phase.at(t + pause).velocity - phase.at(t - pause).velocity) / (2.0 * pause);
        const double expected = 5.0 / 7.0 * (-kTiltedGravity * tangent.y - kResistingPull);
        QVERIFY(std::abs(glm::dot(rate, tangent) - expected) < 1e-7 * kTiltedGravity); // the square of the pause
    }
}

void PendulumTest::aRollingBallHasFiveSeventhsOfTheWork() {
    const double speed = 0.05;
    const Pendulum phase = rolling(0.3, speed);
    for (const double share : {0.25, 0.5, 1.0}) {
        const double t = share * phase.horizon();
        const phys::Way now = phase.at(t);
        const double turn =
            std::atan2(now.way.x / kSwingRadius + std::sin(0.3), now.way.y / kSwingRadius + std::cos(0.3)) - 0.3;
        const double work = -kTiltedGravity * now.way.y - kResistingPull * kSwingRadius * turn;
        const double gained = 0.5 * (squareOf(now.velocity) - speed * speed);
        QVERIFY(std::abs(gained - 5.0 / 7.0 * work) < kPendulumError * kTiltedGravity * kSwingRadius);
    }
}

/// m v^2/R = (5/7) m g cos.
void PendulumTest::aRollingBallLeavesTheEdgeWhereThePressureEnds() {
    const Pendulum phase = rolling(1.0, 0.1);
    phys::Work work;
    const phys::End end = phase.end(phase.horizon(), work);
    QVERIFY(end.cause == phys::Cause::release && end.contact == 1);
    const phys::Way now = phase.at(end.after);
    const double cosine = std::cos(1.0) + now.way.y / kSwingRadius;
    QVERIFY(std::abs(1.4 * squareOf(now.velocity) / kSwingRadius - kTiltedGravity * cosine) <
            kPendulumError * kTiltedGravity);
}

void PendulumTest::resistanceStopsARollingBall() {
    const Pendulum phase = rolling(0.5, -0.03);
    phys::Work work;
    const phys::End end = phase.end(phase.horizon(), work);
    QVERIFY(end.cause == phys::Cause::stop && end.contact == 0);
    QVERIFY(glm::length(phase.at(end.after).velocity) < kPendulumError * 0.03);
}

void PendulumTest::withoutResistanceARollingBallTurnsRound() {
    const Pendulum phase = rolling(0.5, -0.01, 0.0);
    phys::Work work;
    QVERIFY(phase.end(phase.horizon(), work).cause == phys::Cause::time);
    QVERIFY(phase.at(phase.horizon()).velocity.x > 0.0);
}

void PendulumTest::aRollingBallStartsFromRest() {
    const Pendulum phase = rolling(0.5, 0.0);
    phys::Work work;
    QVERIFY(phase.end(phase.horizon(), work).cause == phys::Cause::time);
    const double t = 1e-4 * phase.horizon();
    const double rate = 5.0 / 7.0 * (kTiltedGravity * std::sin(0.5) - kResistingPull);
    QVERIFY(std::abs(glm::length(phase.at(t).velocity) - rate * t) < 1e-7 * rate * t); // whose next term is of order 3
}

void PendulumTest::aRollingBallKeepsItsDrilling() {
    const Pendulum phase = rolling(0.3, 0.05);
    const double t = 0.5 * phase.horizon();
    QVERIFY(std::abs(phase.spinAt(t).z - 4.0) < 4.0 * kPendulumError);
    QVERIFY(std::abs(phase.placeAt(t).turning.z - 4.0 * t) < 4.0 * kPendulumError);
}

void PendulumTest::theLossesAreTheWorkOfResistance() {
    const double speed = -0.05;
    const Pendulum phase = rolling(0.3, speed);
    const double t = 0.5 * phase.horizon();
    const phys::Way now = phase.at(t);
    const double gained = 0.7 * (squareOf(now.velocity) - speed * speed), work = -kTiltedGravity * now.way.y;
    QVERIFY(std::abs(phase.losses(t).rolling - (work - gained)) < kPendulumError * kTiltedGravity * kSwingRadius);
    QCOMPARE(phase.losses(t).slip, 0.0);
}

void PendulumTest::theLeastAccelerationOfARollingBallIsABound() {
    constexpr int kLooks = 16;
    const Pendulum phase = rolling(0.5, -0.03);
    const double from = 0.1 * phase.horizon(), until = 0.4 * phase.horizon(), pause = 1e-6 * phase.horizon();
    for (int direction = 0; direction < kLooks; ++direction) {
        const Vec3 n = uprightNormalAt(2.0 * std::acos(-1.0) * direction / kLooks);
        const double least = phase.least(n, 0.0, from, until);
        for (int look = 0; look < kLooks; ++look) {
            const double t = from + (until - from) * look / kLooks;
            const double rate = glm::dot(n, phase.at(t + pause).velocity - phase.at(t).velocity) / pause;
            QVERIFY(rate >= least - 1e-6 * kTiltedGravity); // which the pause changes by that much
        }
    }
}

void PendulumTest::theLeastAccelerationIsABound() {
    constexpr int kLooks = 16;
    const Pendulum phase = swinging(0.3);
    const double from = 0.1 * phase.horizon(), until = 0.4 * phase.horizon();
    for (int direction = 0; direction < kLooks; ++direction) {
        const double turn = 2.0 * std::acos(-1.0) * direction / kLooks;
        const Vec3 n(std::cos(turn), 0.0, std::sin(turn));
        const double least = phase.least(n, 0.0, from, until);
        for (int look = 0; look <= kLooks; ++look) {
            const phys::Way now = phase.at(from + (until - from) * look / kLooks);
            const Vec3 normal = pendulumNormal(now), tangent(normal.z, 0.0, -normal.x);
            const double speed = glm::dot(now.velocity, tangent);
            const Vec3 acceleration = -kPendulumGravity * tangent.z * tangent - speed * speed / kSwingRadius * normal;
            QVERIFY(glm::dot(n, acceleration) >= least);
        }
    }
}

QTEST_GUILESS_MAIN(PendulumTest)
#include "tst_pendulum.moc"
