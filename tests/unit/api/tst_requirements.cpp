// SPDX-License-Identifier: MIT
// The stages that a step needs, each with a case for and against, and its reason.
#include "support/compare.h"
#include "support/experiment.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <QTest>

#include <bit>
#include <cstring>
#include <functional>
#include <vector>

using namespace support;

namespace {

constexpr double kLongDt = 1.0 / 64.0;

/// A ball in a handful of walls whose next step needs no stage at all.
Experiment plainBall(const QByteArray &stepper) {
    Experiment ball(openFloor().wall(1, -1, 2, 1), stepper);
    ball.roll(0.25, 0.0);
    return ball;
}

struct Need {
    const char *name;
    uint32_t stage;
    const char *reason; ///< a part of it
    std::function<void(Experiment &)> change;
};

const std::vector<Need> kNeeds{
    {"off the floor", PHYS_STAGE_VERTICAL, "not on the floor", [](Experiment &b) { b.state.position.z += 0.5; }},
    {"jumping", PHYS_STAGE_VERTICAL, "not on the floor", [](Experiment &b) { b.state.velocity.z = 0.5; }},
    {"rough wall", PHYS_STAGE_VERTICAL, "rough wall",
     [](Experiment &b) {
         b.params.model = PHYS_MODEL_RIGID;
         b.params.wall_friction = 0.1;
     }},
    {"resistance", PHYS_STAGE_RESISTANCE, "rolling_friction is above 0",
     [](Experiment &b) { b.params.rolling_friction = 1e-9; }},
    {"slip", PHYS_STAGE_SLIP, "slips",
     [](Experiment &b) {
         b.params.model = PHYS_MODEL_RIGID;
         b.state.spin = {0, 0, 0};
     }},
    {"steep", PHYS_STAGE_SLIP, "too steep",
     [](Experiment &b) {
         b.params.model = PHYS_MODEL_RIGID;
         b.params.gravity.x = 3.6 * 0.3 * 8.0;
         b.state.velocity = b.state.spin = {0, 0, 0};
     }},
    {"orientation", PHYS_STAGE_ORIENTATION, "asked for",
     [](Experiment &b) { b.params.options = PHYS_OPTION_ORIENTATION; }},
};

int indexOf(uint32_t stage) { return std::countr_zero(stage); }

} // namespace

class TestRequirements : public QObject {
    Q_OBJECT

private slots:
    void plainStepNeedsNoStage_data() { addStepperRows(); }
    void plainStepNeedsNoStage();
    void stageIsNeededForAReason_data();
    void stageIsNeededForAReason();
    void rigidBallThatRollsDoesNotSlip_data() { addStepperRows(); }
    void rigidBallThatRollsDoesNotSlip();
    void fastBallNeedsSubsteps_data();
    void fastBallNeedsSubsteps();
    void asReportedNeverNeedsSubsteps_data();
    void asReportedNeverNeedsSubsteps();
    void manyBoxesNeedTheGrid_data() { addStepperRows(); }
    void manyBoxesNeedTheGrid();
    void allStagesAreForced_data() { addStepperRows(); }
    void allStagesAreForced();
    void noTimeNeedsNoStage_data() { addStepperRows(); }
    void noTimeNeedsNoStage();
    void questionChangesNothing_data() { addStepperRows(); }
    void questionChangesNothing();

private:
    /// Asks for the requirements; on failure `m_error` has the reason.
    bool ask(Experiment &ball, double dt = kLongDt) {
        return phys_stepper_requirements(ball.stepper(), &ball.params, dt, &ball.state, &m_answer, &m_error) == PHYS_OK;
    }
    QByteArray reason(uint32_t stage) const { return m_answer.reasons[indexOf(stage)]; }

    phys_requirements m_answer{};
    phys_error m_error{};
};

void TestRequirements::plainStepNeedsNoStage() {
    QFETCH(QByteArray, stepper);
    Experiment ball = plainBall(stepper);
    QVERIFY2(ask(ball), m_error.text);
    // Some steppers always find the impact inside the step; they may always run this stage.
    const uint32_t allowed = promiseOf(stepper).inSteps ? 0U : static_cast<uint32_t>(PHYS_STAGE_SUBSTEPS);
    QCOMPARE(m_answer.stages & ~allowed, 0U);
    QCOMPARE(m_answer.substeps, 1U);
    for (int i = 0; i < PHYS_STAGE_COUNT; ++i) {
        const QByteArray text = m_answer.reasons[i];
        const bool runs = m_answer.stages >> i & 1U;
        QVERIFY2(text.startsWith("not needed: ") != runs && text.size() > 20, text.constData());
    }
}

void TestRequirements::noTimeNeedsNoStage() {
    QFETCH(QByteArray, stepper);
    Experiment ball = plainBall(stepper);
    ball.params.rolling_friction = 0.01;
    ball.params.options = PHYS_OPTIONS;
    QVERIFY2(ask(ball, 0.0), m_error.text);
    QCOMPARE(m_answer.stages, 0U);
    QCOMPARE(m_answer.substeps, 0U); // as the report of that step says
    for (const char(&text)[120] : m_answer.reasons) QCOMPARE(text, "not needed: dt is 0");
}

void TestRequirements::stageIsNeededForAReason_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<int>("need");
    for (const QByteArray &id : stepperIds()) {
        for (size_t i = 0; i < kNeeds.size(); ++i) {
            QTest::addRow("%s, %s", id.constData(), kNeeds[i].name) << id << static_cast<int>(i);
        }
    }
}

void TestRequirements::stageIsNeededForAReason() {
    QFETCH(QByteArray, stepper);
    QFETCH(int, need);
    const Need &wanted = kNeeds[static_cast<size_t>(need)];
    Experiment ball = plainBall(stepper);
    wanted.change(ball);
    const bool answered = ask(ball);
    if (!answered && m_error.status == PHYS_ERROR_UNSUPPORTED) QSKIP(m_error.text);
    QVERIFY2(answered, m_error.text);
    QVERIFY2(m_answer.stages & wanted.stage, reason(wanted.stage).constData());
    const QByteArray text = reason(wanted.stage);
    QVERIFY2(text.contains(wanted.reason) && !text.startsWith("not needed"), text.constData());
}

void TestRequirements::rigidBallThatRollsDoesNotSlip() {
    QFETCH(QByteArray, stepper);
    Experiment ball = plainBall(stepper);
    ball.params.model = PHYS_MODEL_RIGID;
    QVERIFY2(ask(ball), m_error.text);
    QVERIFY(!(m_answer.stages & PHYS_STAGE_SLIP));
    QVERIFY2(reason(PHYS_STAGE_SLIP).contains("rolls"), reason(PHYS_STAGE_SLIP).constData());
}

void TestRequirements::fastBallNeedsSubsteps_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("speed");
    QTest::addColumn<uint32_t>("substeps");
    // Half a radius is safe: 1/32 m in 1/64 s, 2 m/s (model.md 10.4).
    for (const QByteArray &id : discreteStepperIds()) {
        QTest::addRow("%s, at half a radius a step", id.constData()) << id << 2.0 << 1U;
        QTest::addRow("%s, just above", id.constData()) << id << 2.0 * (1.0 + 0x1p-30) << 2U;
        QTest::addRow("%s, at 100 m/s", id.constData()) << id << 100.0 << 50U;
    }
}

void TestRequirements::fastBallNeedsSubsteps() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, speed);
    QFETCH(uint32_t, substeps);
    Experiment ball = plainBall(stepper);
    ball.roll(-speed, 0.0);
    QVERIFY2(ask(ball), m_error.text);
    QCOMPARE(m_answer.substeps, substeps);
    QCOMPARE((m_answer.stages & PHYS_STAGE_SUBSTEPS) != 0, substeps > 1);
    QCOMPARE(reason(PHYS_STAGE_SUBSTEPS).startsWith("not needed"), substeps == 1);
    QVERIFY2(ball.step(kLongDt), ball.error());
    QCOMPARE(ball.report.substeps, substeps);
    QVERIFY(ball.report.substep_cap >= substeps);
}

void TestRequirements::asReportedNeverNeedsSubsteps_data() {
    QTest::addColumn<QByteArray>("stepper");
    for (const QByteArray &id : discreteStepperIds()) QTest::newRow(id.constData()) << id;
}

void TestRequirements::asReportedNeverNeedsSubsteps() {
    QFETCH(QByteArray, stepper);
    Experiment ball = plainBall(stepper);
    ball.params.stepper[0] = 1.0;
    ball.roll(-1000.0, 0.0);
    QVERIFY2(ask(ball), m_error.text);
    QCOMPARE(m_answer.substeps, 1U);
    QVERIFY(!(m_answer.stages & PHYS_STAGE_SUBSTEPS));
}

void TestRequirements::manyBoxesNeedTheGrid() {
    QFETCH(QByteArray, stepper);
    auto scene = openFloor();
    for (int i = 0; i < 100; ++i) scene.wall(2 * i - 90, 10, 2 * i - 89, 11);
    Experiment ball(scene, stepper);
    QVERIFY2(ask(ball), m_error.text);
    QVERIFY(m_answer.stages & PHYS_STAGE_GRID);
    QVERIFY2(reason(PHYS_STAGE_GRID).contains("boxes"), reason(PHYS_STAGE_GRID).constData());
}

void TestRequirements::allStagesAreForced() {
    QFETCH(QByteArray, stepper);
    Experiment ball = plainBall(stepper);
    ball.params.options = PHYS_OPTION_ALL_STAGES;
    QVERIFY2(ask(ball), m_error.text);
    // Slip belongs to the rigid model, orientation to its own option.
    const uint32_t all = (1U << PHYS_STAGE_COUNT) - 1U;
    QCOMPARE(m_answer.stages | PHYS_STAGE_SLIP | PHYS_STAGE_ORIENTATION, all);
    QVERIFY(reason(PHYS_STAGE_RESISTANCE).contains("PHYS_OPTION_ALL_STAGES"));
}

void TestRequirements::questionChangesNothing() {
    QFETCH(QByteArray, stepper);
    Experiment asked = plainBall(stepper);
    Experiment unasked = plainBall(stepper);
    for (int i = 0; i < 200; ++i) {
        const phys_state before = asked.state;
        QVERIFY2(ask(asked), m_error.text);
        QVERIFY(sameBits(asked.state, before));
        QVERIFY2(asked.step(kLongDt) && unasked.step(kLongDt), asked.error());
        QVERIFY(sameBits(asked.state, unasked.state));
    }
}

QTEST_GUILESS_MAIN(TestRequirements)
#include "tst_requirements.moc"
