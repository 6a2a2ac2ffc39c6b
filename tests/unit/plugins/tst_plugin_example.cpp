// SPDX-License-Identifier: MIT
// The example's stepper compared with closed forms: it is as accurate as it claims.
#include <QTest>

#include <physics/physics.h>

#include <array>
#include <cmath>
#include <vector>

namespace {

constexpr double kExampleRadius = 0.25;
constexpr double kTolerance = 1e-9; // of a substep, m

/// A floor, and further boxes of a test.
std::vector<phys_box> withFloor(std::initializer_list<phys_box> others = {}) {
    std::vector<phys_box> boxes{{{-100, -100, -1}, {100, 100, 0}}};
    boxes.insert(boxes.end(), others);
    return boxes;
}

struct ExampleOutcome {
    phys_state state{};
    phys_report report{};
    std::array<phys_event, 64> events{};
};

/// Each substep h may be off by the tolerance in position and by tolerance / h in speed; n of them make up dt.
double allowedSpeed(const ExampleOutcome &outcome, double dt) {
    const double n = outcome.report.substeps;
    return n * (kTolerance * n / dt);
}
double allowedWay(const ExampleOutcome &outcome, double dt) { return allowedSpeed(outcome, dt) * dt; }

} // namespace

class PluginExample : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void init();
    void cleanup();

    void isListedWithItsRows();
    void startsUnderDragAsTheHyperbolicTangent();
    void slowsDownUnderResistanceAndDragAsTheTangent();
    void fallsUnderDragAsTheHyperbolicTangent();
    void restsWhereResistanceHoldsIt();
    void bouncesOffAWallAtItsTime();
    void neverEntersAWallByMoreThanItsTolerance();
    void energyBalances();
    void aTurnedBallKeepsAUnitOrientation();
    void theRigidModelIsRefused();

private:
    void setScene(const std::vector<phys_box> &boxes, const phys_vec3 &start);
    void run(double dt, ExampleOutcome &outcome);

    phys_registry *m_registry = nullptr;
    phys_scene *m_scene = nullptr;
    phys_stepper *m_stepper = nullptr;
    phys_params m_params{};
    phys_state m_state{};
};

void PluginExample::initTestCase() {
    phys_error error{};
    QCOMPARE(phys_registry_create(&m_registry, &error), PHYS_OK);
    QVERIFY2(phys_registry_load_file(m_registry, FIXTURES "/example/adaptive-drag.so", &error) == PHYS_OK, error.text);
}

void PluginExample::cleanupTestCase() { phys_registry_destroy(m_registry); }

void PluginExample::init() {
    phys_stepper_info info;
    QCOMPARE(phys_registry_find(m_registry, "adaptive-drag", &info, nullptr), PHYS_OK);
    phys_params_init(&m_params, sizeof m_params);
    QCOMPARE(phys_stepper_info_init_params(&info, &m_params), PHYS_OK);
    m_params.stepper[1] = kTolerance;
    m_params.rolling_friction = 0.0;
}

void PluginExample::cleanup() {
    phys_stepper_destroy(m_stepper);
    phys_scene_destroy(m_scene);
    m_stepper = nullptr;
    m_scene = nullptr;
}

void PluginExample::setScene(const std::vector<phys_box> &boxes, const phys_vec3 &start) {
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.boxes = boxes.data();
    desc.box_count = static_cast<uint32_t>(boxes.size());
    desc.radius = kExampleRadius;
    desc.start = start;
    phys_error error{};
    QVERIFY2(phys_scene_create(&desc, &m_scene, &error) == PHYS_OK, error.text);
    QVERIFY2(phys_stepper_create(m_registry, "adaptive-drag", m_scene, &m_stepper, &error) == PHYS_OK, error.text);
    phys_scene_start(m_scene, &m_state);
}

void PluginExample::run(double dt, ExampleOutcome &outcome) {
    phys_report_init(&outcome.report, sizeof outcome.report);
    outcome.report.events = outcome.events.data();
    outcome.report.event_capacity = static_cast<uint32_t>(outcome.events.size());
    phys_error error{};
    QVERIFY2(phys_step(m_stepper, &m_params, dt, &m_state, &outcome.state, &outcome.report, &error) == PHYS_OK,
             error.text);
}

void PluginExample::isListedWithItsRows() {
    phys_stepper_info info;
    QCOMPARE(phys_registry_find(m_registry, "adaptive-drag", &info, nullptr), PHYS_OK);
    QCOMPARE(info.name, "Adaptive, with air drag");
    QCOMPARE(info.row_count, 2U);
    QCOMPARE(info.rows[0]->id, "air_drag");
    QCOMPARE(info.rows[1]->id, "substep_tolerance");
}

// v' = 5/7 (g - k v^2): v = V tanh(5/7 k V t), x = log(cosh(5/7 k V t)) / (5/7 k), V = sqrt(g / k).
void PluginExample::startsUnderDragAsTheHyperbolicTangent() {
    setScene(withFloor(), {0, 0, kExampleRadius});
    const double k = m_params.stepper[0] = 0.5;
    const double g = m_params.gravity.x = 2.0;
    ExampleOutcome outcome;
    run(1.5, outcome);
    const double limit = std::sqrt(g / k);
    const double phase = 5.0 / 7.0 * k * limit * 1.5;
    QVERIFY(std::abs(outcome.state.velocity.x - limit * std::tanh(phase)) < allowedSpeed(outcome, 1.5));
    QVERIFY(std::abs(outcome.state.position.x - std::log(std::cosh(phase)) / (5.0 / 7.0 * k)) <
            allowedWay(outcome, 1.5));
    QCOMPARE(outcome.state.position.z, kExampleRadius);
    QCOMPARE(outcome.state.spin.y, outcome.state.velocity.x / kExampleRadius);
}

// v' = -5/7 (m + k v^2): v = sqrt(m/k) tan(atan(v0 sqrt(k/m)) - 5/7 sqrt(m k) t), m = resistance's deceleration.
void PluginExample::slowsDownUnderResistanceAndDragAsTheTangent() {
    setScene(withFloor(), {0, 0, kExampleRadius});
    const double k = m_params.stepper[0] = 0.5;
    m_params.rolling_friction = 0.05;
    m_params.gravity = {0, 0, -10};
    const double m = 0.5;
    m_state.velocity = {0, 3, 0};
    ExampleOutcome outcome;
    run(1.0, outcome);
    const double expected =
        std::sqrt(m / k) * std::tan(std::atan(3.0 * std::sqrt(k / m)) - 5.0 / 7.0 * std::sqrt(m * k) * 1.0);
    QVERIFY(expected > 0.5); // still rolling
    QVERIFY(std::abs(outcome.state.velocity.y - expected) < allowedSpeed(outcome, 1.0));
}

void PluginExample::fallsUnderDragAsTheHyperbolicTangent() {
    setScene(withFloor(), {0, 0, 60});
    const double k = m_params.stepper[0] = 0.5;
    ExampleOutcome outcome;
    run(1.5, outcome);
    const double limit = std::sqrt(9.81 / k);
    const double phase = k * limit * 1.5;
    const double fallen = std::log(std::cosh(phase)) / k;
    QVERIFY(std::abs(60 - outcome.state.position.z - fallen) < allowedWay(outcome, 1.5));
    QVERIFY(outcome.state.flags & PHYS_AIRBORNE);
}

void PluginExample::restsWhereResistanceHoldsIt() {
    setScene(withFloor(), {0, 0, kExampleRadius});
    m_params.rolling_friction = 0.05;
    m_params.gravity = {0.49, 0, -10}; // a slope just below the resistance's
    ExampleOutcome outcome;
    run(1.0, outcome);
    QCOMPARE(outcome.state.position.x, 0.0);
    QCOMPARE(outcome.state.velocity.x, 0.0);
    QVERIFY(outcome.state.flags & PHYS_AT_REST);
}

void PluginExample::bouncesOffAWallAtItsTime() {
    setScene(withFloor({{{2, -5, 0}, {3, 5, 2}}}), {0, 0, kExampleRadius});
    m_params.stepper[0] = 0.0;
    m_params.restitution_wall = 0.5;
    m_params.gravity = {0, 0, -10};
    m_state.velocity = {1, 0, 0};
    ExampleOutcome outcome;
    run(3.0, outcome); // gap 2 - R = 1.75 m at 1 m/s, then back at 0.5 m/s
    QCOMPARE(outcome.report.event_count, 1U);
    QCOMPARE(outcome.events[0].kind, uint32_t(PHYS_EVENT_IMPACT));
    QCOMPARE(outcome.events[0].box, 1U);
    QCOMPARE(outcome.events[0].speed_before, -1.0);
    QCOMPARE(outcome.events[0].speed_after, 0.5);
    QVERIFY(std::abs(outcome.events[0].time - 1.75) <= 2 * kTolerance); // contacts count from twice the tolerance
    QVERIFY(std::abs(outcome.state.position.x - (1.75 - 0.5 * 1.25)) <= 4 * kTolerance);
    QCOMPARE(outcome.state.velocity.x, -0.5);
}

void PluginExample::neverEntersAWallByMoreThanItsTolerance() {
    const double thin = 1e-3;
    setScene(withFloor({{{2, -5, 0}, {2 + thin, 5, 2}}, {{-3, 3, 0}, {2, 4, 2}}}), {0, 0, kExampleRadius});
    m_params.gravity = {3, 2, -9};
    m_params.restitution_wall = 0.7;
    ExampleOutcome outcome;
    for (int i = 0; i < 200; ++i) { // bounces, leans on one wall, then on both
        run(0.05, outcome);
        QVERIFY(outcome.report.penetration <= kTolerance);
        QVERIFY(outcome.state.position.x <= 2 - kExampleRadius + kTolerance);
        QVERIFY(outcome.state.position.y <= 3 - kExampleRadius + kTolerance);
        m_state = outcome.state;
    }
    QVERIFY(std::abs(m_state.position.x - (2 - kExampleRadius)) <= 3 * kTolerance);
    QVERIFY(std::abs(m_state.position.y - (3 - kExampleRadius)) <= 3 * kTolerance);
    QCOMPARE(m_state.velocity.x, 0.0);
    QCOMPARE(m_state.velocity.y, 0.0);
}

void PluginExample::energyBalances() {
    setScene(withFloor({{{2, -5, 0}, {3, 5, 2}}}), {0, 0, kExampleRadius});
    m_params.gravity = {3, 1, -9};
    m_params.rolling_friction = 0.02;
    ExampleOutcome outcome;
    run(2.0, outcome);
    QVERIFY(outcome.report.lost_impact > 0.0);
    QVERIFY(outcome.report.lost_rolling > 0.0);
    // The substeps' errors: in speed times speed (below 5 m/s), in position times gravity (below 10 m/s^2).
    const double allowed = 1.4 * 5 * allowedSpeed(outcome, 2.0) + 10 * allowedWay(outcome, 2.0);
    QVERIFY2(std::abs(outcome.report.energy_scheme) <= allowed,
             qPrintable(QString::number(outcome.report.energy_scheme)));
}

void PluginExample::aTurnedBallKeepsAUnitOrientation() {
    setScene(withFloor(), {0, 0, kExampleRadius});
    m_params.options = PHYS_OPTION_ORIENTATION;
    m_params.gravity = {1, 0, -9};
    ExampleOutcome outcome;
    run(0.1, outcome);
    // Turned about y by the distance rolled over the radius; the mean spin of a constant acceleration is exact.
    const double angle = outcome.state.position.x / kExampleRadius;
    const double *q = outcome.state.orientation;
    QVERIFY(std::abs(2.0 * std::atan2(q[1], q[3]) - angle) < angle * angle); // first order in the angle
    QCOMPARE(q[0], 0.0);
    QVERIFY(std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1.0) < 1e-15);
}

void PluginExample::theRigidModelIsRefused() {
    setScene(withFloor(), {0, 0, kExampleRadius});
    m_params.model = PHYS_MODEL_RIGID;
    phys_error error{};
    phys_state out{};
    QCOMPARE(phys_step(m_stepper, &m_params, 0.1, &m_state, &out, nullptr, &error), PHYS_ERROR_UNSUPPORTED);
    QCOMPARE(error.text, "stepper 'adaptive-drag' knows the rolling model only; model is 1");
}

QTEST_GUILESS_MAIN(PluginExample)
#include "tst_plugin_example.moc"
