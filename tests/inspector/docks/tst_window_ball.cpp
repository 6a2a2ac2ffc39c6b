// SPDX-License-Identifier: MIT
// The ball moved by the user: dragged, pulled, typed, and the path that it takes from there.
#include "gl/view/maze_view.h"
#include "ui/parts/number_box.h"
#include "window_fixture.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>

#include <array>
#include <cmath>

using namespace window_test;
using inspector::ui::NumberBox;

class TestWindowBall : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void recordedBallSaysWhenItCanBeSet();
    void draggedBallIsWhereTheMouseIs();
    void ballDraggedIntoAWallStaysOutside();
    void ballDraggedOutOfTheViewStaysInIt();
    void draggedBallIsUndone();
    void undoGoesOnWithTheRun_data();
    void undoGoesOnWithTheRun();
    void undoSaysWhereTheGhostIs();
    void placingIsNotUndoneInAnotherMaze();
    void dragWithCtrlPullsTheVelocity();
    void rollingBallIsNotTaken();
    void typedNumbersAreTheBalls_data();
    void typedNumbersAreTheBalls();
    void selectionStaysWhileTheBallStands();
    void typingReplacesTheNumberOfADockJustOpened();
    void longNumberIsExactInItsBoxAndShortElsewhere();
    void ballOutsideOfTheBoardIsTold();
    void ballInAWallIsTold();
    void ballInTheAirIsNotAtRest();
    void ballPutBackIntoTheMazeLeavesItAgain();
    void restartBringsItToItsOwnStart();
    void gameStartsWhereTheBallWasPut();
    void gameStartsWhereTheBallWasPutInAPausedRun();
    void ballPutBackStartsAnOrdinaryGame();
    void placedBallSetsNoBestTime();
    void ballPlacedAtOnceAfterRunStandsStill();
    void wayAheadFollowsASlider();
    void wayAheadCanBeSwitchedOff();
    void pictureShowsTheWayAheadOfItsMoment();
    void unknownsFanOutWhileItStands();
    void unknownsDontFanOutWhileItRuns();

private:
    phys_state ball() { return m_fixture->simulation().latest().current; }
    QPoint pixelOf(double x, double y) {
        return m_fixture->window().view().positionOf({x, y, ball().position.z}).toPoint();
    }
    size_t otherWays() {
        m_fixture->window().refresh();
        return m_fixture->session().lookAhead().way().others.size();
    }
    void dragBall(double dx, double dy, Qt::KeyboardModifiers modifiers = {});
    void placeBall(double dx, double dy, Qt::KeyboardModifiers modifiers = {});
    QString noteAt(const QString &x);
};

namespace {
uint64_t hashOf(const phys_state &state) { return phys_state_hash(&state); }
} // namespace

void TestWindowBall::init() { QVERIFY(open(1, solidIn({"draggedBallIsWhereTheMouseIs"}))); }

// Drags by this many metres on the board.
void TestWindowBall::dragBall(double dx, double dy, Qt::KeyboardModifiers modifiers) {
    const phys_vec3 from = ball().position;
    drag(&m_fixture->window().view(), pixelOf(from.x, from.y), pixelOf(from.x + dx, from.y + dy), modifiers);
}

// The same, waiting until the last position on the way has arrived; each is a run of its own.
void TestWindowBall::placeBall(double dx, double dy, Qt::KeyboardModifiers modifiers) {
    const uint64_t run = m_fixture->simulation().latest().run;
    dragBall(dx, dy, modifiers);
    QTRY_COMPARE(m_fixture->simulation().latest().run, run + 2); // half way, and there
}

// The message for a ball whose x was typed like this.
QString TestWindowBall::noteAt(const QString &x) {
    if (!m_fixture->find<NumberBox>("ball_x")->isVisible()) m_fixture->trigger("show_ball_dock");
    m_fixture->window().refresh();
    auto *box = m_fixture->find<NumberBox>("ball_x");
    const uint64_t run = m_fixture->simulation().latest().run;
    box->setFocus();
    m_fixture->key(Qt::Key_A, Qt::ControlModifier);
    m_fixture->type(x);
    m_fixture->key(Qt::Key_Return);
    if (!QTest::qWaitFor([&] { return m_fixture->simulation().latest().run > run; }, kPatience)) return "nothing set";
    m_fixture->window().refresh();
    return m_fixture->find<QLabel>("ball_note")->text();
}

void TestWindowBall::recordedBallSaysWhenItCanBeSet() {
    m_fixture->makeSteps(5);
    QVERIFY(m_fixture->session().saveRun(m_fixture->path("run.rec"), nullptr));
    QVERIFY(m_fixture->session().openRecording(m_fixture->path("run.rec")));
    m_fixture->trigger("show_ball_dock");
    const auto *note = m_fixture->find<QLabel>("ball_note");
    QTRY_VERIFY2(note->text().contains("going on from here (G)"), qPrintable(note->text()));
    m_fixture->simulation().pause();
    m_fixture->trigger("go_on");
    QTRY_VERIFY(m_fixture->find<NumberBox>("ball_x")->isEnabled());
}

// The start of level 1 is open towards the back.
void TestWindowBall::draggedBallIsWhereTheMouseIs() {
    const phys_vec3 from = ball().position;
    placeBall(0.0, 0.01);
    QVERIFY(std::abs(ball().position.y - from.y - 0.01) < 0.001); // a pixel is 0.3 mm
    QVERIFY(std::abs(ball().position.x - from.x) < 0.001);
    QCOMPARE(ball().position.z, from.z);
    QCOMPARE(ball().step, uint64_t(0));
}

void TestWindowBall::ballDraggedIntoAWallStaysOutside() {
    const phys_vec3 from = ball().position;
    placeBall(-0.012, 0.0);
    QVERIFY(ball().position.x != from.x);
    std::array<phys_contact, 16> contacts{};
    uint32_t count = 0;
    const phys_scene *scene = m_fixture->session().scene().get();
    const phys_vec3 centre = ball().position;
    QCOMPARE(phys_scene_contacts(scene, &centre, 0.0, contacts.data(), 16, &count), PHYS_OK);
    for (uint32_t i = 0; i < count; ++i) QVERIFY(contacts[i].gap > -1e-8);
}

// Where it can be seen and dragged again.
void TestWindowBall::ballDraggedOutOfTheViewStaysInIt() {
    auto &view = m_fixture->window().view();
    const auto place = [&] { return pixelOf(ball().position.x, ball().position.y); };
    drag(&view, place(), {view.width() + 300, view.height() / 2});
    QTRY_VERIFY(place().x() > 0.9 * view.width());
    QVERIFY2(view.rect().contains(place()), qPrintable(QString::number(place().x())));
}

void TestWindowBall::draggedBallIsUndone() {
    const phys_vec3 from = ball().position;
    placeBall(0.0, 0.01);
    const phys_vec3 to = ball().position;
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(ball().position.y, from.y);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(ball().position.y, to.y);
}

// And goes on as if the ball hadn't been touched.
void TestWindowBall::undoGoesOnWithTheRun_data() {
    QTest::addColumn<bool>("isTyped");
    QTest::newRow("dragged") << false;
    QTest::newRow("typed") << true;
}

void TestWindowBall::undoGoesOnWithTheRun() {
    QFETCH(bool, isTyped);
    m_fixture->parameters().set({{QStringLiteral("tilt_y"), 3.0}});
    m_fixture->makeSteps(20);
    const phys_state before = ball();
    isTyped ? void(noteAt("-50 mm")) : placeBall(0.0, 0.01);
    QVERIFY(ball().position.x != before.position.x || ball().position.y != before.position.y);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(hashOf(ball()), hashOf(before));
    const inspector::RunPlace run = m_fixture->session().runPlace();
    QCOMPARE(run.end - run.begin, uint64_t(20));
    QCOMPARE(m_fixture->simulation().samples().last() - m_fixture->simulation().samples().first(), uint64_t(20));
    m_fixture->makeSteps(1);
    QCOMPARE(m_fixture->session().runPlace().begin, run.begin);
    QCOMPARE(m_fixture->session().history().runs().size(), size_t(1));
    m_fixture->press(Qt::Key_Comma); // its past is there
    QTRY_COMPARE(hashOf(ball()), hashOf(before));
}

void TestWindowBall::undoSaysWhereTheGhostIs() {
    m_fixture->session().comparison().start({});
    m_fixture->makeSteps(20);
    placeBall(0.0, 0.01);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_fixture->window().statusBar()->currentMessage(),
             QString("The ball is back where it was; the ghost starts at the ball again"));
}

void TestWindowBall::placingIsNotUndoneInAnotherMaze() {
    placeBall(0.0, 0.01);
    QVERIFY(m_fixture->session().openLevel(m_fixture->session().levels().listed()[2]));
    phys_state start;
    QCOMPARE(phys_scene_start(m_fixture->session().scene().get(), &start), PHYS_OK);
    QTRY_COMPARE(ball().position.x, start.position.x);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    m_fixture->makeSteps(1);
    QVERIFY(std::abs(ball().position.x - start.position.x) < 1e-4);
}

// The arrow ends where the ball would be after 0.2 s.
void TestWindowBall::dragWithCtrlPullsTheVelocity() {
    const phys_vec3 from = ball().position;
    placeBall(0.0, 0.02, Qt::ControlModifier);
    QVERIFY(std::abs(ball().velocity.y - 0.1) < 0.005);
    QCOMPARE(ball().position.y, from.y);
    // It rolls: v = spin x R up.
    QVERIFY(std::abs(ball().velocity.y + ball().spin.x * phys_scene_radius(m_fixture->session().scene().get())) <
            1e-12);
}

void TestWindowBall::rollingBallIsNotTaken() {
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(m_fixture->simulation().latest().running);
    const uint64_t run = m_fixture->simulation().latest().run;
    dragBall(0.0, 0.01);
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    QCOMPARE(m_fixture->simulation().latest().run, run);
}

void TestWindowBall::typedNumbersAreTheBalls_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");
    QTest::newRow("position") << "ball_y"
                              << "-75 mm" << -0.075;
    QTest::newRow("velocity") << "ball_vx"
                              << "0,1" << 0.1;
    QTest::newRow("spin") << "ball_wz"
                          << "1e1" << 10.0;
}

void TestWindowBall::typedNumbersAreTheBalls() {
    QFETCH(QString, name);
    QFETCH(QString, text);
    QFETCH(double, value);
    m_fixture->trigger("show_ball_dock");
    auto *box = m_fixture->find<NumberBox>(name);
    QTRY_VERIFY(box->isEnabled());
    box->setFocus();
    box->selectAll();
    m_fixture->type(text);
    m_fixture->key(Qt::Key_Return);
    const auto now = [&] {
        if (name == "ball_y") return ball().position.y;
        return name == "ball_vx" ? ball().velocity.x : ball().spin.z;
    };
    QTRY_COMPARE(now(), value);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(now() != value);
}

void TestWindowBall::selectionStaysWhileTheBallStands() {
    m_fixture->trigger("show_ball_dock");
    auto *box = m_fixture->find<NumberBox>("ball_x");
    m_fixture->window().refresh();
    click(box);
    m_fixture->key(Qt::Key_A, Qt::ControlModifier);
    QVERIFY(box->hasSelectedText());
    m_fixture->window().refresh();
    m_fixture->type("0");
    QCOMPARE(box->text(), QString("0"));
}

// It shows the ball only after its key has selected what it showed before.
void TestWindowBall::typingReplacesTheNumberOfADockJustOpened() {
    m_fixture->press(Qt::Key_0, Qt::ControlModifier);
    QTRY_VERIFY(m_fixture->find<NumberBox>("ball_x")->hasFocus());
    m_fixture->window().refresh();
    m_fixture->type("0.01");
    m_fixture->key(Qt::Key_Return);
    QTRY_COMPARE(ball().position.x, 0.01);
}

void TestWindowBall::longNumberIsExactInItsBoxAndShortElsewhere() {
    m_fixture->trigger("show_ball_dock");
    phys_state state = ball();
    state.velocity.x = 1.0 / 3.0;
    m_fixture->session().placeBall(state);
    QTRY_COMPARE(ball().velocity.x, state.velocity.x);
    m_fixture->window().refresh();
    auto *box = m_fixture->find<NumberBox>("ball_vx");
    QCOMPARE(box->text(), QString("0.333333 m/s"));
    QCOMPARE(box->toolTip(), QString("0.3333333333333333 m/s"));
    click(box);
    QCOMPARE(box->text(), QString("0.3333333333333333 m/s"));
    m_fixture->key(Qt::Key_Tab);
    QCOMPARE(box->text(), QString("0.333333 m/s"));
    QCOMPARE(ball().velocity.x, state.velocity.x);
}

void TestWindowBall::ballOutsideOfTheBoardIsTold() {
    QCOMPARE(noteAt("5 m"), QString("There is no board below: it will fall."));
    QCOMPARE(noteAt("-54 mm"), QString("Typed here, or dragged in the view."));
}

void TestWindowBall::ballInAWallIsTold() {
    const QString note = noteAt("-66 mm");
    QVERIFY2(note.startsWith("It overlaps the board by ") && note.endsWith(" mm."), qPrintable(note));
}

// Where it was put without any velocity, also when that is looked back at, and at the top of its flight.
void TestWindowBall::ballInTheAirIsNotAtRest() {
    const auto said = [this] {
        m_fixture->window().refresh();
        return m_fixture->find<QLabel>("status_ball")->text();
    };
    m_fixture->makeSteps(3);
    QCOMPARE(said(), QString("Ball: at rest"));
    phys_state inTheAir = ball();
    inTheAir.position.z += 0.02;
    m_fixture->session().placeBall(inTheAir);
    QTRY_COMPARE(ball().position.z, inTheAir.position.z);
    QCOMPARE(said(), QString("Ball: in the air"));
    m_fixture->makeSteps(2);
    QCOMPARE(said(), QString("Ball: in the air"));
    m_fixture->key(Qt::Key_Home, Qt::ControlModifier);
    QTRY_COMPARE(ball().position.z, inTheAir.position.z);
    QCOMPARE(said(), QString("Ball: in the air"));
}

// What the step before the placing did has no effect.
void TestWindowBall::ballPutBackIntoTheMazeLeavesItAgain() {
    QSignalSpy left(&m_fixture->simulation(), &inspector::Simulation::leftMaze);
    for (int time = 1; time <= 2; ++time) {
        phys_state flying = ball(); // above the walls, and beside the board after a step
        flying.position = {0.0, 0.0, 0.2};
        flying.velocity = {30.0, 0.0, 0.0};
        m_fixture->session().placeBall(flying);
        m_fixture->makeSteps(1);
        QVERIFY(ball().flags & PHYS_OUT);
        QTRY_COMPARE(left.size(), time);
    }
}

void TestWindowBall::restartBringsItToItsOwnStart() {
    m_fixture->trigger("show_ball_dock");
    const phys_vec3 start = ball().position;
    placeBall(0.0, 0.01);
    const phys_vec3 own = ball().position;
    m_fixture->window().refresh();
    click(m_fixture->find<QPushButton>("start_here"));
    m_fixture->trigger("step");
    QTRY_COMPARE(ball().step, uint64_t(1));
    m_fixture->press(Qt::Key_R);
    QTRY_COMPARE(ball().step, uint64_t(0));
    QCOMPARE(ball().position.y, own.y);
    m_fixture->window().refresh();
    click(m_fixture->find<QPushButton>("usual_start"));
    m_fixture->press(Qt::Key_R);
    QTRY_COMPARE(ball().position.y, start.y);
}

void TestWindowBall::gameStartsWhereTheBallWasPut() {
    const auto said = [this](const QWidget *widget) {
        m_fixture->window().refresh();
        QStringList texts;
        for (const QLabel *label : widget->findChildren<QLabel *>()) texts << label->text();
        return texts.join('|');
    };
    const phys_vec3 start = ball().position;
    placeBall(0.0, 0.02);
    const phys_vec3 put = ball().position;
    const QString strip = said(m_fixture->find<QFrame>("game_strip"));
    QVERIFY2(strip.contains("Press Enter to start from here"), qPrintable(strip));
    const QString status = said(m_fixture->window().statusBar());
    QVERIFY2(status.contains("about to start"), qPrintable(status));
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(ball().step > 0);
    m_fixture->press(Qt::Key_Comma); // as far back as the run goes
    m_fixture->press(Qt::Key_Home, Qt::ControlModifier);
    QTRY_COMPARE(ball().step, uint64_t(0));
    QCOMPARE(ball().position.y, put.y);
    QVERIFY(put.y != start.y);
    QVERIFY(!m_fixture->session().whyNoBestTime().isEmpty());
}

// The game's clock begins at 0 there.
void TestWindowBall::gameStartsWhereTheBallWasPutInAPausedRun() {
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(ball().step > 3);
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    placeBall(0.0, 0.02);
    const phys_vec3 put = ball().position;
    m_fixture->window().refresh();
    QStringList texts;
    for (const QLabel *label : m_fixture->find<QFrame>("game_strip")->findChildren<QLabel *>()) texts << label->text();
    QVERIFY2(texts.join('|').contains("Enter: play from here"), qPrintable(texts.join('|')));
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().running && ball().step > 0);
    m_fixture->press(Qt::Key_Comma);
    m_fixture->press(Qt::Key_Home, Qt::ControlModifier);
    QTRY_COMPARE(ball().step, uint64_t(0));
    QCOMPARE(ball().position.y, put.y);
}

void TestWindowBall::ballPutBackStartsAnOrdinaryGame() {
    const phys_vec3 start = ball().position;
    placeBall(0.0, 0.02);
    m_fixture->press(Qt::Key_R);
    QTRY_COMPARE(ball().position.y, start.y);
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(ball().step > 0);
    QCOMPARE(m_fixture->session().whyNoBestTime(), QString());
}

void TestWindowBall::placedBallSetsNoBestTime() {
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().running);
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    const phys_state before = ball();
    placeBall(0.0, 0.005);
    QVERIFY(ball().position.y != before.position.y);
    QCOMPARE(ball().step, before.step); // the clock goes on from there
    QVERIFY(!m_fixture->session().whyNoBestTime().isEmpty());
}

// After a run that the stepping thread hasn't received yet.
void TestWindowBall::ballPlacedAtOnceAfterRunStandsStill() {
    const uint64_t run = m_fixture->simulation().latest().run;
    phys_state state = ball();
    state.position.y += 0.005;
    m_fixture->simulation().run();
    m_fixture->session().placeBall(state);
    QTRY_COMPARE(m_fixture->simulation().latest().run, run + 1);
    QVERIFY(!m_fixture->simulation().latest().running);
    QCOMPARE(ball().position.y, state.position.y);
}

void TestWindowBall::wayAheadFollowsASlider() {
    const auto endOf = [&] {
        m_fixture->window().refresh();
        const std::vector<phys_vec3> &points = m_fixture->session().lookAhead().way().points;
        return points.empty() ? ball().position.y : points.back().y;
    };
    m_fixture->press(Qt::Key_W);
    m_fixture->parameters().set({{QStringLiteral("tilt_y"), 5.0}});
    QTRY_VERIFY(endOf() > ball().position.y + 0.01);
    m_fixture->parameters().set({{QStringLiteral("tilt_y"), 0.0}});
    QTRY_COMPARE(endOf(), ball().position.y);
}

void TestWindowBall::wayAheadCanBeSwitchedOff() {
    m_fixture->press(Qt::Key_W);
    m_fixture->parameters().set({{QStringLiteral("tilt_y"), 5.0}});
    const auto size = [&] {
        m_fixture->window().refresh();
        return m_fixture->session().lookAhead().way().points.size();
    };
    QTRY_VERIFY(size() > 10);
    m_fixture->press(Qt::Key_W);
    QCOMPARE(size(), size_t(0));
}

void TestWindowBall::pictureShowsTheWayAheadOfItsMoment() {
    m_fixture->press(Qt::Key_W);
    m_fixture->parameters().set({{QStringLiteral("tilt_y"), 5.0}});
    QTRY_VERIFY(m_fixture->simulation().latest().inputs.tilt.y > 0.0);
    QVERIFY(m_fixture->window().grabTo(m_fixture->path("window.png"), nullptr));
    const std::vector<phys_vec3> &points = m_fixture->session().lookAhead().way().points;
    QVERIFY(!points.empty() && points.back().y > ball().position.y + 0.01); // without waiting for it
}

void TestWindowBall::unknownsFanOutWhileItStands() {
    m_fixture->press(Qt::Key_W);
    m_fixture->parameters().set({{QStringLiteral("tilt_y"), 5.0}});
    m_fixture->press(Qt::Key_U);
    QTRY_VERIFY(otherWays() > 0);
    m_fixture->session().lookAhead().setUnknowns({}); // nothing is unknown
    QTRY_VERIFY(otherWays() == 0 && m_fixture->session().lookAhead().way().points.size() > 10);
    m_fixture->session().lookAhead().setUnknowns({{"tilt", 0.5, false}});
    QTRY_VERIFY(otherWays() > 0);
    m_fixture->press(Qt::Key_U);
    QTRY_COMPARE(otherWays(), size_t(0));
}

void TestWindowBall::unknownsDontFanOutWhileItRuns() {
    m_fixture->press(Qt::Key_W);
    m_fixture->parameters().set({{QStringLiteral("tilt_y"), 5.0}});
    m_fixture->press(Qt::Key_U);
    QTRY_VERIFY(otherWays() > 0);
    m_fixture->press(Qt::Key_Space); // there is no comparison while it runs
    QTRY_COMPARE(otherWays(), size_t(0));
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(otherWays() > 0);
}

QTEST_MAIN(TestWindowBall)
#include "tst_window_ball.moc"
