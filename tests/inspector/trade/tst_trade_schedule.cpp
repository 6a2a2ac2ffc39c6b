// SPDX-License-Identifier: MIT
// The same tilts for every stepper, and steps that end at every switch.
#include "core/schedule/trade_reference.h"
#include "core/trade/trade_options.h"
#include "inspector/core/scenes.h"

#include <QTemporaryDir>

using namespace inspector;

class TestTradeSchedule : public QObject {
    Q_OBJECT

private slots:
    void randomTiltsRepeatAndStayWithinAPlayersReach();
    void randomTiltsAreTheSameEverywhere();
    void autopilotEndsInTheMaze();
    void boardWithoutAWayOutHasTheBusyOneAlone();
    void usualStepsNeedNoCutting_data();
    void usualStepsNeedNoCutting();
    void otherStepsAreCutAtASwitch();
    void legsEndNoOftenerThanStatesAreCompared();
    void rowsOfAFileBecomeSwitches();
    void tableOfThisProgramIsASchedule();
    void wrongFilesAreOneLine_data();
    void wrongFilesAreOneLine();

private:
    QString write(const QByteArray &text);
    QTemporaryDir m_folder;
};

QString TestTradeSchedule::write(const QByteArray &text) {
    QString path = m_folder.filePath("schedule.txt");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("can't write %s", qPrintable(path));
    return path;
}

void TestTradeSchedule::randomTiltsRepeatAndStayWithinAPlayersReach() {
    const TiltSchedule first = randomSchedule(11, 5.0);
    const TiltSchedule again = randomSchedule(11, 5.0);
    QCOMPARE(first.switches.size(), size_t(10));
    for (size_t i = 0; i < first.switches.size(); ++i) {
        QVERIFY(first.switches[i].tilt == again.switches[i].tilt);
        QVERIFY(first.switches[i].time == double(i) * 0.5);
        QVERIFY(std::abs(first.switches[i].tilt.x) <= radians(kPlayTilt));
        QVERIFY(std::abs(first.switches[i].tilt.y) <= radians(kPlayTilt));
    }
    QVERIFY(!(first.switches[0].tilt == randomSchedule(12, 5.0).switches[0].tilt));
}

// The standard fixes the numbers of mt19937_64: with its default seed the 10000th is this one.
void TestTradeSchedule::randomTiltsAreTheSameEverywhere() {
    const TiltSchedule schedule = randomSchedule(5489, 2500.0); // 5000 switches of two numbers
    const double expected = radians(kPlayTilt) * (double(9981545732273789042ULL >> 11) * 0x1p-52 - 1.0);
    QVERIFY(schedule.switches.back().tilt.y == expected);
}

// A box of 0.2 m, closed all around.
void TestTradeSchedule::boardWithoutAWayOutHasTheBusyOneAlone() {
    const phys_box boxes[] = {{{-0.1, -0.1, -0.01}, {0.1, 0.1, 0.0}},
                              {{-0.1, 0.1, -0.01}, {0.1, 0.11, 0.02}},
                              {{-0.1, -0.11, -0.01}, {0.1, -0.1, 0.02}},
                              {{-0.11, -0.1, -0.01}, {-0.1, 0.1, 0.02}},
                              {{0.1, -0.1, -0.01}, {0.11, 0.1, 0.02}}};
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.boxes = boxes;
    description.box_count = 5;
    QString error;
    TradePlan plan;
    plan.registry = makeRegistry(&error);
    plan.scene = makeScene(description, &error);
    QVERIFY2(plan.scene, qPrintable(error));
    plan.inputs = initialInputs();
    QVERIFY(!makeSchedules("autopilot", 2.0, plan, &error));
    QVERIFY2(makeSchedules("both", 2.0, plan, &error), qPrintable(error));
    QCOMPARE(plan.schedules.size(), size_t(1));
    QVERIFY2(plan.schedules[0].name.startsWith("busy, random:"), qPrintable(plan.schedules[0].name));
    QVERIFY2(plan.schedules[0].name.endsWith("(the autopilot finds no way out)"), qPrintable(plan.schedules[0].name));
}

void TestTradeSchedule::autopilotEndsInTheMaze() {
    QString error;
    const Scene scene = levelScene(1);
    const TiltSchedule schedule = autopilotSchedule(makeRegistry(&error), scene, initialInputs(), 100.0, &error);
    QVERIFY2(!schedule.switches.empty(), qPrintable(error));
    QVERIFY(schedule.duration > 1.0 && schedule.duration < 100.0);
    const auto reference = TradeReference::run(makeRegistry(&error), scene, initialInputs().params,
                                               segmentsOf(schedule, initialInputs().gravity), &error);
    QVERIFY(reference.has_value());
    QVERIFY(reference->endReason().isEmpty());
}

void TestTradeSchedule::usualStepsNeedNoCutting_data() {
    QTest::addColumn<double>("dt");
    for (const double dt : usualStepSizes()) QTest::addRow("%g s", dt) << dt;
}

void TestTradeSchedule::usualStepsNeedNoCutting() {
    QFETCH(double, dt);
    TiltSchedule schedule{"", {}, 3.0};
    for (int i = 0; i < 60; ++i) schedule.switches.push_back({i * kScheduleHold, {0.01 * i, 0.0}});
    uint64_t steps = 0;
    for (const Leg &leg : legsOf(segmentsOf(schedule, 9.81), dt)) {
        QVERIFY(leg.dt == dt);
        steps += leg.steps;
    }
    QCOMPARE(steps, uint64_t(std::lround(3.0 / dt)));
}

void TestTradeSchedule::otherStepsAreCutAtASwitch() {
    const TiltSchedule schedule{"", {{0.0, {}}, {0.25, {0.1, 0.0}}}, 0.5};
    const std::vector<Leg> legs = legsOf(segmentsOf(schedule, 9.81), 0.1875);
    QCOMPARE(legs.size(), size_t(4)); // all exact in binary
    QVERIFY(legs[0].dt == 0.1875 && legs[1].dt == 0.0625 && legs[1].end == 0.25);
    QVERIFY(legs[2].segment == 1 && legs[2].dt == 0.1875 && legs[3].dt == 0.0625 && legs[3].end == 0.5);
}

void TestTradeSchedule::legsEndNoOftenerThanStatesAreCompared() {
    const TiltSchedule schedule{"", {{0.0, {}}}, 1.0};
    const std::vector<Leg> legs = legsOf(segmentsOf(schedule, 9.81), 0.001);
    QCOMPARE(legs.size(), size_t(200));
    QCOMPARE(legs[0].steps, 5U);
}

void TestTradeSchedule::rowsOfAFileBecomeSwitches() {
    QString error;
    const TiltSchedule schedule =
        readSchedule(write("# pull, then push\n0 2 -1\n\n1.5, 0, 3 # up\n9 1 1\n"), 4.0, &error);
    QVERIFY2(schedule.switches.size() == 2, qPrintable(error));
    QVERIFY(schedule.switches[0].tilt == (Tilt{radians(2), radians(-1)}));
    QVERIFY(schedule.switches[1].time == 1.5);
    QVERIFY(schedule.switches[1].tilt == (Tilt{radians(0), radians(3)}));
    QVERIFY(schedule.duration == 4.0);
}

// A row has the tilt of the step that ended at its time.
void TestTradeSchedule::tableOfThisProgramIsASchedule() {
    QString error;
    const QByteArray table = "# physics-inspector\ntime [s],step,tilt_x [deg],tilt_y [deg]\n"
                             "0.01,1,2,0\n0.02,2,2,0\n0.03,3,4,0\n";
    const TiltSchedule schedule = readSchedule(write(table), 20.0, &error);
    QVERIFY2(schedule.switches.size() == 2, qPrintable(error));
    QVERIFY(schedule.switches[0].time == 0.0);
    QVERIFY(schedule.switches[1].time == 0.02);
    QVERIFY(schedule.switches[1].tilt == (Tilt{radians(4), 0.0}));
    QVERIFY(schedule.duration == 0.03);
}

void TestTradeSchedule::wrongFilesAreOneLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("message");
    QTest::newRow("empty") << QByteArray("# nothing\n") << "expected rows of 'time tilt_x tilt_y', found none";
    QTest::newRow("late begin") << QByteArray("1 0 0\n") << ":1: expected 0 s and two tilts";
    QTest::newRow("two numbers") << QByteArray("0 1\n") << "found '0 1'";
    QTest::newRow("no number") << QByteArray("0 0 0\n1 a 0\n") << ":2: expected a later time";
    QTest::newRow("not later") << QByteArray("0 0 0\n0 1 0\n") << ":2: expected a later time";
    QTest::newRow("too steep") << QByteArray("0 90 0\n") << "within 89 degrees";
    QTest::newRow("not finite") << QByteArray("0 nan 0\n") << "found '0 nan 0'";
    QTest::newRow("table without tilts") << QByteArray("time [s],step\n0.1,1\n") << "expected the columns";
}

void TestTradeSchedule::wrongFilesAreOneLine() {
    QFETCH(QByteArray, text);
    QFETCH(QString, message);
    QString error;
    QVERIFY(readSchedule(write(text), 20.0, &error).switches.empty());
    QVERIFY2(error.contains(message) && error.contains("schedule.txt") && !error.contains('\n'), qPrintable(error));
}

QTEST_GUILESS_MAIN(TestTradeSchedule)
#include "tst_trade_schedule.moc"
