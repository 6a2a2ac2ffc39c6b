// SPDX-License-Identifier: MIT
// The end of a small slip beside a smooth face or edge (model.md 14.2), against closed forms and integration.
#include "phases/slip_end.h"

#include <QtTest>

namespace {

using phys::SlipEnd;
using phys::Vec3;

constexpr double kClosingRadius = 0.03125, kClosingFriction = 2.0; // m, m/s^2
constexpr double kClosingSpeed = 0.0625, kLittle = 0x1p-26;        // of the ball along the wall, and of the slip, m/s
constexpr double kTimeError = 1e-12;                               // relative
constexpr double kWayError = 16.0 * 0x1p-52;

/// What the ball leans on is at its side in -x; y is along both.
phys::Moment closingMoment(const phys::Vec2 &slip, double pull) {
    phys::Moment moment;
    moment.radius = kClosingRadius;
    moment.gravity = {-0.5, pull, -9.0};
    moment.velocity = {0.0, kClosingSpeed, 0.0};
    const Vec3 rolling = moment.velocity - Vec3(slip.x, slip.y, 0.0);
    moment.spin = glm::cross(Vec3(0.0, 0.0, 1.0), rolling) / kClosingRadius + Vec3(0.0, 0.0, 4.0);
    return moment;
}

/// Contact 3 is the floor. support: normal of the face, or edge, on which it leans.
std::optional<SlipEnd> closingOf(const phys::Moment &moment, const Vec3 &slip, const Vec3 &support, bool isEdge,
                                 double pressure) {
    const Vec3 up(0.0, 0.0, 1.0), none(0.0);
    const phys::Held floor{up, up, kClosingFriction, 0.0, false};
    const phys::Held wall{support, isEdge ? Vec3(1.0, 1.0, 0.0) : support, 0.0, 0.0, false};
    const phys::Reaction rubs{phys::Mode::slipping, 1.0, none, none, slip};
    const phys::Reaction presses{phys::Mode::smooth, pressure, none, none, none};
    return SlipEnd::of(moment, {3, floor, rubs}, {1, wall, presses});
}

std::optional<SlipEnd> closingOf(const phys::Vec2 &slip, double pull, bool isEdge = false, double pressure = 2.5) {
    return closingOf(closingMoment(slip, pull), {slip.x, slip.y, 0.0}, {1.0, 0.0, 0.0}, isEdge, pressure);
}

/// The end of a slip that friction and a drive change, by Runge and Kutta's method in xi = integral of dt/|u|, in which
/// it falls exponentially.
double integratedEnd(phys::Vec2 u, const phys::Vec2 &drive) {
    constexpr double kStep = 1e-3;
    struct Rate {
        phys::Vec2 slip;
        double time;
    };
    const auto rateAt = [&](const phys::Vec2 &slip) {
        const double speed = glm::length(slip);
        return Rate{speed * drive - kClosingFriction * phys::Vec2(2.5 * slip.x, 3.5 * slip.y), speed};
    };
    double time = 0.0;
    for (const double least = 1e-14 * glm::length(u); glm::length(u) > least;) {
        const Rate a = rateAt(u), b = rateAt(u + 0.5 * kStep * a.slip), c = rateAt(u + 0.5 * kStep * b.slip),
                   d = rateAt(u + kStep * c.slip);
        u += kStep / 6.0 * (a.slip + 2.0 * b.slip + 2.0 * c.slip + d.slip);
        time += kStep / 6.0 * (a.time + 2.0 * b.time + 2.0 * c.time + d.time);
    }
    return time;
}

bool isClose(double value, double expected, double relative) {
    return std::abs(value - expected) <= relative * std::abs(expected);
}

} // namespace

class SlipEndTest : public QObject {
    Q_OBJECT

private slots:
    void aSlipAcrossEndsByFiveHalvesOfItsFriction();
    void aSlipThatKeepsItsDirectionFallsEvenly();
    void aSlipThatTurnsEndsAsIntegrationSays();
    void roundAnEdgeTheTurningOfTheWayDrivesIt();
    void ofTheEndAllSlipIsGone();
    void theBallStaysAtTheEdge();
    void theBallKeepsItsSpeedRoundAnEdge();
    void imagesAreTheSameToTheBit();
    void theLossesAreTheEnergyOfTheSlip();
    void aLargerSlipIsNone();
    void aSlipThatMayOpenTheSupportIsNone();
    void aSlipThatNeverEndsIsNone();
};

void SlipEndTest::aSlipAcrossEndsByFiveHalvesOfItsFriction() {
    QVERIFY(isClose(closingOf({kLittle, 0.0}, 0.0)->horizon(), kLittle / (2.5 * kClosingFriction), kTimeError));
}

/// With the sine g/B of its direction.
void SlipEndTest::aSlipThatKeepsItsDirectionFallsEvenly() {
    const double pull = 0.5, sine = pull / kClosingFriction;
    const phys::Vec2 slip(kLittle * std::sqrt(1.0 - sine * sine), kLittle * sine);
    QVERIFY(isClose(closingOf(slip, pull)->horizon(), kLittle / (2.5 * kClosingFriction), kTimeError));
}

void SlipEndTest::aSlipThatTurnsEndsAsIntegrationSays() {
    for (const double pull : {-0.5, 0.0, 0.3}) {
        for (const double along : {-0.3, 0.2}) {
            const phys::Vec2 slip = kLittle * phys::Vec2(1.0, along);
            const std::optional<SlipEnd> phase = closingOf(slip, pull);
            QVERIFY(phase.has_value());
            QVERIFY(isClose(phase->horizon(), integratedEnd(slip, {0.0, pull}), 1e-10));
        }
    }
}

void SlipEndTest::roundAnEdgeTheTurningOfTheWayDrivesIt() {
    const phys::Vec2 slip = kLittle * phys::Vec2(1.0, 0.2), drive(-kClosingSpeed * kClosingSpeed / kClosingRadius, 0.3);
    QVERIFY(isClose(closingOf(slip, 0.3, true)->horizon(), integratedEnd(slip, drive), 1e-7)); // as the slip's share
}

void SlipEndTest::ofTheEndAllSlipIsGone() {
    const std::optional<SlipEnd> phase = closingOf(kLittle * phys::Vec2(1.0, 0.2), 0.3, true);
    const phys::Place place = phase->placeAt(phase->horizon());
    const Vec3 slip = place.velocity - kClosingRadius * glm::cross(place.spin, Vec3(0.0, 0.0, 1.0));
    QVERIFY(glm::length(slip) < kWayError * kClosingSpeed);
    QCOMPARE(place.spin.z, 4.0);
}

void SlipEndTest::theBallStaysAtTheEdge() {
    const std::optional<SlipEnd> phase = closingOf(kLittle * phys::Vec2(1.0, 0.2), 0.3, true);
    const phys::Way now = phase->at(phase->horizon());
    const Vec3 normal = Vec3(1.0, 0.0, 0.0) + now.way / kClosingRadius;
    QVERIFY(std::abs(glm::length(normal) - 1.0) < kWayError);
    QVERIFY(std::abs(glm::dot(normal, now.velocity)) < kWayError * kClosingSpeed);
}

void SlipEndTest::theBallKeepsItsSpeedRoundAnEdge() {
    const std::optional<SlipEnd> phase = closingOf({kLittle, 0.0}, 0.0, true);
    QVERIFY(isClose(glm::length(phase->at(phase->horizon()).velocity), kClosingSpeed, kWayError));
}

void SlipEndTest::imagesAreTheSameToTheBit() {
    phys::Moment moment = closingMoment(kLittle * phys::Vec2(1.0, 0.2), 0.3);
    const auto placeOf = [](const phys::Moment &seen, const Vec3 &normal, const Vec3 &slip) {
        const auto phase = closingOf(seen, slip, normal, true, 2.5);
        return phase->placeAt(0.5 * phase->horizon());
    };
    const auto swapped = [](const Vec3 &v) { return Vec3(v.y, v.x, v.z); };
    const phys::Place here = placeOf(moment, {1.0, 0.0, 0.0}, kLittle * Vec3(1.0, 0.2, 0.0));
    moment.velocity = swapped(moment.velocity);
    moment.gravity = swapped(moment.gravity);
    moment.spin = -swapped(moment.spin);
    const phys::Place there = placeOf(moment, {0.0, 1.0, 0.0}, kLittle * Vec3(0.2, 1.0, 0.0));
    QVERIFY(swapped(here.way) == there.way && swapped(here.velocity) == there.velocity);
    QVERIFY(-swapped(here.spin) == there.spin && -swapped(here.turning) == there.turning);
}

/// A fifth of the square across, a seventh along, where nothing drives it.
void SlipEndTest::theLossesAreTheEnergyOfTheSlip() {
    const std::optional<SlipEnd> phase = closingOf(kLittle * phys::Vec2(1.0, 0.2), 0.0);
    QVERIFY(isClose(phase->losses(phase->horizon()).slip, kLittle * kLittle * (1.0 / 5.0 + 0.04 / 7.0), kTimeError));
}

void SlipEndTest::aLargerSlipIsNone() { QVERIFY(!closingOf({1e-3, 0.0}, 0.0)); }

/// Friction presses the ball against the wall by less and less as the slip turns.
void SlipEndTest::aSlipThatMayOpenTheSupportIsNone() {
    const phys::Vec2 slip = kLittle * phys::Vec2(1.0, 0.1);
    QVERIFY(closingOf(slip, 0.9).has_value());
    QVERIFY(!closingOf(slip, 0.9, false, 1e-3));
}

void SlipEndTest::aSlipThatNeverEndsIsNone() { QVERIFY(!closingOf(kLittle * phys::Vec2(0.1, 1.0), 9.0)); }

QTEST_GUILESS_MAIN(SlipEndTest)
#include "tst_slip_end.moc"
