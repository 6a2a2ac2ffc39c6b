// SPDX-License-Identifier: MIT
// A ghost with its own parameters, A and B: by key, mouse and numbers; copied, swapped, undone.
#include "support/compare.h"
#include "ui/parts/number_box.h"
#include "window_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include <cmath>

#include <qcustomplot.h>

using namespace window_test;
using inspector::ui::NumberBox;

class TestWindowGhost : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void keyGivesTheGhostSlidersOfItsOwn();
    void switchInEitherDockDoesTheSame();
    void typedNumberMovesTheGhostAlone();
    void sliderOfTheGhostIsUndone();
    void copyGivesTheGhostTheBallsValues();
    void swapExchangesBothAndIsUndoneAtOnce();
    void tiltIsTheBallsAlone();
    void refusedValueIsSaidBesideTheGhostsNumber();
    void rigidRowsFollowTheGhostsModel();
    void controlsSayWhoseTheyAre();
    void otherStepperBringsItsOwnRows();
    void plotHasTheGhostsSpeedBesideTheBalls();
    void figuresOfAGhostThatLeftAreOfThatMoment();
    void figuresOfThePastCountFromWhereTheyMet();

private:
    double ballsOwn(const char *id) { return valueIn(m_fixture->parameters(), id); }
    double ghostsOwn(const char *id) { return valueIn(comparison().parameters(), id); }
    inspector::Comparison &comparison() { return m_fixture->session().comparison(); }
    static double valueIn(const inspector::Parameters &parameters, const char *id) {
        return parameters.value(parameters.indexOf(id));
    }
    double distance();
    void type(const QString &box, const QString &text);
    void switchOn();
};

void TestWindowGhost::init() {
    QVERIFY(open(3));
    m_fixture->parameters().set({{"tilt_x", 3.0}, {"tilt_y", 4.0}});
    comparison().setGhostChoice({"symplectic-euler", 1}); // only parameters differ
}

double TestWindowGhost::distance() {
    const inspector::Snapshot now = m_fixture->simulation().latest();
    return now.ghost ? now.ghost->deviation.distance : std::nan("");
}

void TestWindowGhost::type(const QString &name, const QString &text) {
    auto *box = m_fixture->find<NumberBox>(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
}

void TestWindowGhost::switchOn() {
    m_fixture->press(Qt::Key_C, Qt::ShiftModifier);
    QTRY_VERIFY(m_fixture->find<NumberBox>("ghost_restitution_wall_box")->isVisible());
}

void TestWindowGhost::keyGivesTheGhostSlidersOfItsOwn() {
    QVERIFY(!m_fixture->find<QSlider>("ghost_gravity_slider")->isVisible());
    switchOn();
    QVERIFY(comparison().isOn());
    QVERIFY(m_fixture->find<QSlider>("ghost_gravity_slider")->isVisible());
    m_fixture->makeSteps(20);
    COMPARE_EXACT(distance(), 0.0); // it has the ball's values
    m_fixture->press(Qt::Key_C);    // without a ghost the key has no effect
    QVERIFY(!m_fixture->find<QSlider>("ghost_gravity_slider")->isVisible());
}

void TestWindowGhost::switchInEitherDockDoesTheSame() {
    auto *box = m_fixture->find<QCheckBox>("parameters_ghost_parameters");
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    QVERIFY(comparison().hasOwnParameters());
    m_fixture->press(Qt::Key_5, Qt::ControlModifier);
    auto *other = m_fixture->find<QCheckBox>("comparison_ghost_parameters");
    QTRY_VERIFY(other->isVisible());
    QVERIFY(other->isChecked());
    QTest::mouseClick(other, Qt::LeftButton, {}, QPoint(8, other->height() / 2));
    QVERIFY(!comparison().hasOwnParameters());
    QVERIFY(!box->isChecked());
}

void TestWindowGhost::typedNumberMovesTheGhostAlone() {
    switchOn();
    type("ghost_rolling_friction_box", "0.01");
    COMPARE_EXACT(ghostsOwn("rolling_friction"), 0.01);
    COMPARE_EXACT(ballsOwn("rolling_friction"), 0.002);
    m_fixture->makeSteps(20);
    QVERIFY(distance() > 0.0);
    COMPARE_EXACT(m_fixture->simulated("rolling_friction"), 0.002);
}

void TestWindowGhost::sliderOfTheGhostIsUndone() {
    switchOn();
    auto *slider = m_fixture->find<QSlider>("ghost_restitution_wall_slider");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_End);
    COMPARE_EXACT(ghostsOwn("restitution_wall"), 1.0);
    COMPARE_EXACT(ballsOwn("restitution_wall"), 0.5);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    COMPARE_EXACT(ghostsOwn("restitution_wall"), 0.5);
}

void TestWindowGhost::copyGivesTheGhostTheBallsValues() {
    switchOn();
    type("restitution_wall_box", "0.7");
    type("ghost_gravity_box", "1.62");
    m_fixture->press(Qt::Key_X, Qt::ShiftModifier);
    COMPARE_EXACT(ghostsOwn("restitution_wall"), 0.7);
    COMPARE_EXACT(ghostsOwn("gravity"), 9.81);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    COMPARE_EXACT(ghostsOwn("restitution_wall"), 0.5);
    COMPARE_EXACT(ghostsOwn("gravity"), 1.62);
}

void TestWindowGhost::swapExchangesBothAndIsUndoneAtOnce() {
    switchOn();
    type("ghost_restitution_wall_box", "0.8");
    click(m_fixture->find<QToolButton>("parameters_swap_with_ghost"));
    COMPARE_EXACT(ballsOwn("restitution_wall"), 0.8);
    COMPARE_EXACT(ghostsOwn("restitution_wall"), 0.5);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    COMPARE_EXACT(ballsOwn("restitution_wall"), 0.5);
    COMPARE_EXACT(ghostsOwn("restitution_wall"), 0.8);
    COMPARE_EXACT(ballsOwn("tilt_x"), 3.0);
}

void TestWindowGhost::tiltIsTheBallsAlone() {
    switchOn();
    QVERIFY(!m_fixture->window().findChild<QSlider *>("ghost_tilt_x_slider"));
    m_fixture->press(Qt::Key_X);
    COMPARE_EXACT(ballsOwn("tilt_x"), 3.0);
    m_fixture->makeSteps(20);
    COMPARE_EXACT(distance(), 0.0);
}

void TestWindowGhost::refusedValueIsSaidBesideTheGhostsNumber() {
    switchOn();
    auto *model = m_fixture->find<QComboBox>("ghost_model_choice");
    model->setFocus();
    QTest::keyClick(model, Qt::Key_Down);
    type("ghost_rolling_friction_box", "5"); // more than the sliding friction
    const auto *box = m_fixture->find<NumberBox>("ghost_rolling_friction_box");
    QVERIFY2(box->reason().contains("rolling_friction"), qPrintable(box->reason()));
    COMPARE_EXACT(ghostsOwn("rolling_friction"), 0.002);
}

void TestWindowGhost::rigidRowsFollowTheGhostsModel() {
    switchOn();
    QVERIFY(!m_fixture->find<QSlider>("ghost_sliding_friction_slider")->isEnabled());
    auto *model = m_fixture->find<QComboBox>("ghost_model_choice");
    model->setFocus();
    QTest::keyClick(model, Qt::Key_Down);
    QVERIFY(m_fixture->find<QSlider>("ghost_sliding_friction_slider")->isEnabled());
    QVERIFY(!m_fixture->find<QSlider>("sliding_friction_slider")->isEnabled());
}

void TestWindowGhost::controlsSayWhoseTheyAre() {
    QCOMPARE(m_fixture->find<QSlider>("ghost_gravity_slider")->accessibleName(), QString("Gravity, the ghost's"));
    QCOMPARE(m_fixture->find<QSlider>("gravity_slider")->accessibleName(), QString("Gravity"));
}

// The default stepper has a row of its own, exact has none.
void TestWindowGhost::otherStepperBringsItsOwnRows() {
    switchOn();
    QVERIFY(m_fixture->find<QCheckBox>("ghost_as_reported_switch")->isVisible());
    comparison().setGhostChoice({"exact", 1});
    QVERIFY(!m_fixture->window().findChild<QCheckBox *>("ghost_as_reported_switch"));
    QVERIFY(m_fixture->find<QSlider>("ghost_gravity_slider")->isVisible());
}

// It stays where it left in its first step, while the ball falls on.
void TestWindowGhost::plotHasTheGhostsSpeedBesideTheBalls() {
    auto *plot = m_fixture->find<QCustomPlot>("velocity_plot");
    const QCPGraph *speed = plot->graph(2);
    const QCPGraph *ghosts = plot->graph(3);
    const auto isNamed = [&] {
        m_fixture->makeSteps(10);
        m_fixture->window().refresh();
        return plot->legend->hasItemWithPlottable(ghosts);
    };
    QVERIFY(!isNamed());
    switchOn();
    type("ghost_rolling_friction_box", "0.05");
    QVERIFY(isNamed());
    QCOMPARE(ghosts->name(), QString("Ghost speed"));
    QCOMPARE(ghosts->pen().color(), speed->pen().color());
    QCOMPARE(ghosts->pen().style(), Qt::DashLine);
    const double last = std::prev(ghosts->data()->constEnd())->value;
    QVERIFY2(last < std::prev(speed->data()->constEnd())->value, qPrintable(QString::number(last)));
}

void TestWindowGhost::figuresOfAGhostThatLeftAreOfThatMoment() {
    m_fixture->press(Qt::Key_5, Qt::ControlModifier); // its dock
    comparison().start({"symplectic-euler", 1});
    phys_state outside = m_fixture->simulation().latest().current;
    outside.position.x += 10.0;
    m_fixture->simulation().setState(outside);
    m_fixture->makeSteps(5);
    m_fixture->window().refresh();
    const QString figures = m_fixture->find<QLabel>("comparison_figures")->text();
    QVERIFY2(figures.startsWith("When the ghost left the maze: distance 0 mm"),
             qPrintable(figures)); // before it is cut
    QVERIFY2(figures.endsWith("0.01 s after they met"), qPrintable(figures));
    QCOMPARE(m_fixture->find<QLabel>("status_ghost")->text(), QString("Ghost: out of the maze"));
}

void TestWindowGhost::figuresOfThePastCountFromWhereTheyMet() {
    comparison().setOn(true);
    m_fixture->press(Qt::Key_5, Qt::ControlModifier);
    m_fixture->makeSteps(20);
    m_fixture->press(Qt::Key_M);
    m_fixture->makeSteps(20);
    const auto figuresAt = [&](uint64_t step) {
        m_fixture->session().lookAt(m_fixture->session().runPlace().begin + step);
        m_fixture->session().awaitMoment();
        m_fixture->window().refresh();
        return m_fixture->find<QLabel>("comparison_figures")->text();
    };
    QVERIFY2(figuresAt(30).contains(", 0.10 s after they met"), qPrintable(figuresAt(30)));
    QVERIFY2(!figuresAt(10).contains("they met") && !figuresAt(10).contains("not known"), qPrintable(figuresAt(10)));
}

QTEST_MAIN(TestWindowGhost)
#include "tst_window_ghost.moc"
