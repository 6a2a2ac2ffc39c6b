// SPDX-License-Identifier: MIT
// The simulation obeys every parameter that the user changes.
#include "gl/board_pose.h"
#include "gl/view/maze_view.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/number_box.h"
#include "ui/window/board_picture.h"
#include "window_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QToolButton>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

using namespace window_test;
using inspector::ui::NumberBox;

class TestWindowParameters : public WindowSuite {
    Q_OBJECT

private slots:
    void draggedSliderReachesTheSimulation_data();
    void draggedSliderReachesTheSimulation();
    void typedNumberReachesTheSimulation_data();
    void typedNumberReachesTheSimulation();
    void chosenModelReachesTheSimulation();
    void clickedSwitchReachesTheSimulation();
    void typedDigitsAreKept();
    void longNumberShowsItsBeginning_data();
    void longNumberShowsItsBeginning();
    void numberBeyondTheSliderLeavesItAtItsEnd();
    void resetButtonGivesTheDefault();
    void resetAllGivesEveryDefault();
    void oneUndoTakesBackOneDrag();
    void twoDragsAreUndoneOneByOne();
    void redoDoesItAgain();
    void aTypedNumberIsUndoneWithoutTheDragBeforeIt();
    void undoIsTheWindowsOnceANumberCounts();
    void undoIsTheNumbersWhileItIsTyped();
    void undoTakesBackAChosenStepperAndTimeStep();
    void undoOfResetAllBringsBackEveryValue();
    void rowsOfTheRigidModelAreLockedInTheRollingModel();
    void refusedValueIsShownAndChangesNothing();
    void wheelOverAnUnfocusedSliderChangesNothing();
    void tiltFollowsTheAutopilotAndIsLocked();
    void boardIsDrawnAsGravityIsTilted();

private:
    void chooseRigid();
    void addNumberRows();
};

namespace {

QPoint handleOf(QSlider *slider) {
    QStyleOptionSlider option;
    option.initFrom(slider);
    option.orientation = slider->orientation();
    option.minimum = slider->minimum();
    option.maximum = slider->maximum();
    option.sliderPosition = slider->sliderPosition();
    option.sliderValue = slider->value();
    return slider->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider).center();
}

void dragBy(QSlider *slider, int pixels) {
    const QPoint from = handleOf(slider);
    drag(slider, from, from + QPoint(pixels, 0));
}

void type(NumberBox *box, const QString &text) {
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
}

} // namespace

void TestWindowParameters::chooseRigid() {
    auto *model = m_fixture->find<QComboBox>("model_choice");
    model->setFocus();
    QTest::keyClick(model, Qt::Key_Down);
    QTRY_COMPARE(m_fixture->simulated("model"), double(PHYS_MODEL_RIGID));
}

// Generated from the tables, so that a new row is tested without a change here.
void TestWindowParameters::addNumberRows() {
    QTest::addColumn<QString>("id");
    const inspector::Parameters parameters;
    for (int i = 0; i < parameters.count(); ++i)
        if (!(parameters.row(i).flags & (PHYS_ROW_CHOICE | PHYS_ROW_SWITCH)))
            QTest::newRow(parameters.row(i).id) << QString(parameters.row(i).id);
}

void TestWindowParameters::draggedSliderReachesTheSimulation_data() { addNumberRows(); }

void TestWindowParameters::draggedSliderReachesTheSimulation() {
    QFETCH(QString, id);
    chooseRigid(); // every row has an effect there
    auto *slider = m_fixture->find<QSlider>(id + "_slider");
    const int before = slider->value();
    dragBy(slider, 20);
    QVERIFY(slider->value() > before);

    const phys_param_row &row = m_fixture->parameters().row(m_fixture->parameters().indexOf(id));
    const double expected = row.low + (row.high - row.low) * slider->value() / slider->maximum();
    // The parameter has no digits beyond the ninth; tilt goes through radians and back.
    QTRY_VERIFY(std::abs(m_fixture->simulated(id) - expected) < 1e-9);
}

void TestWindowParameters::typedNumberReachesTheSimulation_data() { addNumberRows(); }

void TestWindowParameters::typedNumberReachesTheSimulation() {
    QFETCH(QString, id);
    chooseRigid();
    type(m_fixture->find<NumberBox>(id + "_box"), "0.25");
    QTRY_VERIFY(std::abs(m_fixture->simulated(id) - 0.25) < 1e-12);
}

void TestWindowParameters::chosenModelReachesTheSimulation() {
    QCOMPARE(m_fixture->simulated("model"), double(PHYS_MODEL_ROLLING));
    chooseRigid();
}

void TestWindowParameters::clickedSwitchReachesTheSimulation() {
    const inspector::Parameters &parameters = m_fixture->parameters();
    int index = 0;
    while (index < parameters.count() && !(parameters.row(index).flags & PHYS_ROW_SWITCH)) ++index;
    if (index == parameters.count()) QSKIP("the default stepper has no switch");
    const QString id = parameters.row(index).id;
    auto *box = m_fixture->find<QCheckBox>(id + "_switch");
    QTest::mouseClick(box, Qt::LeftButton, {}, {10, box->height() / 2});
    QTRY_COMPARE(m_fixture->simulated(id), 1.0);
}

void TestWindowParameters::typedDigitsAreKept() {
    auto *box = m_fixture->find<NumberBox>("rolling_friction_box");
    type(box, "0.0012345");
    QCOMPARE(m_fixture->parameters().value(m_fixture->parameters().indexOf("rolling_friction")), 0.0012345);
    QCOMPARE(box->text(), QString("0.0012345"));
}

void TestWindowParameters::longNumberShowsItsBeginning_data() {
    QTest::addColumn<QString>("box");
    QTest::addColumn<QString>("text");
    QTest::addColumn<Qt::Key>("end");
    QTest::newRow("Enter") << "restitution_wall_box"
                           << "1/3" << Qt::Key_Return;
    QTest::newRow("Tab") << "tilt_x_box"
                         << "0.05 rad" << Qt::Key_Tab;
}

void TestWindowParameters::longNumberShowsItsBeginning() {
    QFETCH(QString, box);
    QFETCH(QString, text);
    QFETCH(Qt::Key, end);
    auto *number = m_fixture->find<NumberBox>(box);
    number->setFocus();
    number->selectAll();
    m_fixture->type(text);
    m_fixture->key(end);
    number->grab(); // a paint scrolls it
    QVERIFY(number->exactText().size() > 12);
    QCOMPARE(number->cursorPositionAt({0, number->height() / 2}), 0);
}

void TestWindowParameters::numberBeyondTheSliderLeavesItAtItsEnd() {
    type(m_fixture->find<NumberBox>("gravity_box"), "100");
    auto *slider = m_fixture->find<QSlider>("gravity_slider");
    QCOMPARE(slider->value(), slider->maximum());
    QTRY_COMPARE(m_fixture->simulated("gravity"), 100.0);
}

void TestWindowParameters::resetButtonGivesTheDefault() {
    dragBy(m_fixture->find<QSlider>("gravity_slider"), 20);
    auto *reset = m_fixture->find<QToolButton>("gravity_reset");
    QVERIFY(reset->isEnabled());
    click(reset);
    QTRY_COMPARE(m_fixture->simulated("gravity"), 9.81);
    QVERIFY(!reset->isEnabled());
}

void TestWindowParameters::resetAllGivesEveryDefault() {
    dragBy(m_fixture->find<QSlider>("gravity_slider"), 20);
    dragBy(m_fixture->find<QSlider>("tilt_x_slider"), 20);
    click(m_fixture->find<QPushButton>("reset_all"));
    for (int i = 0; i < m_fixture->parameters().count(); ++i)
        QVERIFY2(m_fixture->parameters().isInitial(i), m_fixture->parameters().row(i).id);
    QTRY_COMPARE(m_fixture->simulated("tilt_x"), 0.0);
}

void TestWindowParameters::oneUndoTakesBackOneDrag() {
    dragBy(m_fixture->find<QSlider>("restitution_wall_slider"), 20);
    QTRY_VERIFY(m_fixture->simulated("restitution_wall") > 0.5);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(m_fixture->simulated("restitution_wall"), 0.5);
}

void TestWindowParameters::twoDragsAreUndoneOneByOne() {
    auto *slider = m_fixture->find<QSlider>("restitution_wall_slider");
    dragBy(slider, 10);
    const int between = slider->value();
    dragBy(slider, 10);
    QVERIFY(slider->value() > between);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(slider->value(), between);
}

void TestWindowParameters::aTypedNumberIsUndoneWithoutTheDragBeforeIt() {
    auto *slider = m_fixture->find<QSlider>("restitution_wall_slider");
    dragBy(slider, 20);
    const int dragged = slider->value();
    type(m_fixture->find<NumberBox>("restitution_wall_box"), "0.25");
    QVERIFY(slider->value() < dragged);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(slider->value(), dragged);
}

void TestWindowParameters::undoIsTheWindowsOnceANumberCounts() {
    auto *box = m_fixture->find<NumberBox>("restitution_wall_box");
    type(box, "0.80");
    QTRY_COMPARE(m_fixture->simulated("restitution_wall"), 0.8);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(m_fixture->simulated("restitution_wall"), 0.5);
    QCOMPARE(box->value(), 0.5);
}

void TestWindowParameters::undoIsTheNumbersWhileItIsTyped() {
    auto *box = m_fixture->find<NumberBox>("restitution_wall_box");
    type(box, "0.80");
    box->selectAll();
    QTest::keyClicks(box, "0.9");
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(box->value(), 0.8); // only letters were removed
}

void TestWindowParameters::undoTakesBackAChosenStepperAndTimeStep() {
    auto *stepper = m_fixture->find<QComboBox>("stepper");
    const QString before = stepper->currentText();
    stepper->setFocus(Qt::TabFocusReason);
    QTest::keyClick(stepper, Qt::Key_End);
    QVERIFY(m_fixture->session().stepperId() != PHYS_STEPPER_DEFAULT);
    QLineEdit *time_step = m_fixture->find<QComboBox>("time_step")->lineEdit();
    time_step->setFocus();
    time_step->selectAll();
    QTest::keyClicks(time_step, "3 ms");
    QTest::keyClick(time_step, Qt::Key_Return);
    QTRY_VERIFY(m_fixture->window().view().hasFocus()); // the game has the keyboard again
    QCOMPARE(m_fixture->session().dt(), 0.003);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_fixture->session().dt(), 0.01);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_fixture->session().stepperId(), QByteArray(PHYS_STEPPER_DEFAULT));
    QCOMPARE(stepper->currentText(), before);
}

void TestWindowParameters::redoDoesItAgain() {
    auto *slider = m_fixture->find<QSlider>("restitution_wall_slider");
    dragBy(slider, 20);
    const int dragged = slider->value();
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(slider->value() < dragged);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(slider->value(), dragged);
}

void TestWindowParameters::undoOfResetAllBringsBackEveryValue() {
    type(m_fixture->find<NumberBox>("gravity_box"), "1.62");
    type(m_fixture->find<NumberBox>("tilt_y_box"), "3");
    m_fixture->press(Qt::Key_R, Qt::ControlModifier);
    QTRY_COMPARE(m_fixture->simulated("gravity"), 9.81);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(m_fixture->simulated("gravity"), 1.62);
    QCOMPARE(m_fixture->parameters().value(m_fixture->parameters().indexOf("tilt_y")), 3.0);
}

void TestWindowParameters::rowsOfTheRigidModelAreLockedInTheRollingModel() {
    auto *slider = m_fixture->find<QSlider>("sliding_friction_slider");
    QVERIFY(!slider->isEnabled());
    QVERIFY2(slider->toolTip().contains("rigid model"), qPrintable(slider->toolTip()));
    chooseRigid();
    QVERIFY(slider->isEnabled());
}

void TestWindowParameters::refusedValueIsShownAndChangesNothing() {
    chooseRigid();
    auto *box = m_fixture->find<NumberBox>("rolling_friction_box");
    type(box, "5"); // more than the sliding friction
    QVERIFY2(box->reason().contains("rolling_friction"), qPrintable(box->reason()));
    QCOMPARE(box->text(), QString("5")); // as typed
    QCOMPARE(box->value(), 0.002);
    QCOMPARE(m_fixture->simulated("rolling_friction"), 0.002);
}

void TestWindowParameters::wheelOverAnUnfocusedSliderChangesNothing() {
    auto *slider = m_fixture->find<QSlider>("gravity_slider");
    const int before = slider->value();
    turnWheel(slider, slider->rect().center(), 3);
    QCOMPARE(slider->value(), before);
    slider->setFocus();
    turnWheel(slider, slider->rect().center(), 3);
    QVERIFY(slider->value() > before);
}

void TestWindowParameters::tiltFollowsTheAutopilotAndIsLocked() {
    auto *box = m_fixture->find<NumberBox>("tilt_y_box");
    m_fixture->press(Qt::Key_A);
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(box->value() != 0.0);
    QVERIFY(!box->isEnabled());
    m_fixture->press(Qt::Key_A);
    QVERIFY(box->isEnabled());
    QCOMPARE(box->value(), 0.0); // off: the board goes level
}

// The direction that the picture shows as straight down is that of gravity, in the board's frame.
void TestWindowParameters::boardIsDrawnAsGravityIsTilted() {
    m_fixture->parameters().set({{QStringLiteral("tilt_x"), 15.0}, {QStringLiteral("tilt_y"), -12.0}});
    QTRY_COMPARE(m_fixture->simulated("tilt_y"), -12.0);
    const inspector::gl::Frame frame = inspector::ui::currentFrame(m_fixture->session());
    const glm::dmat3 turn(inspector::gl::boardToWorld(frame.tiltX, frame.tiltY, glm::dvec3(0.0)));
    const glm::dvec3 down = glm::transpose(turn) * glm::dvec3(0.0, 0.0, -1.0);
    const phys_vec3 gravity = m_fixture->simulation().latest().inputs.params.gravity;
    const glm::dvec3 pull = glm::normalize(glm::dvec3(gravity.x, gravity.y, gravity.z));
    QVERIFY(glm::distance(down, pull) < 1e-12); // rounding of a dozen operations on numbers of size 1
}

QTEST_MAIN(TestWindowParameters)
#include "tst_window_parameters.moc"
