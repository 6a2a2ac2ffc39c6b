// SPDX-License-Identifier: MIT
// A recording in the window: opened in every possible way, navigated by mouse and keys, taken over.
#include "core/recording/recording.h"
#include "core/setup/settings_file.h"
#include "gl/view/maze_view.h"
#include "inspector/stepping.h"
#include "support/files.h"
#include "ui/game/game_strip.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/number_box.h"
#include "ui/transport/seek_slider.h"
#include "ui/window/unattended_run.h"
#include "window_fixture.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QToolButton>
#include <QUndoStack>

#include <memory>

using namespace window_test;
using inspector::Game;
using inspector::ReplayPlace;
using inspector::Simulation;
using support::contentOf;
using support::write;

class TestWindowReplay : public WindowSuite {
    Q_OBJECT

private slots:
    void menuOpensAndPlaysToTheEnd();
    void droppedRecordingIsPlayedAndDroppedMazeIsOpened();
    void everythingShowsTheMoment();
    void keysStepBackAndForward();
    void keysGoToBothEndsAndPlay();
    void sliderIsDraggedByTheMouse();
    void sliderFollowsTheReplay();
    void keyboardMovesTheSlider();
    void whatWasRecordedCantBeChanged();
    void buttonsWithoutEffectLookSo();
    void lockedChoiceIsAsFlatAsALockedNumber();
    void recordingIntoAMazeOfTheReplayIsRefused();
    void goingOnKeepsTheMoment();
    void goingOnGivesTheBoardToTheArrowKeys();
    void goingOnFreesTheSliders();
    void closingGoesBackToTheLevelFromBefore();
    void choosingALevelEndsTheReplay();
    void anotherRecordingTakesThePlace();
    void differencePausesIsToldAndMarked();
    void refusalLeavesTheSessionAsItWas_data();
    void refusalLeavesTheSessionAsItWas();
    void interruptedRecordingIsToldAndPlayed();
    void ghostGoesWithTheReplay();
    void unattendedReplayEndsAtADifference();
    void pictureIsOfTheMomentAskedFor_data();
    void pictureIsOfTheMomentAskedFor();
    void recordingThatIsRefusedOpensNoSession();

private:
    QString recorded();
    void open(const QString &file);
    void drop(const QString &file);
    ReplayPlace place() { return m_fixture->simulation().latest().replay; }
    void goTo(uint64_t position);
    inspector::ui::SeekSlider *slider() { return m_fixture->find<inspector::ui::SeekSlider>("time_slider"); }
    QString message() { return m_fixture->find<inspector::ui::MessageBar>("messages")->line(); }
    QString text(const char *label) {
        m_fixture->window().refresh();
        return m_fixture->find<QLabel>(label)->text();
    }
};

namespace {

uint64_t hashOf(const inspector::Snapshot &snapshot) { return phys_state_hash(&snapshot.current); }

// Another hash at a step of the recording, from 1.
void flipHash(const QString &file, int step) {
    QByteArrayList lines = contentOf(file).split('\n');
    for (QByteArray &line : lines)
        if (line.size() == 16 && !line.contains(' ') && --step == 0) line[0] = line[0] == '0' ? '1' : '0';
    write(file, lines.join('\n'));
}

QPoint timeHandleOf(const QSlider &slider) {
    QStyleOptionSlider option;
    option.initFrom(&slider);
    option.orientation = Qt::Horizontal;
    option.minimum = slider.minimum();
    option.maximum = slider.maximum();
    option.sliderPosition = option.sliderValue = slider.value();
    return slider.style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider).center();
}

} // namespace

// 300 steps of 10 ms on level 3 with changing tilts and restitution, then 200 steps of 5 ms by another stepper from its
// start; made by another session. Returns the file.
QString TestWindowReplay::recorded() {
    QString file = m_fixture->path("run.rec");
    inspector::Options options;
    options.registry = inspector::makeRegistry(nullptr);
    options.levels = m_fixture->session().levels().listed();
    options.level = options.levels[2];
    options.record = file;
    options.settings = {{"restitution_wall", 0.25}};
    QSettings settings(m_fixture->path("other.ini"), inspector::settingsFormat());
    const auto session = inspector::Session::open(options, settings, nullptr);
    Simulation &simulation = session->simulation();
    const auto step = [&](uint64_t steps) {
        const uint64_t end = simulation.samples().last() + steps;
        for (uint64_t i = 0; i < steps; ++i) simulation.stepOnce();
        return QTest::qWaitFor([&] { return simulation.samples().last() == end; }, kPatience);
    };
    for (int i = 1; i <= 10; ++i) {
        session->parameters().set({{"tilt_x", 0.5 * i}, {"tilt_y", 3.0}});
        if (!step(30)) qFatal("the recording doesn't get on");
    }
    chooseStepper(*session, "rk4");
    chooseDt(*session, 0.005);
    simulation.restart();
    if (!step(200)) qFatal("the recording doesn't get on");
    return file;
}

void TestWindowReplay::open(const QString &file) {
    QVERIFY(m_fixture->session().openRecording(file));
    QTRY_VERIFY(place().number > 0);
}

void TestWindowReplay::drop(const QString &file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QWidget &window = m_fixture->window();
    const QPoint middle = window.rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &drop);
}

void TestWindowReplay::goTo(uint64_t position) {
    m_fixture->simulation().pause();
    QTRY_VERIFY(!m_fixture->simulation().latest().running); // so that it isn't just passing through
    m_fixture->session().replay()->seek(position);
    QTRY_COMPARE(place().position, position);
    QTRY_VERIFY(place().isChecked);
    m_fixture->window().refresh();
}

void TestWindowReplay::menuOpensAndPlaysToTheEnd() {
    const QString file = recorded();
    m_fixture->session().setSpeed(Simulation::kFastest);
    m_fixture->trigger("open_recording");
    auto *dialog = m_fixture->window().findChild<QFileDialog *>();
    QVERIFY(dialog);
    dialog->findChild<QLineEdit *>("fileNameEdit")->setText(file);
    click(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Open));
    QTRY_VERIFY(m_fixture->session().isReplaying());
    QVERIFY(m_fixture->find<QWidget>("time_bar")->isVisible());
    QTRY_COMPARE(place().position, uint64_t(500));
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    QTRY_VERIFY(place().isChecked);
    QCOMPARE(text("time_place"), QString("1.000 s · step 500 of 500"));
    QCOMPARE(text("time_verdict"), QString("same"));
    QCOMPARE(m_fixture->find<inspector::ui::GameStrip>("game_strip")->text().title, QString("Recording"));
    QCOMPARE(m_fixture->find<inspector::ui::GameStrip>("game_strip")->text().line, QString("Space plays it"));
    QCOMPARE(m_fixture->find<QLabel>("time_verdict")->toolTip(), QString("same: 500 steps"));
    QVERIFY(message().isEmpty());
}

void TestWindowReplay::droppedRecordingIsPlayedAndDroppedMazeIsOpened() {
    drop(recorded());
    QTRY_VERIFY(place().position > 0);
    const QString maze = m_fixture->path("mine.txt");
    QVERIFY(QFile::copy(m_fixture->session().levels().listed()[4].path, maze));
    drop(maze);
    QVERIFY(!m_fixture->session().isReplaying());
    QCOMPARE(m_fixture->session().level().path, maze);
    drop(m_fixture->path("nothing.txt"));
    QVERIFY2(message().contains("nothing.txt"), qPrintable(message()));
    QCOMPARE(m_fixture->session().level().path, maze);
}

void TestWindowReplay::everythingShowsTheMoment() {
    open(recorded());
    goTo(95); // the fourth tilt: 2 degrees
    QCOMPARE(m_fixture->window().windowTitle(), QString("run.rec – Level 3 – Physics inspector"));
    QCOMPARE(m_fixture->session().level().name, QString("03"));
    QCOMPARE(m_fixture->session().stepperId(), QByteArray(PHYS_STEPPER_DEFAULT));
    QCOMPARE(m_fixture->session().dt(), 0.01);
    QCOMPARE(text("status_time"), QString("Simulated: 0.950 s"));
    QCOMPARE(text("status_tilt"), QString("Tilt: 2.0° 3.0°"));
    QCOMPARE(m_fixture->find<inspector::ui::GameStrip>("game_strip")->text().clock, QString("0:00.95"));
    QCOMPARE(m_fixture->find<inspector::ui::NumberBox>("tilt_x_box")->text(), QString("2.0 °"));
    QCOMPARE(m_fixture->find<inspector::ui::NumberBox>("restitution_wall_box")->text(), QString("0.25"));
    goTo(400);
    QCOMPARE(m_fixture->session().stepperId(), QByteArray("rk4"));
    QCOMPARE(m_fixture->session().dt(), 0.005);
    QCOMPARE(m_fixture->find<QComboBox>("time_step")->currentText(), QString("5 ms"));
    QCOMPARE(text("status_time"), QString("Simulated: 0.500 s"));
    QCOMPARE(m_fixture->simulation().samples().last() - m_fixture->simulation().samples().first(), uint64_t(100));
}

void TestWindowReplay::keysStepBackAndForward() {
    open(recorded());
    goTo(95);
    m_fixture->press(Qt::Key_Comma);
    QTRY_COMPARE(place().position, uint64_t(94));
    m_fixture->press(Qt::Key_Comma);
    m_fixture->press(Qt::Key_Comma);
    QTRY_COMPARE(place().position, uint64_t(92));
    m_fixture->press(Qt::Key_Period);
    QTRY_COMPARE(place().position, uint64_t(93));
}

void TestWindowReplay::keysGoToBothEndsAndPlay() {
    open(recorded());
    goTo(95);
    m_fixture->press(Qt::Key_End, Qt::ControlModifier);
    QTRY_COMPARE(place().position, uint64_t(500));
    m_fixture->press(Qt::Key_Home, Qt::ControlModifier);
    QTRY_COMPARE(place().position, uint64_t(0));
    QVERIFY(!m_fixture->simulation().latest().running);
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(place().position > 0);
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
}

void TestWindowReplay::sliderIsDraggedByTheMouse() {
    open(recorded());
    goTo(0);
    const auto pixel = [&](int position) { return QPoint(slider()->pixelOf(position), slider()->height() / 2); };
    drag(slider(), timeHandleOf(*slider()), pixel(250));
    QTRY_COMPARE(place().position, uint64_t(slider()->value()));
    QVERIFY(qAbs(slider()->value() - 250) <= 1); // a step is more than a pixel here
    // Back, and a press beside the handle goes there.
    drag(slider(), timeHandleOf(*slider()), pixel(30));
    QTRY_COMPARE(place().position, uint64_t(slider()->value()));
    QVERIFY(qAbs(slider()->value() - 30) <= 1);
    QTest::mouseClick(slider(), Qt::LeftButton, {}, pixel(480));
    QTRY_COMPARE(place().position, uint64_t(slider()->value()));
    QVERIFY(qAbs(slider()->value() - 480) <= 1);
}

void TestWindowReplay::sliderFollowsTheReplay() {
    open(recorded());
    QTRY_VERIFY(slider()->value() > 5); // by the window's own refresh
    goTo(123);
    QCOMPARE(slider()->value(), 123);
    QCOMPARE(slider()->maximum(), 500);
}

void TestWindowReplay::keyboardMovesTheSlider() {
    open(recorded());
    goTo(200);
    slider()->setFocus();
    QTest::keyClick(slider(), Qt::Key_Right);
    QTRY_COMPARE(place().position, uint64_t(201));
    QTest::keyClick(slider(), Qt::Key_Left);
    QTest::keyClick(slider(), Qt::Key_Left);
    QTRY_COMPARE(place().position, uint64_t(199));
    QTest::keyClick(slider(), Qt::Key_PageDown); // a second of 100 steps, as every slider
    QTRY_COMPARE(place().position, uint64_t(99));
    QTest::keyClick(slider(), Qt::Key_End);
    QTRY_COMPARE(place().position, uint64_t(500));
    QTest::keyClick(slider(), Qt::Key_Home);
    QTRY_COMPARE(place().position, uint64_t(0));
}

void TestWindowReplay::whatWasRecordedCantBeChanged() {
    open(recorded());
    goTo(95);
    for (const char *name : {"tilt_x_slider", "restitution_wall_box", "reset_all", "stepper", "time_step"})
        QVERIFY2(!m_fixture->find<QWidget>(name)->isEnabled(), name);
    for (const char *name : {"play", "autopilot", "reset_parameters"})
        QVERIFY2(!m_fixture->find<QAction>(name)->isEnabled(), name);
    QVERIFY(m_fixture->find<QWidget>("speed")->isEnabled());
    QVERIFY(!chooseDt(m_fixture->session(), 0.02));
    QVERIFY(!message().isEmpty());
    QTest::keyPress(&m_fixture->window(), Qt::Key_Right);
    m_fixture->press(Qt::Key_Period);
    QTRY_COMPARE(place().position, uint64_t(96));
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Right);
    QCOMPARE(text("status_tilt"), QString("Tilt: 2.0° 3.0°"));
}

void TestWindowReplay::buttonsWithoutEffectLookSo() {
    open(recorded());
    for (const char *name : {"parameters_swap_with_ghost", "parameters_copy_to_ghost", "reset_all"}) {
        const auto *button = m_fixture->find<QWidget>(name);
        QVERIFY(!button->isEnabled());
        QCOMPARE(button->palette().color(QPalette::Disabled, QPalette::ButtonText),
                 QApplication::palette().color(QPalette::Disabled, QPalette::ButtonText));
    }
}

void TestWindowReplay::lockedChoiceIsAsFlatAsALockedNumber() {
    open(recorded());
    const auto brightness = [this](const char *name) {
        auto *widget = m_fixture->find<QWidget>(name);
        return qGray(widget->grab().toImage().pixel(widget->width() / 2, widget->height() / 2));
    };
    m_fixture->find<QComboBox>("model_choice")->setItemText(0, {}); // there would be letters
    const int flat = qGray(m_fixture->window().palette().color(QPalette::Window).rgb());
    QTRY_VERIFY2(std::abs(brightness("model_choice") - flat) <= 5,
                 qPrintable(QString::number(brightness("model_choice"))));
}

void TestWindowReplay::recordingIntoAMazeOfTheReplayIsRefused() {
    const inspector::Level own = m_fixture->session().levels().listed()[0];
    const QString copy = m_fixture->path("copy.txt");
    QVERIFY(QFile::copy(own.path, copy));
    QVERIFY(m_fixture->session().openLevel(inspector::levelOfFile(copy)));
    m_fixture->makeSteps(2);
    m_fixture->session().startRecording(m_fixture->path("two.rec"));
    m_fixture->makeSteps(2);
    QVERIFY(m_fixture->session().openLevel(own));
    m_fixture->makeSteps(2);
    m_fixture->session().stopRecording();
    open(m_fixture->path("two.rec"));
    goTo(4);
    m_fixture->window().refresh();
    QCOMPARE(m_fixture->session().level().path, own.path);
    const QByteArray before = contentOf(copy);
    m_fixture->session().startRecording(copy);
    QVERIFY2(message().contains("it is open here"), qPrintable(message()));
    QCOMPARE(contentOf(copy), before);
}

void TestWindowReplay::goingOnKeepsTheMoment() {
    open(recorded());
    goTo(95);
    const phys_state moment = m_fixture->simulation().latest().current;
    click(m_fixture->find<QToolButton>("time_bar_go_on"));
    QVERIFY(!m_fixture->session().isReplaying());
    QVERIFY(!m_fixture->find<QAction>("close_recording")->isEnabled());
    QTRY_COMPARE(m_fixture->simulation().latest().replay.number, uint64_t(0));
    QCOMPARE(hashOf(m_fixture->simulation().latest()), phys_state_hash(&moment));
    QCOMPARE(m_fixture->session().level().name, QString("03"));
    QCOMPARE(m_fixture->simulated("restitution_wall"), 0.25);
    QCOMPARE(m_fixture->simulated("tilt_y"), 3.0);
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Playing);
}

void TestWindowReplay::goingOnGivesTheBoardToTheArrowKeys() {
    open(recorded());
    goTo(95);
    m_fixture->press(Qt::Key_G);
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 95);
    QTest::keyPress(&m_fixture->window(), Qt::Key_Left);
    QTRY_VERIFY(m_fixture->simulated("tilt_x") < -6.0);
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Left);
}

void TestWindowReplay::goingOnFreesTheSliders() {
    open(recorded());
    goTo(95);
    m_fixture->press(Qt::Key_G);
    QVERIFY(m_fixture->find<QWidget>("tilt_x_slider")->isEnabled());
    auto *restitution = m_fixture->find<QSlider>("restitution_wall_slider");
    restitution->setFocus();
    QTest::keyClick(restitution, Qt::Key_End);
    QTRY_COMPARE(m_fixture->simulated("restitution_wall"), 1.0);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier); // and back to what was recorded
    QTRY_COMPARE(m_fixture->simulated("restitution_wall"), 0.25);
}

void TestWindowReplay::closingGoesBackToTheLevelFromBefore() {
    QVERIFY(chooseDt(m_fixture->session(), 0.002));
    QVERIFY(m_fixture->parameters().set({{"restitution_wall", 0.75}}));
    open(recorded());
    goTo(400);
    m_fixture->trigger("close_recording");
    QVERIFY(!m_fixture->session().isReplaying());
    QCOMPARE(m_fixture->session().level().name, QString("01"));
    QCOMPARE(m_fixture->session().stepperId(), QByteArray(PHYS_STEPPER_DEFAULT));
    QTRY_COMPARE(m_fixture->simulation().latest().replay.number, uint64_t(0));
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(0));
    QTRY_COMPARE(m_fixture->simulated("restitution_wall"), 0.75);
    QCOMPARE(m_fixture->simulation().latest().dt, 0.002);
    QCOMPARE(m_fixture->simulation().latest().current.position.x, -0.054); // start of level 01
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Prompt);
    QVERIFY(!m_fixture->find<QAction>("close_recording")->isEnabled());
    QCOMPARE(m_fixture->window().windowTitle(), QString("Level 1 – Physics inspector"));
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 0);
}

void TestWindowReplay::choosingALevelEndsTheReplay() {
    open(recorded());
    goTo(400);
    m_fixture->game().choose(6);
    QVERIFY(!m_fixture->session().isReplaying());
    QCOMPARE(m_fixture->session().level().name, QString("07"));
    QCOMPARE(m_fixture->session().stepperId(), QByteArray(PHYS_STEPPER_DEFAULT));
    QTRY_COMPARE(m_fixture->simulation().latest().dt, 0.01);
    QCOMPARE(m_fixture->simulated("restitution_wall"), 0.5);
}

void TestWindowReplay::anotherRecordingTakesThePlace() {
    const QString file = recorded();
    open(file);
    goTo(400);
    const uint64_t first = place().number;
    open(file);
    QTRY_COMPARE(place().number, first + 1);
    goTo(30);
    QCOMPARE(m_fixture->session().dt(), 0.01);
    m_fixture->trigger("close_recording");
    QCOMPARE(m_fixture->session().level().name, QString("01")); // before the first
}

void TestWindowReplay::differencePausesIsToldAndMarked() {
    const QString file = recorded();
    flipHash(file, 57);
    write(file, contentOf(file).replace("library ", "library 0."));
    open(file);
    QTRY_COMPARE(place().position, uint64_t(57));
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    QTRY_VERIFY2(
        message().startsWith("differs: step 57 of the recording, step 57 since the start, from 0.56 s on: expected"),
        qPrintable(message()));
    QVERIFY2(message().contains("libphysics was 0."), qPrintable(message()));
    QCOMPARE(text("time_verdict"), QString("differs from step 57 on"));
    goTo(200);
    const QImage picture = slider()->grab().toImage();
    const auto at = [&](int position) {
        return picture.pixelColor(int(slider()->pixelOf(position) * picture.devicePixelRatio()), picture.height() - 2);
    };
    QVERIFY2(at(57).red() > at(57).blue() + 60, qPrintable(at(57).name())); // the mark
    QVERIFY2(at(120).red() < at(120).blue() + 60, qPrintable(at(120).name()));
    click(m_fixture->find<QToolButton>("time_to_difference"));
    QTRY_COMPARE(place().position, uint64_t(57));
}

void TestWindowReplay::refusalLeavesTheSessionAsItWas_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no recording") << QByteArray("physics-recording") << QByteArray("some text")
                                  << "expected a recording: 'physics-recording VERSION'";
    QTest::newRow("other maze") << QByteArray("level ") << QByteArray("level 0123456789abcdef ")
                                << "expected a maze file";
    QTest::newRow("missing plugin") << QByteArray("stepper rk4") << QByteArray("stepper elsewhere")
                                    << "--plugin loads a plugin's steppers";
    QTest::newRow("no steps") << QByteArray() << QByteArray() << "expected steps, found none";
    QTest::newRow("no file") << QByteArray("all") << QByteArray() << "No such file";
}

void TestWindowReplay::refusalLeavesTheSessionAsItWas() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QString, reason);
    const QString file = recorded();
    QByteArray content = contentOf(file);
    if (from.isEmpty()) content = content.left(content.indexOf("level "));
    write(file, content.replace(from, to));
    if (from == "all") QVERIFY(QFile::remove(file));

    m_fixture->press(Qt::Key_Return); // a game is on
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 5);
    QVERIFY(!m_fixture->session().openRecording(file));
    QVERIFY2(message().contains(file) && message().contains(reason), qPrintable(message()));
    QCOMPARE(message().count('\n'), 0);
    QVERIFY(!m_fixture->session().isReplaying());
    QVERIFY(!m_fixture->find<QAction>("close_recording")->isEnabled());
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Playing);
    const uint64_t step = m_fixture->simulation().latest().current.step;
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > step);
    QCOMPARE(m_fixture->session().level().name, QString("01"));
}

void TestWindowReplay::interruptedRecordingIsToldAndPlayed() {
    const QString file = recorded();
    write(file, contentOf(file).chopped(12)); // "end" and half of the last hash
    open(file);
    QCOMPARE(message(), file + ": the recording was interrupted; it ends after 499 steps");
    goTo(499);
    QCOMPARE(text("time_verdict"), QString("same, cut off"));
}

// On the recording's level, and back on the one from before.
void TestWindowReplay::ghostGoesWithTheReplay() {
    m_fixture->session().comparison().start({"exact", 1});
    open(recorded());
    goTo(40); // on its way
    QVERIFY(m_fixture->simulation().latest().ghost);
    QCOMPARE(m_fixture->simulation().latest().ghost->met.time, 0.0);
    QVERIFY(m_fixture->simulation().latest().ghost->deviation.distance > 0.0);
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    m_fixture->trigger("close_recording");
    QTRY_COMPARE(m_fixture->simulation().latest().replay.number, uint64_t(0));
    QTRY_VERIFY(m_fixture->simulation().latest().ghost);
}

// It pauses there, as nobody can continue it.
void TestWindowReplay::unattendedReplayEndsAtADifference() {
    inspector::Options options;
    options.registry = m_fixture->session().registry();
    options.levels = m_fixture->session().levels().listed();
    options.level = options.levels[0];
    options.replay = recorded();
    options.duration = 4.0;
    flipHash(options.replay, 57);
    QSettings settings(m_fixture->path("third.ini"), inspector::settingsFormat());
    const auto session = inspector::Session::open(options, settings, nullptr);
    QVERIFY(session);
    inspector::ui::UnattendedRun run(*session, options);
    QString error;
    connect(&run, &inspector::ui::UnattendedRun::finished, this, [&](const QString &line) { error = line; });
    run.start();
    QTRY_VERIFY2(error.startsWith("differs: step 57 of the recording"), qPrintable(error));
    QCOMPARE(session->simulation().latest().replay.position, uint64_t(57));
}

void TestWindowReplay::pictureIsOfTheMomentAskedFor_data() {
    QTest::addColumn<double>("duration"); // s; < 0: not given
    QTest::addColumn<uint64_t>("position");
    QTest::addColumn<bool>("isSame");
    QTest::newRow("in the first run") << 1.5 << uint64_t(150) << true;
    QTest::newRow("in the second run") << 3.5 << uint64_t(400) << true;
    QTest::newRow("end") << -1.0 << uint64_t(500) << true;
    QTest::newRow("before a difference") << 0.1 << uint64_t(10) << false;
}

void TestWindowReplay::pictureIsOfTheMomentAskedFor() {
    QFETCH(double, duration);
    QFETCH(uint64_t, position);
    QFETCH(bool, isSame);
    inspector::Options options;
    options.registry = m_fixture->session().registry();
    options.levels = m_fixture->session().levels().listed();
    options.level = options.levels[0];
    options.replay = recorded();
    options.grab = m_fixture->path("picture.png");
    if (duration >= 0.0) options.duration = duration;
    if (!isSame) flipHash(options.replay, 57);
    QSettings settings(m_fixture->path("third.ini"), inspector::settingsFormat());
    const auto session = inspector::Session::open(options, settings, nullptr);
    QVERIFY(session);
    inspector::ui::UnattendedRun run(*session, options);
    QString error = "not yet";
    connect(&run, &inspector::ui::UnattendedRun::finished, this, [&](const QString &line) { error = line; });
    run.start();
    QTRY_VERIFY(error != "not yet");
    QCOMPARE(session->simulation().latest().replay.position, position);
    QVERIFY(!session->simulation().latest().running);
    QCOMPARE(error.isEmpty(), isSame);
    QVERIFY2(isSame || error.startsWith("differs: step "), qPrintable(error));
}

void TestWindowReplay::recordingThatIsRefusedOpensNoSession() {
    inspector::Options options;
    options.registry = m_fixture->session().registry();
    options.levels = m_fixture->session().levels().listed();
    options.level = options.levels[0];
    options.replay = m_fixture->path("nowhere.rec");
    QString error;
    QVERIFY(!inspector::Session::open(options, m_fixture->settings(), &error));
    QVERIFY2(error.startsWith("--replay: '" + options.replay), qPrintable(error));
}

QTEST_MAIN(TestWindowReplay)
#include "tst_window_replay.moc"
