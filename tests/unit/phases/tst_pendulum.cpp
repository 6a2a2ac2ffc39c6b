// SPDX-License-Identifier: MIT
// A ball that glides round a smooth edge (model.md 14.2), against closed forms of the pendulum.
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

/// From kStartAngle with this speed; along the edge with 0.3 m/s and 0.5 m/s^2.
Pendulum swinging(double speed, double wanted = 1.0) {
    phys::Moment moment;
    moment.radius = kSwingRadius;
    moment.gravity = {0.0, 0.5, -kPendulumGravity};
    moment.velocity = speed * tangentAt(kStartAngle) + Vec3(0.0, 0.3, 0.0);
    moment.spin = {1.0, 2.0, 3.0};
    const double pressure = kPendulumGravity * std::cos(kStartAngle) - speed * speed / kSwingRadius;
    return {moment, 4, normalAt(kStartAngle), pressure, kAlongEdge, 0.5, wanted};
}

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
    const double soon = 0.04 * kPendulumTime;
    const phys::Way few = swinging(0.3, soon).at(soon), all = swinging(0.3).at(soon);
    QVERIFY(swinging(0.3, soon).horizon() < swinging(0.3).horizon());
    QVERIFY(glm::length(few.way - all.way) < 4.0 * 0x1p-52 * kSwingRadius);
    QVERIFY(glm::length(few.velocity - all.velocity) < 4.0 * 0x1p-52 * 0.3);
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
