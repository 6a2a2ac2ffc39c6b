// SPDX-License-Identifier: MIT
// The ghost on the simulation's thread, in a session, and in a table: present on request, and otherwise without a
// trace.
#include "core/pilot/autopilot.h"
#include "core/session/row_settings.h"
#include "core/session/session.h"
#include "core/setup/settings_file.h"
#include "inspector/core/scenes.h"
#include "inspector/program/headless_run.h"
#include "inspector/stepping.h"
#include "support/compare.h"
#include "support/files.h"

#include <QDeadlineTimer>
#include <QTemporaryDir>
#include <QThread>

#include <cmath>

using namespace inspector;

class TestComparison : public QObject {
    Q_OBJECT

private slots:
    void init();
    void threadGivesTheSameBitsAsStepsByHand();
    void samplesBeforeAndAfterHaveNoGhost();
    void comparisonsComeAndGoWhileStepsRun();
    void recordingIsTheSameWithAndWithout();
    void restartBringsThemTogether();
    void stateSetBackBringsThemTogether();
    void meetAgainBringsThemTogether();
    void bandIsOfTheRunThatIsTakenOverWhereTheyMet();
    void otherGhostMeetsTheBall();
    void otherStepperOfTheBallGoesOn();
    void otherLevelIsComparedFromItsStart();
    void optionSwitchesItOn();
    void ownParametersBeginAsTheBalls();
    void ownParametersAreKeptWhileTheyDontCount();
    void ghostsThatNoSampleNamesAreForgotten();
    void refusedStepIsSaidOnceAndTheBallGoesOn();
    void refusedSceneIsSaidAndMeetingTriesAgain();
    void tableHasItsColumnsLast();
    void fileBesideTheTableNamesTheGhost();
    void fileHasAGhostsOwnParametersWithTheirUnits();
    void tableOfOtherParametersIsThatOfARunWithThem();
    void tableOfTheSameStepperHasZeros();
    void tableWithoutAGhostIsAsBefore();
    void refusedRunHasEmptyFieldsAndStatus1();
    void sceneThatIsRefusedGivesOneLineAndStatus2();

private:
    std::unique_ptr<Session> open(const Options &options);
    QString path(const QString &name) const { return m_folder->filePath(name); }
    QString mazeOf(const QByteArray &boxes);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<QSettings> m_settings;
};

namespace {

const QByteArray kFloor = "box -0.1 -0.1 -0.01 0.05 0.1 0\n";
// So long that the ball gets too fast for an Euler scheme's substeps, with a wall that it must not miss.
const QByteArray kLongFloor = "box -0.1 -0.1 -0.01 1e5 0.1 0\nbox 99999 -0.1 0 1e5 0.1 0.02\n";

Options optionsOf(int level) {
    Options options;
    options.registry = makeRegistry(nullptr);
    options.levels = levelsIn(LEVELS_FOLDER);
    options.level = options.levels.at(size_t(level) - 1);
    options.speed = Simulation::kFastest;
    options.settings = {{"tilt_x", 3.0}, {"tilt_y", 4.0}};
    return options;
}

void makeSteps(Session &session, uint64_t count) {
    const uint64_t end = session.simulation().latest().current.step + count;
    for (uint64_t i = 0; i < count; ++i) session.simulation().stepOnce();
    QTRY_COMPARE(session.simulation().latest().current.step, end);
}

double distanceIn(Session &session) {
    const Snapshot now = session.simulation().latest();
    return now.ghost ? now.ghost->deviation.distance : std::nan("");
}

Band showBand(Session &session) {
    LiveUncertainty &uncertainty = session.liveUncertainty();
    Simulation &simulation = session.simulation();
    uncertainty.follow(simulation.latest(), simulation.samples(), session.scene(), session.lookAhead().unknowns());
    uncertainty.finish();
    return *uncertainty.band();
}

bool isTogether(Session &session) {
    const Snapshot now = session.simulation().latest();
    return now.ghost && support::sameBits(now.ghost->current, now.current);
}

QByteArray versionOf(const char *stepper) {
    phys_stepper_info info;
    phys_registry_find(nullptr, stepper, &info, nullptr);
    return info.version;
}

// Collects what signals of any thread bring, received in this thread's event loop.
template<typename Sender>
class Lines {
public:
    Lines(Sender &sender, void (Sender::*signal)(const QString &)) {
        QObject::connect(&sender, signal, &m_here, [this](const QString &line) { m_lines.append(line); });
    }
    qsizetype count() const { return m_lines.size(); }
    QString operator[](qsizetype i) const { return m_lines[i]; }

private:
    QObject m_here;
    QStringList m_lines;
};

} // namespace

void TestComparison::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_settings = std::make_unique<QSettings>(path("settings.ini"), settingsFormat());
}

std::unique_ptr<Session> TestComparison::open(const Options &options) {
    QString error;
    auto session = Session::open(options, *m_settings, &error);
    if (!session) qFatal("%s", qPrintable(error));
    return session;
}

QString TestComparison::mazeOf(const QByteArray &boxes) {
    QFile file(path("maze.txt"));
    if (!file.open(QIODevice::WriteOnly)) qFatal("%s", qPrintable(file.errorString()));
    file.write("physics-maze 1\nunits m\nball 0.006\nstart 0 0 0.006\n" + boxes);
    return file.fileName();
}

void TestComparison::threadGivesTheSameBitsAsStepsByHand() {
    Options options = optionsOf(4);
    options.comparison = GhostChoice{"exact", 2};
    options.autopilot = true;
    const auto session = open(options);
    const uint64_t steps = 250; // the ball is still in the maze then
    makeSteps(*session, steps);
    QCOMPARE(session->simulation().samples().last(), steps);

    const Scene scene = levelScene(4);
    Engine ball(scene, defaultStepper(scene));
    ball.setPilot(Autopilot::create(scene.get(), nullptr));
    QString error;
    GhostEngine ghost(ball, *makeGhostSetup(options.registry, {"exact", 2}, scene, &error), PHYS_STEPPER_DEFAULT);
    for (uint64_t i = 0; i < steps; ++i) {
        QVERIFY(ball.step(&error) && ghost.follow(ball, &error));
        Sample expected = ball.sample();
        ghost.addTo(expected);
        Sample sample;
        QVERIFY(session->simulation().samples().read(i, sample));
        sample[Channel::StepTime] = expected[Channel::StepTime]; // a manual step isn't timed
        QVERIFY(support::sameBits(sample.values, expected.values));
    }
    const Snapshot now = session->simulation().latest();
    QVERIFY(now.ghost);
    QVERIFY(support::sameBits(now.ghost->current, ghost.state()));
    QVERIFY(support::sameBits(now.ghost->previous, ghost.previous()));
    QVERIFY(now.ghost->deviation.distance > 0.0);
}

void TestComparison::samplesBeforeAndAfterHaveNoGhost() {
    const auto session = open(optionsOf(1));
    makeSteps(*session, 10);
    session->comparison().setOn(true);
    makeSteps(*session, 10);
    session->comparison().setOn(false);
    makeSteps(*session, 10);
    Sample sample;
    for (uint64_t i = 0; i < 30; ++i) {
        QVERIFY(session->simulation().samples().read(i, sample));
        for (size_t channel = kBallChannelCount; channel < kTableChannelCount; ++channel)
            QCOMPARE(std::isnan(sample.values[channel]), i < 10 || i >= 20);
    }
    QVERIFY(!session->simulation().latest().ghost);
}

// Under the thread sanitizer this also shows that there is no data race.
void TestComparison::comparisonsComeAndGoWhileStepsRun() {
    const auto session = open(optionsOf(3));
    Simulation &simulation = session->simulation();
    chooseDt(*session, 0.001);
    simulation.run();
    bool wasThere = false;
    const QDeadlineTimer deadline(30000);
    for (int i = 0; !deadline.hasExpired() && (i < 100 || !wasThere); ++i) {
        session->comparison().setOn(i % 3 != 0);
        session->comparison().setGhostChoice({i % 2 ? "exact" : "rk4", 1 + i % 3});
        if (i % 5 == 0) session->comparison().meetAgain();
        const uint64_t end = simulation.samples().last() + 5;
        while (simulation.samples().last() < end && !deadline.hasExpired()) {
            wasThere = wasThere || simulation.latest().ghost;
            simulation.samples().columns(Channel::Distance, 0.0, 10.0, 50);
            QThread::yieldCurrentThread();
        }
    }
    QVERIFY(wasThere);
    simulation.pause();
    QTRY_VERIFY(!simulation.latest().running);
    const phys_state reached = simulation.latest().current;
    const auto alone = engineOn(levelScene(3));
    alone->setDt(0.001);
    alone->setInputs(tilted(3.0, 4.0));
    while (alone->state().step < reached.step) QVERIFY(alone->step(nullptr));
    QVERIFY(support::sameBits(alone->state(), reached));
}

void TestComparison::recordingIsTheSameWithAndWithout() {
    QByteArrayList recordings;
    for (const char *name : {"with.rec", "without.rec"}) {
        Options options = optionsOf(5);
        options.settings.clear();
        options.autopilot = true;
        options.record = path(name);
        if (recordings.isEmpty()) options.comparison = GhostChoice{"exact", 3};
        const auto session = open(options);
        makeSteps(*session, 200);
        chooseStepper(*session, "rk4");
        session->comparison().meetAgain();
        makeSteps(*session, 50);
        QCOMPARE(bool(session->simulation().latest().ghost), recordings.isEmpty());
        session->stopRecording();
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray text;
        const auto isWhole = [&] {
            file.seek(0);
            text = file.readAll();
            return text.endsWith("end\n");
        };
        QTRY_VERIFY(isWhole());
        recordings.append(text);
    }
    QVERIFY(recordings[0].count('\n') > 250);
    QCOMPARE(recordings[0], recordings[1]);
}

void TestComparison::restartBringsThemTogether() {
    Options options = optionsOf(3);
    options.comparison = GhostChoice{};
    const auto session = open(options);
    makeSteps(*session, 20);
    QVERIFY(distanceIn(*session) > 0.0);
    session->simulation().restart();
    QTRY_COMPARE(session->simulation().latest().run, 1u);
    QVERIFY(isTogether(*session));
    COMPARE_EXACT(distanceIn(*session), 0.0);
    COMPARE_EXACT(session->simulation().latest().ghost->met.time, 0.0);
}

void TestComparison::stateSetBackBringsThemTogether() {
    Options options = optionsOf(3);
    options.comparison = GhostChoice{};
    const auto session = open(options);
    makeSteps(*session, 20);
    const phys_state kept = session->simulation().latest().current;
    makeSteps(*session, 20);
    session->simulation().setState(kept);
    QTRY_COMPARE(session->simulation().latest().run, 1u);
    QVERIFY(isTogether(*session));
    COMPARE_EXACT(session->simulation().latest().ghost->met.time, 0.2);
}

void TestComparison::meetAgainBringsThemTogether() {
    Options options = optionsOf(3);
    options.comparison = GhostChoice{};
    const auto session = open(options);
    makeSteps(*session, 20);
    const Snapshot then = session->simulation().latest();
    const uint64_t before = phys_state_hash(&then.current);
    session->comparison().meetAgain();
    QTRY_VERIFY(isTogether(*session));
    const Snapshot now = session->simulation().latest();
    QCOMPARE(phys_state_hash(&now.current), before);
    makeSteps(*session, 1);
    QVERIFY(distanceIn(*session) > 0.0);
}

// Both runs begin with the same state.
void TestComparison::bandIsOfTheRunThatIsTakenOverWhereTheyMet() {
    Options options = optionsOf(4);
    options.comparison = GhostChoice{};
    const auto session = open(options);
    makeSteps(*session, 60);
    showBand(*session);
    session->lookAtTime(0.0);
    session->awaitMoment();
    session->parameters().set({{"tilt_x", 0.0}});
    QTRY_VERIFY(session->simulation().latest().replay.number == 0);
    makeSteps(*session, 30);
    COMPARE_WITHIN(showBand(*session).times.back(), 0.3, 1e-9);
}

void TestComparison::otherGhostMeetsTheBall() {
    const auto session = open(optionsOf(3));
    session->comparison().setGhostChoice({"explicit-euler", 1});
    session->comparison().setOn(true);
    makeSteps(*session, 20);
    QVERIFY(distanceIn(*session) > 0.0);
    session->comparison().setGhostChoice({"symplectic-euler", 1}); // which the ball has as well
    makeSteps(*session, 20);
    QVERIFY(isTogether(*session));
    session->comparison().setGhostChoice({"symplectic-euler", 2});
    makeSteps(*session, 20);
    QVERIFY(distanceIn(*session) > 0.0);
}

void TestComparison::otherStepperOfTheBallGoesOn() {
    Options options = optionsOf(3);
    options.comparison = GhostChoice{"symplectic-euler", 1};
    const auto session = open(options);
    makeSteps(*session, 20);
    QVERIFY(isTogether(*session));
    QVERIFY(chooseStepper(*session, "exact"));
    makeSteps(*session, 20);
    QVERIFY(distanceIn(*session) > 0.0);
    COMPARE_EXACT(session->simulation().latest().ghost->met.time, 0.0);
}

void TestComparison::otherLevelIsComparedFromItsStart() {
    Options options = optionsOf(3);
    options.comparison = GhostChoice{};
    const auto session = open(options);
    makeSteps(*session, 20);
    QVERIFY(session->openLevel(session->levels().listed().at(6)));
    QTRY_VERIFY(isTogether(*session) && session->simulation().latest().run == 1);
    phys_state start;
    phys_scene_start(session->scene().get(), &start);
    QVERIFY(support::sameBits(session->simulation().latest().ghost->current, start));
}

void TestComparison::optionSwitchesItOn() {
    Options options = optionsOf(1);
    options.comparison = GhostChoice{"rk4", 10};
    const auto session = open(options);
    QVERIFY(session->comparison().isOn());
    QCOMPARE(session->comparison().ghostChoice(), *options.comparison);
    QTRY_VERIFY(session->simulation().latest().ghost);
    QVERIFY(!open(optionsOf(1))->comparison().isOn());
}

// Each value that a slider goes through makes another ghost.
void TestComparison::ghostsThatNoSampleNamesAreForgotten() {
    Options options = optionsOf(1);
    options.comparison = GhostChoice{};
    const auto session = open(options);
    Comparison &comparison = session->comparison();
    comparison.setOwnParameters(true);
    makeSteps(*session, 5);
    const uint64_t seen = session->simulation().latest().ghost->number;
    uint64_t newest = seen;
    for (int drag = 0; drag < 4; ++drag) {
        for (int place = 0; place < 500; ++place, ++newest)
            QVERIFY(comparison.parameters().set({{"restitution_wall", 0.1 + 0.001 * place}}));
        QTRY_COMPARE(session->simulation().latest().ghost->number, newest);
    }
    QVERIFY(comparison.made(seen));
    QVERIFY(!comparison.made(seen + 1));
    QVERIFY(comparison.made(newest));
}

void TestComparison::refusedStepIsSaidOnceAndTheBallGoesOn() {
    Options options = optionsOf(1);
    options.level = levelOfFile(mazeOf(kLongFloor));
    options.settings = {{"tilt_x", 30.0}};
    options.stepper = "exact";
    options.dt = 10.0;
    const auto alone = open(options);
    makeSteps(*alone, 15);
    options.comparison = GhostChoice{"symplectic-euler", 1};
    const auto session = open(options);
    Lines refused(session->comparison(), &Comparison::refused);
    Lines failed(*session, &Session::failed);
    makeSteps(*session, 5);
    QVERIFY(session->simulation().latest().ghost);
    QVERIFY(session->comparison().refusal().isEmpty());
    makeSteps(*session, 10);
    QVERIFY(!session->simulation().latest().ghost);
    QTRY_COMPARE(refused.count(), 1);
    QVERIFY2(refused[0].startsWith("comparison with Symplectic Euler: this step needs "), qPrintable(refused[0]));
    QCOMPARE(session->comparison().refusal(), refused[0]);
    QVERIFY(session->comparison().isOn());
    QCOMPARE(failed.count(), 0);
    QVERIFY(support::sameBits(session->simulation().latest().current, alone->simulation().latest().current));

    session->simulation().restart();
    QTRY_VERIFY(isTogether(*session));
    makeSteps(*session, 5);
    QVERIFY(session->simulation().latest().ghost);
}

void TestComparison::refusedSceneIsSaidAndMeetingTriesAgain() {
    Options options = optionsOf(1);
    QString error;
    QVERIFY2(loadPlugin(options.registry, MISBEHAVING, &error), qPrintable(error));
    options.comparison = GhostChoice{"wants-walls", 1};
    const auto session = open(options);
    Lines refused(session->comparison(), &Comparison::refused);
    QVERIFY(session->openLevel(levelOfFile(mazeOf(kFloor))));
    QCOMPARE(refused.count(), 1);
    QVERIFY2(refused[0].startsWith("comparison with wants-walls: a floor without walls"), qPrintable(refused[0]));
    makeSteps(*session, 5);
    QVERIFY(!session->simulation().latest().ghost);
    session->comparison().meetAgain();
    QCOMPARE(refused.count(), 2);
    session->comparison().setGhostChoice({"rk4", 1});
    QVERIFY(session->comparison().refusal().isEmpty());
    QTRY_VERIFY(isTogether(*session));
}

void TestComparison::tableHasItsColumnsLast() {
    const QStringList words{"--headless", "--duration", "0.5", "--tilt-x", "3"};
    const Result with = runOf(words + QStringList{"--compare", "rk4", "--compare-substeps", "2"});
    const Result without = runOf(words);
    QCOMPARE(with.status, 0);
    QVERIFY2(with.out.startsWith("time [s],"), with.out.constData());
    QVERIFY(with.out.contains(",flags,ghost_x [m],ghost_y [m],ghost_z [m],distance [m],speed_difference [m/s],"
                              "energy_difference [J/kg]\n"));
    QVERIFY2(with.messages.contains("\ndistance to rk4: "), qPrintable(with.messages));
    QCOMPARE(with.rows().size(), without.rows().size());
    for (qsizetype i = 0; i < with.rows().size(); ++i) {
        const QByteArrayList fields = with.rows()[i].split(',');
        QCOMPARE(size_t(fields.size()), 2 + kTableChannelCount);
        QCOMPARE(fields.mid(0, 2 + kBallChannelCount).join(','), without.rows()[i]);
        const double x = fields[2].toDouble() - fields[2 + kBallChannelCount].toDouble();
        // Along x alone: the rounding of one difference.
        COMPARE_WITHIN(fields[2 + qsizetype(Channel::Distance)].toDouble(), std::abs(x), 1e-17);
    }
    QVERIFY(with.rows().last().split(',')[2 + qsizetype(Channel::Distance)].toDouble() > 0.0);
}

void TestComparison::fileBesideTheTableNamesTheGhost() {
    runOf({"--headless", "--duration", "0.1", "--compare", "rk4", "--compare-substeps", "2", "--csv", path("t.csv")});
    const QByteArray settings = support::contentOf(path("t.csv.txt"));
    QVERIFY2(settings.contains("\ncompare rk4 " + versionOf("rk4") + "\ncompare-substeps 2\n"), settings.constData());
}

// As those of the ball, and without the tilt, which is the ball's.
void TestComparison::fileHasAGhostsOwnParametersWithTheirUnits() {
    const std::unique_ptr<Session> session = open(optionsOf(3));
    session->parameters().set({{"tilt_x", 3.0}});
    session->comparison().start({"symplectic-euler", 1});
    session->comparison().setOwnParameters(true);
    makeSteps(*session, 10);
    const QByteArray settings = rowSettings(*session, 0.0);
    QVERIFY2(settings.contains("\ncompare-set gravity 9.81 m/s^2\n"), settings.constData());
    QVERIFY2(settings.contains("\ncompare-set model rolling\n"), settings.constData());
    QVERIFY2(!settings.contains("compare-set tilt"), settings.constData());
}

// The ghost's position is, digit by digit, that of a ball with these parameters.
void TestComparison::tableOfOtherParametersIsThatOfARunWithThem() {
    const QStringList words{"--headless", "--level", "3", "--tilt-x", "3", "--tilt-y", "4", "--duration", "1"};
    const Result with = runOf(words + QStringList{"--compare", "symplectic-euler", "--compare-set",
                                                  "restitution-wall=0.8, rolling_friction=0.004"});
    const Result alone = runOf(words + QStringList{"--restitution-wall", "0.8", "--rolling-friction", "0.004"});
    QCOMPARE(with.rows().size(), alone.rows().size());
    for (qsizetype i = 1; i < with.rows().size(); ++i) {
        const QByteArrayList fields = with.rows()[i].split(',');
        const QByteArrayList expected = alone.rows()[i].split(',');
        QCOMPARE(fields[2 + qsizetype(Channel::GhostX)], expected[2 + qsizetype(Channel::PositionX)]);
        QCOMPARE(fields[2 + qsizetype(Channel::GhostY)], expected[2 + qsizetype(Channel::PositionY)]);
    }
    QVERIFY(with.rows().last().split(',')[2 + qsizetype(Channel::Distance)].toDouble() > 0.0);
}

void TestComparison::ownParametersBeginAsTheBalls() {
    const std::unique_ptr<Session> session = open(optionsOf(3));
    session->parameters().set({{"restitution_wall", 0.7}});
    session->comparison().start({"symplectic-euler", 1});
    session->comparison().setOwnParameters(true);
    makeSteps(*session, 40);
    COMPARE_EXACT(distanceIn(*session), 0.0);
    session->parameters().set({{"restitution_wall", 0.2}}); // from now on they are its own
    const Parameters &own = session->comparison().parameters();
    COMPARE_EXACT(own.value(own.indexOf("restitution_wall")), 0.7);
}

void TestComparison::ownParametersAreKeptWhileTheyDontCount() {
    const std::unique_ptr<Session> session = open(optionsOf(3));
    Comparison &comparison = session->comparison();
    comparison.start({"symplectic-euler", 1});
    comparison.setOwnParameters(true);
    comparison.parameters().set({{"rolling_friction", 0.01}});
    comparison.setOwnParameters(false);
    makeSteps(*session, 20);
    COMPARE_EXACT(distanceIn(*session), 0.0);
    comparison.setOwnParameters(true);
    makeSteps(*session, 20);
    QVERIFY(distanceIn(*session) > 0.0);
    COMPARE_EXACT(comparison.parameters().value(comparison.parameters().indexOf("rolling_friction")), 0.01);
}

void TestComparison::tableOfTheSameStepperHasZeros() {
    const Result result = runOf({"--headless", "--autopilot", "--as-reported", "1", "--compare", "symplectic-euler"});
    QCOMPARE(result.status, 0);
    for (const QByteArray &row : result.rows()) QVERIFY2(row.endsWith(", 0, 0, 0"), row.constData());
}

void TestComparison::tableWithoutAGhostIsAsBefore() {
    const Result result = runOf({"--headless", "--duration", "0.1"});
    QVERIFY(!result.out.contains("ghost") && !result.out.contains("compare") && !result.messages.contains("distance"));
}

void TestComparison::refusedRunHasEmptyFieldsAndStatus1() {
    const Result result = runOf({"--headless", "--level", mazeOf(kLongFloor), "--stepper", "exact", "--tilt-x", "30",
                                 "--dt", "10", "--duration", "150", "--compare", "symplectic-euler"});
    QCOMPARE(result.status, 1);
    static const QRegularExpression kRefusal("physics-inspector: --compare: at [0-9]+ s: this step needs ");
    QVERIFY2(result.messages.contains(kRefusal), qPrintable(result.messages));
    QCOMPARE(result.rows().size(), 15);
    QVERIFY(!result.rows().first().endsWith(','));
    QVERIFY2(result.rows().last().endsWith(",,,,,,"), result.rows().last().constData());
}

void TestComparison::sceneThatIsRefusedGivesOneLineAndStatus2() {
    const Result result =
        runOf({"--headless", "--level", mazeOf(kFloor), "--plugin", MISBEHAVING, "--compare", "wants-walls"});
    QCOMPARE(result.status, 2);
    QVERIFY(result.out.isEmpty());
    QVERIFY2(result.messages.startsWith("physics-inspector: --compare: a floor without walls"),
             qPrintable(result.messages));
    QCOMPARE(result.messages.count('\n'), 1);
}

QTEST_GUILESS_MAIN(TestComparison)
#include "tst_comparison.moc"
