// SPDX-License-Identifier: MIT
// Published theorems as acceptance tests: billiards, and the laws of the rolling ball. Citations: accuracy.md.
// Statistics hold within four standard errors, from batch means.
#include "run.h"

#include <QtTest>

#include <array>
#include <numbers>

using exact::kU;
using exact::Run;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kBatch = 1500;  // s
constexpr uint32_t kPost = 5; // after the floor and four walls

/// The ball's centre moves in a unit square round a disc: the walls are a radius away, and the post has no width.
/// Reflected at the walls and unfolded, this is the Sinai billiard on the torus.
std::vector<phys_box> sinaiRoom(double R) {
    return {exact::floorOver(-1, -1, 2, 2), exact::wall(-1, -1, 2, -R),       exact::wall(-1, 1 + R, 2, 2),
            exact::wall(-1, -R, -R, 1 + R), exact::wall(1 + R, -R, 2, 1 + R), exact::wall(0.5, 0.5, 0.5, 0.5)};
}

/// Faults of a stepper that would be hard to notice.
enum class Fault {
    none,
    turnedNormal, ///< the post's is off by 1e-3
    lostHit,      ///< one in 10,000: the ball continues straight on
    lateBounce    ///< by 1e-6 s
};

/// Level, without losses, at 1 m/s in a generic direction.
class Billiard : public Run {
public:
    explicit Billiard(double R, Fault fault = Fault::none)
        : Run(sinaiRoom(R), R, {0.1875, 0.28125, R}, {std::cos(0.7), std::sin(0.7), 0.0})
        , m_fault(fault) {
        params.restitution_wall = 1.0;
    }

    /// Number of hits of the last step.
    double hits() const { return m_hits; }

    void step(double duration) {
        m_hits = 0.0;
        while (m_fault != Fault::none && hit(duration)) ++m_hits;
        Run::step(duration);
        m_hits += report.event_count;
    }

private:
    Fault m_fault;
    double m_hits = 0.0;
    int m_allHits = 0;

    /// Goes to the next hit and handles it incorrectly. False if there is none within this time, s.
    bool hit(double &left) {
        const phys_state before = state;
        Run::step(left);
        if (events.empty()) {
            state = before;
            return false;
        }
        const phys_event first = events.front();
        double passed = first.time - before.time + 1e-9;
        state = before;
        Run::step(passed);
        const phys_vec3 in = before.velocity, out = state.velocity;
        if (m_fault == Fault::turnedNormal && first.box == kPost) {
            state.velocity = {out.x * std::cos(2e-3) - out.y * std::sin(2e-3),
                              out.x * std::sin(2e-3) + out.y * std::cos(2e-3), 0.0};
        }
        if (m_fault == Fault::lostHit && ++m_allHits % 10'000 == 0) {
            state.velocity = in;
            state.position.x += 2.5 * in.x;
            state.position.y += 2.5 * in.y;
        }
        if (m_fault == Fault::lateBounce && left > passed + 2e-6) {
            state.position.x += 1e-6 * in.x + (1e-6 - 1e-9) * out.x;
            state.position.y += 1e-6 * in.y + (1e-6 - 1e-9) * out.y;
            passed += 2e-6 - 1e-9;
        }
        left = std::max(0.0, left - passed);
        return true;
    }
};

/// A mean and its standard error from batches.
class BatchMeans {
public:
    void add(double batch) {
        m_sum += batch;
        m_squares += batch * batch;
        ++m_count;
    }
    double mean() const { return m_sum / m_count; }
    double error() const { return std::sqrt((m_squares / m_count - mean() * mean()) / (m_count - 1.0)); }
    bool agreesWith(double expected) const { return std::abs(mean() - expected) <= 4.0 * error(); }
    QByteArray told(double expected) const {
        return QByteArray::number(mean()) + " +- " + QByteArray::number(error()) + ", expected " +
               QByteArray::number(expected);
    }

private:
    double m_sum = 0.0, m_squares = 0.0;
    int m_count = 0;
};

using Phase = std::array<double, 4>; // x, y, and their velocities

constexpr double kFlightRadius = 0.125, kFlight = 3.0; // m, s
const Phase kStart{0.1875, 0.28125, std::cos(0.7), std::sin(0.7)};

Phase flown(const Phase &start, Fault fault) {
    Billiard ball(kFlightRadius, fault);
    ball.state.position = {start[0], start[1], kFlightRadius};
    ball.state.velocity = {start[2], start[3], 0.0};
    ball.step(kFlight);
    return {ball.state.position.x, ball.state.position.y, ball.state.velocity.x, ball.state.velocity.y};
}

/// Change of the end per change of the start, by finite differences.
Phase change(const Phase &by, Fault fault) {
    const double h = 1e-6;
    Phase ahead = kStart, behind = kStart;
    for (size_t i = 0; i < 4; ++i) {
        ahead[i] += h * by[i];
        behind[i] -= h * by[i];
    }
    const Phase a = flown(ahead, fault), b = flown(behind, fault);
    Phase slope{};
    for (size_t i = 0; i < 4; ++i) slope[i] = (a[i] - b[i]) / (2.0 * h);
    return slope;
}

double area(const Phase &a, const Phase &b) { return a[0] * b[2] - a[2] * b[0] + a[1] * b[3] - a[3] * b[1]; }

/// Largest change of an area spanned by two neighbours, relative to what cancels in it.
double changeOfAreas(Fault fault) {
    std::array<Phase, 4> columns;
    for (size_t i = 0; i < 4; ++i) {
        Phase unit{};
        unit[i] = 1.0;
        columns[i] = change(unit, fault);
    }
    double largest = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        for (size_t j = 0; j < i; ++j) {
            Phase a{}, b{};
            a[i] = b[j] = 1.0;
            double size = 1.0;
            for (size_t k = 0; k < 4; ++k) size += std::abs(columns[i][k] * columns[j][k]);
            largest = std::max(largest, std::abs(area(columns[i], columns[j]) - area(a, b)) / size);
        }
    }
    return largest;
}

/// Largest deviation from the end that a start ahead in time, or a faster one, must have.
double changeAlongTheFlow(Fault fault) {
    const Phase end = flown(kStart, fault);
    const Phase ahead = change({kStart[2], kStart[3], 0.0, 0.0}, fault);
    const Phase faster = change({0.0, 0.0, kStart[2], kStart[3]}, fault);
    double largest = 0.0;
    for (size_t i = 0; i < 2; ++i) {
        largest = std::max({largest, std::abs(ahead[i] - end[i + 2]), std::abs(ahead[i + 2]),
                            std::abs(faster[i] - kFlight * end[i + 2]), std::abs(faster[i + 2] - end[i + 2])});
    }
    return largest;
}

/// Hits per second.
BatchMeans hitRate(Fault fault, int batches) {
    Billiard ball(kFlightRadius, fault);
    BatchMeans rate;
    for (int batch = 0; batch < batches; ++batch) {
        double hits = 0.0;
        for (int i = 0; i < kBatch; ++i) {
            ball.step(1.0);
            hits += ball.hits();
        }
        rate.add(hits / kBatch);
    }
    return rate;
}

/// Santalo; Chernov 1997: the mean length between hits of a billiard is pi A/P.
constexpr double kHitRate = (4.0 + 2.0 * kPi * kFlightRadius) / (kPi * (1.0 - kPi * kFlightRadius * kFlightRadius));

bool isPrecise(const BatchMeans &rate) { return rate.error() < 0.01 * kHitRate; }

} // namespace

class ExactTheorems : public QObject {
    Q_OBJECT
private slots:
    void meanFreePathIsPiTimesAreaOverPerimeter();
    void timeBetweenHitsOfTheDisc();
    void lyapunovExponentOfTheSinaiBilliard();
    void flowKeepsAreas();
    void twoExponentsAreZero();
    void bouncesAccumulateAfterOnePlusEpsilonOverOneMinusEpsilon();
    void ballRollsWithFiveSeventhsOfTheSlope();
    void smallFaultsBreakThem();
};

void ExactTheorems::meanFreePathIsPiTimesAreaOverPerimeter() {
    const BatchMeans rate = hitRate(Fault::none, 40);
    QVERIFY2(rate.agreesWith(kHitRate), rate.told(kHitRate));
    QVERIFY(isPrecise(rate));
}

/// The same theorem on the torus: (1 - pi R^2)/(2 R).
void ExactTheorems::timeBetweenHitsOfTheDisc() {
    const double R = 0.125;
    Billiard ball(R);
    BatchMeans rate;
    for (int batch = 0; batch < 40; ++batch) {
        double hits = 0.0;
        for (int i = 0; i < kBatch; ++i) {
            ball.step(1.0);
            for (const phys_event &event : ball.events) hits += event.box == kPost ? 1.0 : 0.0;
        }
        rate.add(hits / kBatch);
    }
    const double expected = 2.0 * R / (1.0 - kPi * R * R);
    QVERIFY2(rate.agreesWith(expected), rate.told(expected));
    QVERIFY(rate.error() < 0.04 * expected);
}

/// Dahlqvist 1997: the exponent of the map from hit to hit of the disc, h(R) + 2 ln R -> 1 - 4 ln 2 + 27 zeta(3)/(2
/// pi^2). A wave front of curvature k leaves a hit with k + 2/(R cos phi) and has k/(1 + k t) after a time t; the walls
/// are flat.
void ExactTheorems::lyapunovExponentOfTheSinaiBilliard() {
    const double R = 0.01, zeta3 = 1.2020569031595942;
    Billiard ball(R);
    BatchMeans exponent;
    double curvature = 1.0, last = 0.0;
    for (int batch = 0; batch < 40; ++batch) {
        double sum = 0.0;
        int hits = 0;
        while (hits < 250) {
            ball.step(1.0);
            for (const phys_event &event : ball.events) {
                if (event.box != kPost) continue;
                const double growth = 1.0 + curvature * (event.time - last);
                sum += std::log(growth);
                curvature = curvature / growth + 2.0 / (R * -event.speed_before);
                last = event.time;
                ++hits;
            }
        }
        exponent.add(sum / hits + 2.0 * std::log(R));
    }
    const double expected = 1.0 - 4.0 * std::log(2.0) + 27.0 * zeta3 / (2.0 * kPi * kPi);
    QVERIFY2(exponent.agreesWith(expected), exponent.told(expected));
    QVERIFY(exponent.error() < 0.02);
}

/// Liouville: dx and dv of any two neighbours span the same area for all times, so that exponents come in pairs of sum
/// zero.
void ExactTheorems::flowKeepsAreas() { QVERIFY(changeOfAreas(Fault::none) <= 1e-7); }

/// Along the flow, and in speed, neighbours stay neighbours: one is ahead by a constant time, the other by a share of
/// it.
void ExactTheorems::twoExponentsAreZero() { QVERIFY(changeAlongTheFlow(Fault::none) <= 1e-7); }

void ExactTheorems::bouncesAccumulateAfterOnePlusEpsilonOverOneMinusEpsilon() {
    const double R = 0.0625, height = 0.5, gn = 9.75;
    for (const double restitution : {0.25, 0.5, 0.8}) {
        Run run({exact::floorOver(-1, -1, 1, 1)}, R, {0, 0, R + height});
        run.params.gravity = {0, 0, -gn};
        run.params.restitution_floor = restitution;
        run.step(4.0);
        const double fall = std::sqrt(2.0 * height / gn);
        const double expected = fall * (1.0 + restitution) / (1.0 - restitution);
        QVERIFY(std::abs(run.eventsOf(PHYS_EVENT_LANDING).back().time - expected) <= 1e-12);
        QVERIFY(run.state.flags & PHYS_AT_REST);
    }
}

/// 5/7 of the slope's acceleration; sqrt(10/7 g h) of speed.
void ExactTheorems::ballRollsWithFiveSeventhsOfTheSlope() {
    for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
        Run run({exact::floorOver(-1, -1, 9, 1)}, 0.0625, {0, 0, 0.0625});
        run.params.model = model;
        run.params.sliding_friction = 0.5;
        run.params.gravity = {1.75, 0, -9.5};
        run.step(2.0);
        QVERIFY(std::abs(run.state.position.x - 0.5 * 5.0 / 7.0 * 1.75 * 4.0) <= 4.0 * kU);
        QVERIFY(std::abs(std::pow(run.state.velocity.x, 2) - 10.0 / 7.0 * 1.75 * run.state.position.x) <= 16.0 * kU);
    }
}

void ExactTheorems::smallFaultsBreakThem() {
    QVERIFY(changeOfAreas(Fault::turnedNormal) > 1e-7);
    QVERIFY(changeAlongTheFlow(Fault::turnedNormal) <= 1e-7); // without a planted fault there is none
    QVERIFY(changeAlongTheFlow(Fault::lateBounce) > 1e-7);
    const BatchMeans rate = hitRate(Fault::lostHit, 8);
    QVERIFY(!rate.agreesWith(kHitRate) || !isPrecise(rate));
}

QTEST_GUILESS_MAIN(ExactTheorems)
#include "tst_exact_theorems.moc"
