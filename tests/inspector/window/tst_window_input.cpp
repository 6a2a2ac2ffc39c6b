// SPDX-License-Identifier: MIT
// Forgiving input: numbers are read as people write them, Enter ends an edit without starting the game, the wheel
// changes only what has the focus, and no key stays pressed.
#include "gl/view/maze_view.h"
#include "ui/parameters/fine_slider.h"
#include "ui/parameters/slider_scale.h"
#include "ui/parts/number_box.h"
#include "ui/parts/theme.h"
#include "window_fixture.h"

#include <QComboBox>
#include <QDialog>
#include <QHelpEvent>
#include <QLabel>
#include <QLocale>
#include <QToolTip>

#include <functional>

using namespace window_test;
using inspector::Game;
using inspector::ui::NumberBox;

class TestWindowInput : public WindowSuite {
    Q_OBJECT

private slots:
    void numberIsReadAsPeopleWriteIt_data();
    void numberIsReadAsPeopleWriteIt();
    void numbersAreReadAlikeInEveryLocale();
    void unreadableNumberStaysMarkedWithItsReason_data();
    void unreadableNumberStaysMarkedWithItsReason();
    void emptyNumberIsRefusedAsNothing();
    void escTakesTheEditBack();
    void unreadableNumberStaysWhereTheFieldIsLeft();
    void refusedTextKeepsTheKeyboard_data();
    void refusedTextKeepsTheKeyboard();
    void escTakesBackWhatWasTyped_data();
    void escTakesBackWhatWasTyped();
    void undoGoesOnAfterTheTextOfANumber();
    void newValueTakesThePlaceOfRefusedText_data();
    void newValueTakesThePlaceOfRefusedText();
    void enterInTheTimeStepAppliesItAndPlaysNothing();
    void toolTipOfANumberTellsItsRange_data();
    void toolTipOfANumberTellsItsRange();
    void toolTipOfASliderTellsItsRange();
    void unitOfTheTimeStepIsSaidWhileItIsTyped();
    void enterInAnOpenListAppliesItAndPlaysNothing_data();
    void enterInAnOpenListAppliesItAndPlaysNothing();
    void enterOnAChooserPlaysNothing_data();
    void enterOnAChooserPlaysNothing();
    void commandsWorkAtOnceAfterAnEdit();
    void speedOfTheCommandLineIsInItsBox();
    void wheelTurnsNothingUnfocused_data();
    void wheelTurnsNothingUnfocused();
    void heldArrowIsReleasedWhereTheKeyboardGoesElsewhere();
    void secondKeyOfADirectionStillTilts();
    void arrowsTiltAsTheScreenShows_data();
    void arrowsTiltAsTheScreenShows();
    void shiftMakesASliderFine();
    void shiftMakesADragTenTimesSlower();
    void slidersAreWideEnough();
    void scaleOfDecadesHasEqualRatios();
    void scaleOfTinyNumbersReachesThem();

private:
    NumberBox *focused(const QString &name);
    bool hasView() { return m_fixture->window().view().hasFocus(); }
};

// With its text selected, as by Tab.
NumberBox *TestWindowInput::focused(const QString &name) {
    auto *box = m_fixture->find<NumberBox>(name);
    box->setFocus();
    box->selectAll();
    return box;
}

void TestWindowInput::numberIsReadAsPeopleWriteIt_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");
    QTest::newRow("exponent") << "1e-3" << 0.001;
    QTest::newRow("comma") << "0,9" << 0.9;
    QTest::newRow("point") << "0.9" << 0.9;
    QTest::newRow("fraction") << "1/8" << 0.125;
    QTest::newRow("unit") << "1.62 m/s^2" << 1.62;
    QTest::newRow("per cent") << "50%" << 0.5;
}

void TestWindowInput::numberIsReadAsPeopleWriteIt() {
    QFETCH(QString, text);
    QFETCH(double, value);
    const QString id = text.endsWith('%') ? "restitution_wall" : "gravity";
    focused(id + "_box");
    m_fixture->type(text);
    m_fixture->key(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->simulated(id), value);
    QTRY_VERIFY(hasView());
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Prompt);
}

void TestWindowInput::numbersAreReadAlikeInEveryLocale() {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    QVERIFY(open());
    NumberBox *box = focused("restitution_wall_box");
    m_fixture->type("0.9");
    m_fixture->key(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->simulated("restitution_wall"), 0.9);
    QCOMPARE(box->text(), QString("0.90"));
    QLocale::setDefault(before);
}

void TestWindowInput::unreadableNumberStaysMarkedWithItsReason_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("no number") << "fast";
    QTest::newRow("beyond the range") << "1e9";
    QTest::newRow("another unit") << "3 mm";
}

void TestWindowInput::unreadableNumberStaysMarkedWithItsReason() {
    QFETCH(QString, text);
    NumberBox *box = focused("gravity_box");
    m_fixture->type(text);
    m_fixture->key(Qt::Key_Return);
    QVERIFY(box->isRefused());
    QCOMPARE(box->text(), text);
    const auto *reason = m_fixture->find<QLabel>("gravity_box_note");
    QVERIFY(reason->isVisible());
    QVERIFY2(reason->text().contains("to 1000 m/s\u00b2") && reason->text().contains(text), qPrintable(reason->text()));
    QVERIFY(box->hasFocus());
    QCOMPARE(m_fixture->simulated("gravity"), 9.81);
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Prompt);
}

void TestWindowInput::emptyNumberIsRefusedAsNothing() {
    const NumberBox *box = focused("gravity_box");
    m_fixture->key(Qt::Key_Backspace);
    m_fixture->key(Qt::Key_Return);
    QVERIFY(box->isRefused());
    const QString reason = m_fixture->find<QLabel>("gravity_box_note")->text();
    QVERIFY2(reason.endsWith(", found nothing"), qPrintable(reason));
}

void TestWindowInput::escTakesTheEditBack() {
    NumberBox *box = focused("gravity_box");
    m_fixture->type("fast");
    m_fixture->key(Qt::Key_Return);
    QVERIFY(box->isRefused());
    m_fixture->key(Qt::Key_Escape);
    QVERIFY(!box->isRefused());
    QCOMPARE(box->text(), QString::fromUtf8("9.81 m/s²"));
    QVERIFY(!m_fixture->find<QLabel>("gravity_box_note")->isVisible());
    QTRY_VERIFY(hasView());
}

void TestWindowInput::unreadableNumberStaysWhereTheFieldIsLeft() {
    NumberBox *box = focused("gravity_box");
    m_fixture->type("fast");
    m_fixture->key(Qt::Key_Tab);
    QVERIFY(!box->hasFocus());
    QCOMPARE(box->text(), QString("fast"));
    QVERIFY(box->isRefused());
    m_fixture->window().refresh(); // nothing new
    QCOMPARE(box->text(), QString("fast"));
    m_fixture->trigger("compare"); // another command
    QVERIFY(box->isRefused());
    QVERIFY(box->toolTip().contains("fast"));
}

void TestWindowInput::refusedTextKeepsTheKeyboard_data() {
    QTest::addColumn<Qt::Key>("dock");
    QTest::addColumn<QString>("text");
    QTest::newRow("gravity_box") << Qt::Key(0) << "fast";
    QTest::newRow("trade_unknowns") << Qt::Key_4 << "tilt=much";
    QTest::newRow("track_file") << Qt::Key_7 << "missing.csv";
    QTest::newRow("track_units") << Qt::Key_7 << "t=days";
}

// Letters typed next would be commands.
void TestWindowInput::refusedTextKeepsTheKeyboard() {
    QFETCH(Qt::Key, dock);
    QFETCH(QString, text);
    if (dock) m_fixture->press(dock, Qt::ControlModifier);
    auto *field = m_fixture->find<QLineEdit>(QTest::currentDataTag());
    field->setFocus();
    field->selectAll();
    m_fixture->type(text);
    QTest::keyClick(field, Qt::Key_Return);
    for (int pass = 0; pass < 3; ++pass) QCoreApplication::processEvents(); // the keyboard is returned later
    QVERIFY(field->hasFocus());
}

void TestWindowInput::escTakesBackWhatWasTyped_data() { refusedTextKeepsTheKeyboard_data(); }

// Whether it was entered and refused, or not entered yet.
void TestWindowInput::escTakesBackWhatWasTyped() {
    QFETCH(Qt::Key, dock);
    QFETCH(QString, text);
    if (dock) m_fixture->press(dock, Qt::ControlModifier);
    auto *field = m_fixture->find<QLineEdit>(QTest::currentDataTag());
    field->setFocus();
    const QString before = field->text();
    for (const bool isEntered : {false, true}) {
        field->setFocus();
        field->selectAll();
        m_fixture->type(text);
        if (isEntered) QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(field->text(), text);
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!inspector::ui::AlarmText::isOn(*field));
        QTRY_VERIFY(m_fixture->window().view().hasFocus());
        field->setFocus();
        QCOMPARE(field->text(), before);
    }
}

// First the text comes back, then the changes before it.
void TestWindowInput::undoGoesOnAfterTheTextOfANumber() {
    focused("gravity_box");
    m_fixture->type("5");
    m_fixture->key(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->simulated("gravity"), 5.0);
    NumberBox *box = focused("restitution_wall_box");
    m_fixture->type("100 km/h");
    m_fixture->key(Qt::Key_Return);
    QVERIFY(box->isRefused());
    const int most = int(box->text().size()) + 2; // at worst letter by letter
    for (int i = 0; i < most && m_fixture->simulated("gravity") == 5.0; ++i) {
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        m_fixture->window().refresh();
    }
    QTRY_COMPARE(m_fixture->simulated("gravity"), 9.81);
    QVERIFY(!box->isRefused());
}

void TestWindowInput::newValueTakesThePlaceOfRefusedText_data() {
    QTest::addColumn<QString>("box");
    QTest::addColumn<std::function<void(Fixture &)>>("change");
    const auto row = [](const char *name, const char *box, const std::function<void(Fixture &)> &change) {
        QTest::newRow(name) << QString(box) << change;
    };
    row("slider", "gravity_box", [](Fixture &fixture) {
        auto *slider = fixture.find<inspector::ui::FineSlider>("gravity_slider");
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
    });
    row("reset all", "gravity_box", [](Fixture &fixture) { click(fixture.find<QWidget>("reset_all")); });
    row("reset to the same", "rolling_friction_box",
        [](Fixture &fixture) { fixture.press(Qt::Key_R, Qt::ControlModifier); });
    row("undo", "gravity_box", [](Fixture &fixture) { fixture.press(Qt::Key_Z, Qt::ControlModifier); });
    row("level", "rolling_friction_box",
        [](Fixture &fixture) { fixture.session().openLevel(fixture.session().levels().listed().at(1)); });
    row("autopilot", "tilt_x_box", [](Fixture &fixture) { fixture.press(Qt::Key_A); });
    row("lock", "tilt_y_box", [](Fixture &fixture) { fixture.press(Qt::Key_A); });
}

// And of the reason. The gravity was changed before.
void TestWindowInput::newValueTakesThePlaceOfRefusedText() {
    QFETCH(QString, box);
    QFETCH(std::function<void(Fixture &)>, change);
    focused("gravity_box");
    m_fixture->type("5");
    m_fixture->key(Qt::Key_Return);
    NumberBox *refused = focused(box);
    const QString tip = refused->toolTip();
    refused->setFocus();
    refused->selectAll();
    m_fixture->type("-1 apples");
    m_fixture->key(Qt::Key_Return);
    m_fixture->window().view().setFocus();
    QVERIFY(refused->isRefused());
    change(*m_fixture);
    QTRY_VERIFY(!refused->isRefused());
    QVERIFY2(!refused->text().contains("apples"), qPrintable(refused->text()));
    QVERIFY2(!refused->toolTip().contains("apples"), qPrintable(refused->toolTip()));
}

// The list around the field has the keyboard, not the field.
void TestWindowInput::enterInTheTimeStepAppliesItAndPlaysNothing() {
    auto *chooser = m_fixture->find<QComboBox>("time_step");
    chooser->setFocus();
    chooser->lineEdit()->selectAll();
    m_fixture->type("2,5 ms");
    m_fixture->key(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->simulation().latest().dt, 0.0025);
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Prompt);
    QTRY_VERIFY(hasView());
    QCOMPARE(chooser->currentText(), QString("2.5 ms"));
}

void TestWindowInput::toolTipOfANumberTellsItsRange_data() {
    QTest::addColumn<QString>("range");
    QTest::newRow("gravity_box") << "From 1e-06 to 1000 m/s²";
    QTest::newRow("restitution_wall_box") << "From 0 to 1";
    QTest::newRow("time_step_box") << "From 1 µs to 10 s";
    QTest::newRow("comparison_substeps") << "From 1 to 1000";
}

void TestWindowInput::toolTipOfANumberTellsItsRange() {
    QFETCH(QString, range);
    auto *box = m_fixture->find<NumberBox>(QTest::currentDataTag());
    QHelpEvent asked(QEvent::ToolTip, box->rect().center(), box->mapToGlobal(box->rect().center()));
    QApplication::sendEvent(box, &asked);
    QVERIFY2(QToolTip::text().endsWith('\n' + range), qPrintable(QToolTip::text()));
}

// What the slider reaches, which is less than what can be typed.
void TestWindowInput::toolTipOfASliderTellsItsRange() {
    const QString tip = m_fixture->find<QSlider>("gravity_slider")->toolTip();
    QVERIFY2(tip.endsWith("\nFrom 0.1 to 25 m/s²"), qPrintable(tip));
}

void TestWindowInput::unitOfTheTimeStepIsSaidWhileItIsTyped() {
    auto *chooser = m_fixture->find<QComboBox>("time_step");
    chooser->setFocus();
    chooser->lineEdit()->selectAll();
    m_fixture->type("0.0025");
    const auto *note = m_fixture->find<QLabel>("time_step_box_note");
    QVERIFY(note->isVisible());
    QCOMPARE(note->text(), QString("In s, or with a unit: 5 ms"));
    m_fixture->type("x");
    m_fixture->key(Qt::Key_Return);
    QVERIFY2(note->isVisible() && note->text().startsWith("expected a duration"), qPrintable(note->text()));
    m_fixture->key(Qt::Key_Backspace);
    m_fixture->key(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->simulation().latest().dt, 0.0025);
    QVERIFY(!note->isVisible());
}

void TestWindowInput::enterInAnOpenListAppliesItAndPlaysNothing_data() {
    QTest::addColumn<QString>("name");
    for (const char *name : {"speed", "stepper", "time_step", "model_choice"}) QTest::newRow(name) << name;
}

void TestWindowInput::enterInAnOpenListAppliesItAndPlaysNothing() {
    QFETCH(QString, name);
    auto *chooser = m_fixture->find<QComboBox>(name);
    const int last = chooser->count() - 1;
    QVERIFY(chooser->currentIndex() != last);
    chooser->setFocus(Qt::TabFocusReason);
    chooser->showPopup();
    QVERIFY(QApplication::activePopupWidget());
    m_fixture->key(Qt::Key_End);
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(!QApplication::activePopupWidget());
    QCOMPARE(chooser->currentIndex(), last);
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Prompt);
    QTRY_VERIFY(hasView());
}

void TestWindowInput::enterOnAChooserPlaysNothing_data() {
    QTest::addColumn<QString>("name");
    for (const char *name : {"speed", "stepper"}) QTest::newRow(name) << name;
}

void TestWindowInput::enterOnAChooserPlaysNothing() {
    QFETCH(QString, name);
    m_fixture->find<QWidget>(name)->setFocus();
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(hasView());
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Prompt);
    QVERIFY(!m_fixture->simulation().latest().running);
}

void TestWindowInput::commandsWorkAtOnceAfterAnEdit() {
    focused("gravity_box");
    m_fixture->type("3");
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(hasView());
    m_fixture->key(Qt::Key_C);
    QVERIFY(m_fixture->session().comparison().isOn());
    m_fixture->key(Qt::Key_Space);
    QTRY_VERIFY(m_fixture->simulation().latest().running);
}

void TestWindowInput::speedOfTheCommandLineIsInItsBox() {
    const auto *chooser = m_fixture->find<QComboBox>("speed");
    m_fixture->session().setSpeed(3.0);
    QCOMPARE(chooser->currentText(), QString("3 ×"));
    m_fixture->session().setSpeed(0.3);
    QCOMPARE(chooser->currentText(), QString("0.3 ×"));
    m_fixture->session().setSpeed(0.5);
    QCOMPARE(chooser->currentText(), QString("1/2 ×"));
}

void TestWindowInput::wheelTurnsNothingUnfocused_data() {
    QTest::addColumn<QString>("name");
    for (const char *name : {"model_choice", "stepper", "speed", "time_step", "gravity_box", "gravity_slider",
                             "comparison_stepper", "comparison_substeps"})
        QTest::newRow(name) << name;
}

void TestWindowInput::wheelTurnsNothingUnfocused() {
    QFETCH(QString, name);
    m_fixture->trigger("show_comparison_dock");
    m_fixture->window().view().setFocus();
    auto *widget = m_fixture->find<QWidget>(name);
    const auto valueOf = [&] {
        if (const auto *chooser = qobject_cast<QComboBox *>(widget)) return double(chooser->currentIndex());
        if (const auto *slider = qobject_cast<QSlider *>(widget)) return double(slider->value());
        return qobject_cast<NumberBox *>(widget)->value();
    };
    const double before = valueOf();
    turnWheel(widget, widget->rect().center(), 1);
    turnWheel(widget, widget->rect().center(), -1);
    turnWheel(widget, widget->rect().center(), -1);
    QCOMPARE(valueOf(), before);
}

void TestWindowInput::heldArrowIsReleasedWhereTheKeyboardGoesElsewhere() {
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().running);
    QTest::keyPress(&m_fixture->window(), Qt::Key_Up);
    QTRY_VERIFY(m_fixture->simulated("tilt_y") > 4.0);
    m_fixture->trigger("keys"); // a dialog; the key is released there or elsewhere
    auto *dialog = m_fixture->find<QDialog>("keys_dialog");
    dialog->activateWindow();
    QTRY_COMPARE(QApplication::activeWindow(), dialog);
    QTRY_COMPARE(m_fixture->simulated("tilt_y"), 0.0);
}

void TestWindowInput::secondKeyOfADirectionStillTilts() {
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().running);
    QWidget *window = &m_fixture->window();
    QTest::keyPress(window, Qt::Key_Up);
    QTest::keyPress(window, Qt::Key_Up, Qt::KeypadModifier);
    QTRY_VERIFY(m_fixture->simulated("tilt_y") > 4.0);
    QTest::keyRelease(window, Qt::Key_Up);
    QTRY_VERIFY(m_fixture->simulated("tilt_y") > 7.9); // goes on to the limit
    QTest::keyRelease(window, Qt::Key_Up, Qt::KeypadModifier);
    QTRY_COMPARE(m_fixture->simulated("tilt_y"), 0.0);
}

void TestWindowInput::arrowsTiltAsTheScreenShows_data() {
    QTest::addColumn<int>("pixels"); // that the camera is dragged
    for (const int pixels : {0, 130, 262, 400, 524, 700}) QTest::addRow("%d", pixels) << pixels;
}

void TestWindowInput::arrowsTiltAsTheScreenShows() {
    QFETCH(int, pixels);
    m_fixture->window().view().camera().orbit({double(pixels), 0.0});
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().running);
    QTest::keyPress(&m_fixture->window(), Qt::Key_Right);
    QTRY_VERIFY(std::hypot(m_fixture->simulated("tilt_x"), m_fixture->simulated("tilt_y")) > 4.0);
    // A ball in the middle rolls to the right on the screen, as seen by the camera on a level board.
    const double length = std::hypot(m_fixture->simulated("tilt_x"), m_fixture->simulated("tilt_y"));
    const glm::dvec3 middle = m_fixture->window().view().camera().target();
    const glm::dvec3 way(m_fixture->simulated("tilt_x") / length, m_fixture->simulated("tilt_y") / length, 0.0);
    const glm::dvec2 moved = m_fixture->window().view().camera().project(middle + 0.01 * way) -
                             m_fixture->window().view().camera().project(middle);
    QVERIFY2(moved.x > 0.0 && std::abs(moved.y) < 0.05 * moved.x,
             qPrintable(QStringLiteral("%1 %2").arg(moved.x).arg(moved.y)));
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Right);
}

// A notch of gravity is 0.01 m/s^2.
void TestWindowInput::shiftMakesASliderFine() {
    m_fixture->find<QSlider>("gravity_slider")->setFocus();
    m_fixture->key(Qt::Key_Right);
    QTRY_COMPARE(m_fixture->simulated("gravity"), 9.82);
    m_fixture->key(Qt::Key_Right, Qt::ShiftModifier);
    QTRY_COMPARE(m_fixture->simulated("gravity"), 9.821);
}

void TestWindowInput::shiftMakesADragTenTimesSlower() {
    auto *slider = m_fixture->find<QSlider>("restitution_wall_slider");
    const QPoint middle = slider->rect().center();
    const int start = slider->value();
    drag(slider, middle, middle + QPoint(30, 0));
    const int fast = slider->value() - start;
    slider->setValue(start);
    drag(slider, middle, middle + QPoint(30, 0), Qt::ShiftModifier);
    const int slow = slider->value() - start;
    // To a notch, which the fast one moves by.
    QVERIFY2(slow > 0 && std::abs(10 * slow - fast) <= 10 * inspector::ui::SliderScale::kFine,
             qPrintable(QStringLiteral("%1 %2").arg(slow).arg(fast)));
}

void TestWindowInput::slidersAreWideEnough() {
    for (const auto *slider : m_fixture->window().findChildren<inspector::ui::FineSlider *>())
        QVERIFY2(slider->width() >= 120, qPrintable(slider->objectName()));
}

namespace {

inspector::ui::SliderScale scaleOf(double low, double high, double step) {
    phys_param_row row{};
    row.low = row.min = low;
    row.high = row.max = high;
    row.step = step;
    return inspector::ui::SliderScale(row);
}

} // namespace

void TestWindowInput::scaleOfDecadesHasEqualRatios() {
    const auto scale = scaleOf(1e-6, 1.0, 1e-6);
    QCOMPARE(scale.valueAt(scale.last() / 2), 1e-3);
    QCOMPARE(scale.valueAt(scale.last() / 3), 1e-4);
    QCOMPARE(scale.placeOf(1e-3), scale.last() / 2);
    QCOMPARE(scale.placeOf(5.0), scale.last());
}

void TestWindowInput::scaleOfTinyNumbersReachesThem() {
    const auto scale = scaleOf(0.0, 1e-12, 1e-14);
    QCOMPARE(scale.valueAt(scale.last() / 2), 5e-13);
    QCOMPARE(scale.valueAt(inspector::ui::SliderScale::kFine), 1e-14);
    QCOMPARE(scale.valueAt(scale.last()), 1e-12);
}

QTEST_MAIN(TestWindowInput)
#include "tst_window_input.moc"
