// SPDX-License-Identifier: MIT
// A measured ball overlaid on the run: in the view, in plots, on the time bar; and a ball that rolls along.
#include "inspector/stepping.h"
#include "inspector/track/made_track.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/number_box.h"
#include "ui/plots/plot_stack.h"
#include "ui/track/fit_table.h"
#include "ui/transport/seek_slider.h"
#include "ui/window/board_picture.h"
#include "window_fixture.h"

#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTreeWidget>

#include <cmath>

using namespace window_test;
using namespace inspector;

class TestWindowTrack : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void openedTrackIsABallAndATrail();
    void trailStaysWhereItWasMeasuredWhenTheBallFalls();
    void droppedTableIsLaidOverTheRun();
    void typedTableIsARecentOne();
    void droppedTableThatIsWrongSaysWhy();
    void openedTrackSettlesARefusedName();
    void numberTypedIntoTheTableEndsTheEditOnce();
    void whereItEndsThereIsNoBall();
    void plotsChooseItsCurves();
    void timeBarShowsItsSpan();
    void spanBeginsWithTheRun();
    void otherLevelHidesItAndSaysSo();
    void itsLevelBringsItBack();
    void itsLevelBringsItBackWithoutWhatAFitHadFound();
    void fitComesBackFromThePastOfAnotherLevel();
    void recordingThatChangesTheLevelSamplesItInItsOwnOnly();
    void recordingOfItsLevelKeepsIt();
    void recordingOfAnotherLevelHidesIt();
    void takingOverThePastEndsRollAlong();
    void rollAlongStartsWhereItStarted();
    void slidersShowTheTiltThatItRollsAlongUnder();
    void keysTakeTheBoardBack();

private:
    void openTrack();
    void clickLevel(int number);
    QString recorded();
    QString report() { return m_fixture->find<QPlainTextEdit>("track_report")->toPlainText(); }
    Snapshot now() { return m_fixture->simulation().latest(); }
    gl::Frame frame() { return ui::currentFrame(m_fixture->session()); }
    QPushButton &follow() { return *m_fixture->find<QPushButton>("track_follow"); }

    Track m_track;
};

// 2 s of a ball without noise, from the start of the level.
void TestWindowTrack::init() {
    QVERIFY(open(3));
    const BoardParameters board{initialInputs().params, 9.81, {}, 0.0, {}};
    m_track = support::makeTrack(m_fixture->session().registry(), m_fixture->session().scene(), board,
                                 {.duration = 2.0, .rate = 100.0, .noise = 0.0});
    QFile file(m_fixture->path("track.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(support::csvOf(m_track));
}

void TestWindowTrack::openTrack() {
    m_fixture->press(Qt::Key_7, Qt::ControlModifier);
    auto *file = m_fixture->find<QLineEdit>("track_file");
    QTRY_VERIFY(file->isVisible());
    file->setFocus(Qt::TabFocusReason);
    QTest::keyClicks(file, m_fixture->path("track.csv"));
    QTest::keyClick(file, Qt::Key_Return);
    QVERIFY2(m_fixture->session().track(), qPrintable(m_fixture->find<QPlainTextEdit>("track_report")->toPlainText()));
}

void TestWindowTrack::clickLevel(int number) {
    auto *levels = m_fixture->find<QTreeWidget>("levels");
    const QRect place = levels->visualItemRect(levels->topLevelItem(number - 1));
    QTest::mouseClick(levels->viewport(), Qt::LeftButton, {}, place.center());
    QCOMPARE(m_fixture->game().level(), number - 1);
}

// A run of the level that is open, as a file.
QString TestWindowTrack::recorded() {
    m_fixture->makeSteps(20);
    QString error;
    if (!m_fixture->session().saveRun(m_fixture->path("run.rec"), &error)) qFatal("%s", qPrintable(error));
    return m_fixture->path("run.rec");
}

void TestWindowTrack::openedTrackIsABallAndATrail() {
    QCOMPARE(frame().ghosts.size(), size_t(0));
    const size_t trails = frame().trails.size();
    openTrack();
    m_fixture->makeSteps(50);
    const gl::Frame shown = frame();
    QCOMPARE(shown.ghosts.size(), size_t(1));
    const TrackPoint &point = m_track.points[50];
    QVERIFY(std::hypot(shown.ghosts[0].ball.position.x - point.x, shown.ghosts[0].ball.position.y - point.y) < 1e-6);
    QCOMPARE(shown.trails.size(), trails + 2);                     // its path, and the last part of it
    const QString picture = qEnvironmentVariable("TRACK_PICTURE"); // to look at
    if (!picture.isEmpty()) QVERIFY(m_fixture->window().grabTo(picture, nullptr));
}

void TestWindowTrack::trailStaysWhereItWasMeasuredWhenTheBallFalls() {
    openTrack();
    const double floor = now().current.position.z;
    phys_state fallen = now().current;
    fallen.position.z = -0.1;
    m_fixture->simulation().setState(fallen);
    QTRY_COMPARE(now().current.position.z, -0.1);
    m_fixture->makeSteps(1);
    const gl::Frame shown = frame();
    QCOMPARE(shown.ghosts.size(), size_t(1));
    QVERIFY(std::abs(shown.ghosts[0].ball.position.z - floor) < 1e-9);
    for (const gl::Trail &trail : {shown.trails.end()[-2], shown.trails.end()[-1]})
        for (const glm::dvec3 &point : trail.points) QVERIFY(std::abs(point.z - floor) < 1e-9);
}

void TestWindowTrack::droppedTableIsLaidOverTheRun() {
    m_fixture->drop(m_fixture->path("track.csv"));
    QVERIFY(m_fixture->session().track());
    QCOMPARE(m_fixture->find<QLineEdit>("track_file")->text(), m_fixture->path("track.csv"));
    QTRY_VERIFY(m_fixture->find<QPlainTextEdit>("track_report")->isVisible());
    QCOMPARE(m_fixture->session().level().name, QString("03"));
    auto *recent = m_fixture->find<QMenu>("recent_menu");
    recent->popup(m_fixture->window().mapToGlobal(QPoint(40, 40)));
    QCOMPARE(recent->actions().at(0)->text(), QString("&1  track.csv"));
    QTest::keyClick(recent, Qt::Key_Escape);
}

// And so is one of --track, which the window opens in the same way.
void TestWindowTrack::typedTableIsARecentOne() {
    m_fixture->trigger("show_track_dock");
    auto *box = m_fixture->find<QLineEdit>("track_file");
    box->setFocus();
    box->selectAll();
    m_fixture->type(m_fixture->path("track.csv"));
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->session().track());
    const QStringList recent = m_fixture->settings().value("window/recent").toStringList();
    QVERIFY2(!recent.isEmpty() && recent.front() == m_fixture->path("track.csv"), qPrintable(recent.join(' ')));
}

void TestWindowTrack::droppedTableThatIsWrongSaysWhy() {
    QFile file(m_fixture->path("half.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("t,x\n0,1\n") > 0);
    file.close();
    m_fixture->drop(file.fileName());
    QVERIFY(!m_fixture->session().track());
    auto *report = m_fixture->find<QPlainTextEdit>("track_report");
    QTRY_VERIFY(report->isVisible());
    QVERIFY2(report->toPlainText().contains("expected a column y in the header"), qPrintable(report->toPlainText()));
}

void TestWindowTrack::openedTrackSettlesARefusedName() {
    m_fixture->trigger("save_run");
    m_fixture->answerFile(m_fixture->path("none/run.csv"));
    QVERIFY(!m_fixture->window().messages().line().isEmpty());
    openTrack();
    QCOMPARE(m_fixture->window().messages().line(), QString());
}

// Enter gives the keyboard back to the view, too.
void TestWindowTrack::numberTypedIntoTheTableEndsTheEditOnce() {
    openTrack();
    auto *table = m_fixture->find<ui::FitTable>("track_quantities");
    int row = 0;
    while (table->item(row, ui::FitTable::Name)->text() != "Delay of the tilt") ++row;
    QTableWidgetItem *cell = table->item(row, ui::FitTable::Begin);
    table->scrollToItem(cell);
    const QPoint place = table->visualItemRect(cell).center();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, place);
    QVERIFY(qobject_cast<QLineEdit *>(QApplication::focusWidget()));
    m_fixture->key(Qt::Key_A, Qt::ControlModifier);
    m_fixture->type("-100");
    QTest::failOnWarning(QRegularExpression("called with an editor that does not belong"));
    m_fixture->key(Qt::Key_Return);
    QTRY_COMPARE(table->begin(m_fixture->parameters().inputs()).delay, -0.1);
    QTRY_VERIFY(m_fixture->window().view().hasFocus());
}

void TestWindowTrack::whereItEndsThereIsNoBall() {
    openTrack();
    chooseDt(m_fixture->session(), 0.1);
    m_fixture->makeSteps(25);
    QCOMPARE(frame().ghosts.size(), size_t(0));
}

void TestWindowTrack::plotsChooseItsCurves() {
    openTrack();
    auto *plots = m_fixture->find<ui::PlotStack>("plots");
    QMenu menu;
    plots->fillMenu(menu, &plots->first());
    for (const char *name : {"track_x", "track_distance", "wall_gap"}) {
        auto *entry = menu.findChild<QAction *>(name);
        QVERIFY2(entry, name);
        entry->trigger();
    }
    m_fixture->makeSteps(20);
    Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(19, sample));
    QVERIFY(std::abs(sample[Channel::TrackX] - m_track.points[20].x) < 1e-6);
    QVERIFY(sample[Channel::TrackDistance] >= 0.0);
    QVERIFY(sample[Channel::WallGap] > 0.0);
    QVERIFY(ui::textOf(plots->first().content()).endsWith("track_x,track_distance,wall_gap"));
}

// 2 s of 4 s that were run.
void TestWindowTrack::timeBarShowsItsSpan() {
    openTrack();
    chooseDt(m_fixture->session(), 0.1);
    m_fixture->makeSteps(40);
    m_fixture->window().refresh();
    const auto *slider = m_fixture->find<ui::SeekSlider>("time_slider");
    QVERIFY(slider->span());
    QCOMPARE(slider->span()->begin, 0);
    QCOMPARE(slider->span()->end, 19); // the step that ends at 2 s is the 20th
    m_fixture->session().showTrack(nullptr);
    m_fixture->window().refresh();
    QVERIFY(!slider->span());
}

void TestWindowTrack::spanBeginsWithTheRun() {
    openTrack();
    chooseDt(m_fixture->session(), 0.1);
    m_fixture->makeSteps(40);
    m_fixture->trigger("restart");
    QTRY_COMPARE(now().current.step, uint64_t(0));
    m_fixture->makeSteps(30);
    m_fixture->window().refresh();
    const auto *slider = m_fixture->find<ui::SeekSlider>("time_slider");
    QVERIFY(slider->span());
    QCOMPARE(slider->span()->begin, 0);
    QCOMPARE(slider->span()->end, 19);
}

void TestWindowTrack::otherLevelHidesItAndSaysSo() {
    openTrack();
    clickLevel(4);
    QVERIFY(!m_fixture->session().track());
    QVERIFY(!follow().isEnabled());
    QVERIFY2(report().startsWith("track.csv lies over level 03"), qPrintable(report()));
}

void TestWindowTrack::itsLevelBringsItBack() {
    openTrack();
    const QString before = report();
    clickLevel(4);
    clickLevel(3);
    QVERIFY(follow().isEnabled());
    QCOMPARE(report(), before);
    m_fixture->makeSteps(20);
    QCOMPARE(frame().ghosts.size(), size_t(1));
    Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(19, sample));
    QVERIFY(std::abs(sample[Channel::TrackX] - m_track.points[20].x) < 1e-6);
}

void TestWindowTrack::itsLevelBringsItBackWithoutWhatAFitHadFound() {
    openTrack();
    const double before = m_fixture->session().track()->points().front().x;
    BoardParameters fitted{initialInputs().params, 9.81, {}, 0.0, {}};
    fitted.frame.x = 0.01;
    m_fixture->session().showTrack(std::make_shared<ShownTrack>(m_track, fitted, 0.0));
    QVERIFY(m_fixture->session().track()->points().front().x != before);
    clickLevel(4);
    clickLevel(3);
    QCOMPARE(m_fixture->session().track()->points().front().x, before);
}

void TestWindowTrack::fitComesBackFromThePastOfAnotherLevel() {
    clickLevel(4);
    m_fixture->makeSteps(5);
    clickLevel(3);
    m_fixture->settings().setValue("track/quantities", "rolling_friction");
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    openTrack();
    const auto *table = m_fixture->find<QTableWidget>("track_quantities");
    const auto found = [&] {
        QStringList texts;
        for (int row = 0; row < table->rowCount(); ++row) texts << table->item(row, 2)->text();
        return texts.join(' ').trimmed();
    };
    click(m_fixture->find<QPushButton>("track_fit"));
    QTRY_VERIFY(!found().isEmpty());
    m_fixture->makeSteps(5);
    const QString foundBefore = found();
    const QString reportBefore = report();
    const auto isOfLevel = [this](const char *name) {
        m_fixture->window().refresh();
        return m_fixture->session().level().name == name;
    };
    m_fixture->session().lookAt(0);
    QTRY_VERIFY(isOfLevel("04"));
    QVERIFY2(report().startsWith("track.csv lies over level 03"), qPrintable(report()));
    QCOMPARE(found(), QString());
    QVERIFY(!m_fixture->find<QPushButton>("track_take_over")->isEnabled());
    m_fixture->press(Qt::Key_Escape);
    QTRY_VERIFY(isOfLevel("03"));
    QCOMPARE(report(), reportBefore);
    QCOMPARE(found(), foundBefore);
    QVERIFY(m_fixture->find<QPushButton>("track_take_over")->isEnabled());
}

// Also in its samples, before the window receives the other level.
void TestWindowTrack::recordingThatChangesTheLevelSamplesItInItsOwnOnly() {
    openTrack();
    m_fixture->makeSteps(20);
    m_fixture->session().startRecording(m_fixture->path("two.rec"));
    m_fixture->makeSteps(5);
    clickLevel(4);
    m_fixture->makeSteps(5);
    m_fixture->session().stopRecording();
    clickLevel(3);
    const SampleRing &samples = m_fixture->simulation().samples();
    QVERIFY(m_fixture->session().openRecording(m_fixture->path("two.rec")));
    m_fixture->simulation().pause();
    Sample last;
    const auto showLast = [&](uint64_t position) { // without telling the window of the moment
        const uint64_t seek = m_fixture->simulation().seek(position);
        QTRY_COMPARE(now().replay.seeks, seek);
        QVERIFY(samples.read(samples.last() - 1, last));
    };
    showLast(9);
    QVERIFY(std::isnan(last[Channel::TrackX]));
    showLast(4);
    QVERIFY(!std::isnan(last[Channel::TrackX]));
}

void TestWindowTrack::recordingOfItsLevelKeepsIt() {
    openTrack();
    m_fixture->drop(recorded());
    QTRY_VERIFY(m_fixture->session().isReplaying());
    QVERIFY(m_fixture->session().track());
    m_fixture->press(Qt::Key_W, Qt::ControlModifier);
    QVERIFY(!m_fixture->session().isReplaying());
    QVERIFY(m_fixture->session().track());
    QVERIFY(follow().isEnabled());
}

void TestWindowTrack::recordingOfAnotherLevelHidesIt() {
    clickLevel(4);
    const QString file = recorded();
    clickLevel(3);
    openTrack();
    m_fixture->drop(file);
    QTRY_VERIFY(m_fixture->session().isReplaying());
    QVERIFY(!m_fixture->session().track());
    m_fixture->press(Qt::Key_W, Qt::ControlModifier);
    QVERIFY(m_fixture->session().track());
}

void TestWindowTrack::takingOverThePastEndsRollAlong() {
    openTrack();
    click(&follow());
    QTRY_VERIFY(now().current.step > 20);
    m_fixture->press(Qt::Key_Comma);
    QVERIFY(m_fixture->session().isInPast());
    m_fixture->press(Qt::Key_G);
    QVERIFY(!m_fixture->session().isInPast());
    QVERIFY(!follow().isChecked());
}

void TestWindowTrack::rollAlongStartsWhereItStarted() {
    openTrack();
    chooseStepper(m_fixture->session(), "exact");
    click(&follow());
    QVERIFY(follow().isChecked());
    QTRY_VERIFY(now().current.time > 1.0);
    Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(50, sample));
    QVERIFY2(sample[Channel::TrackDistance] < 1e-4, qPrintable(QString::number(sample[Channel::TrackDistance])));
}

void TestWindowTrack::slidersShowTheTiltThatItRollsAlongUnder() {
    openTrack();
    click(&follow());
    QTRY_VERIFY(now().current.time > 1.0);
    m_fixture->trigger("run");
    QTRY_VERIFY(!now().running);
    m_fixture->window().refresh();
    const auto *tilt = m_fixture->find<ui::NumberBox>("tilt_x_box");
    QCOMPARE(tilt->value(), std::round(degrees(now().inputs.tilt.x) * 10.0) / 10.0);
    QVERIFY(tilt->value() != 0.0);
    QVERIFY(!tilt->isEnabled());
    click(&follow());
    QCOMPARE(tilt->value(), 0.0);
    QVERIFY(tilt->isEnabled());
}

void TestWindowTrack::keysTakeTheBoardBack() {
    openTrack();
    click(&follow());
    QVERIFY(m_fixture->session().isFollowingTrack());
    m_fixture->window().view().setFocus();
    QTest::keyPress(&m_fixture->window().view(), Qt::Key_Left);
    QTRY_VERIFY(!m_fixture->session().isFollowingTrack());
    QTest::keyRelease(&m_fixture->window().view(), Qt::Key_Left);
    QVERIFY(!follow().isChecked());
}

QTEST_MAIN(TestWindowTrack)
#include "tst_window_track.moc"
