// SPDX-License-Identifier: MIT
// A measured ball in the window: its file by name, the fit in the background, values taken over and back.
#include "ui/track/track_dock.h"

#include "core/setup/tables.h"
#include "inspector/dock_fixture.h"
#include "inspector/track/made_track.h"

#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>

using namespace inspector;
using namespace inspector::ui;

class TestTrackDock : public QObject, support::DockFixture<TrackDock> {
    Q_OBJECT

private slots:
    void initTestCase();
    void withoutAFileThereIsNothingToFit();
    void fileThatCantBeReadIsSaid();
    void wrongUnitsAreSaid();
    void fitTellsTheVerdictAndTheValues();
    void valuesAreTakenOver();
    void oneUndoTakesThemBack();
    void otherLevelForgetsTheFit();

private:
    void type(const char *name, const QString &text) {
        auto &edit = find<QLineEdit>(name);
        edit.setFocus();
        QTest::keyClick(&edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(&edit, Qt::Key_Delete);
        QTest::keyClicks(&edit, text);
    }
    void click(const char *name) { QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton); }
    QString report() { return find<QPlainTextEdit>("track_report").toPlainText(); }
    double value(const char *id) {
        const Parameters &parameters = m_session->parameters();
        return parameters.value(parameters.indexOf(QLatin1String(id)));
    }

    BoardGuess m_truth = support::drawTruth(PHYS_MODEL_ROLLING, 2);
};

namespace {

QByteArray csvOf(const Track &track) {
    QByteArray csv = "t,x,y,tilt_x,tilt_y\n";
    size_t tilt = 0;
    for (const TrackPoint &point : track.points) {
        while (tilt + 1 < track.tilts.size() && track.tilts[tilt + 1].time <= point.time + 1e-9) ++tilt;
        for (const double number :
             {point.time, point.x, point.y, degrees(track.tilts[tilt].tilt.x), degrees(track.tilts[tilt].tilt.y)})
            csv += exactText(number) + ',';
        csv.back() = '\n';
    }
    return csv;
}

} // namespace

void TestTrackDock::initTestCase() {
    const QString error = open(3);
    QVERIFY2(error.isEmpty(), qPrintable(error));
    const Track track =
        support::makeTrack(m_session->registry(), m_session->scene(), m_truth, {.duration = 8.0, .seed = 2});
    QFile file(m_folder.filePath("track.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(csvOf(track));
}

void TestTrackDock::withoutAFileThereIsNothingToFit() {
    QVERIFY(!find<QPushButton>("track_fit").isEnabled());
    QVERIFY(!find<QPushButton>("track_take_over").isEnabled());
}

void TestTrackDock::fileThatCantBeReadIsSaid() {
    type("track_file", m_folder.filePath("missing.csv"));
    click("track_fit");
    QVERIFY2(report().contains("missing.csv"), qPrintable(report()));
}

void TestTrackDock::wrongUnitsAreSaid() {
    type("track_file", m_folder.filePath("track.csv"));
    type("track_units", "x=miles");
    click("track_fit");
    QVERIFY2(report().endsWith("found 'x=miles'"), qPrintable(report()));
    type("track_units", "");
}

void TestTrackDock::fitTellsTheVerdictAndTheValues() {
    click("track_fit");
    QCOMPARE(find<QPushButton>("track_fit").text(), QString("Cancel"));
    QTRY_COMPARE_WITH_TIMEOUT(find<QPushButton>("track_fit").text(), QString("Fit"), kLong);
    QVERIFY2(report().contains("verdict: the rolling model suffices"), qPrintable(report()));
    QVERIFY2(report().contains("restitution_wall"), qPrintable(report()));
    const QString picture = qEnvironmentVariable("TRACK_PICTURE"); // to look at
    if (!picture.isEmpty()) QVERIFY(m_dock->grab().save(picture));
}

void TestTrackDock::valuesAreTakenOver() {
    QVERIFY(find<QPushButton>("track_take_over").isEnabled());
    click("track_take_over");
    QVERIFY(std::abs(value("restitution_wall") - m_truth.params.restitution_wall) < 0.001);
    QVERIFY(std::abs(value("rolling_friction") - m_truth.params.rolling_friction) < 0.0001);
    QCOMPARE(m_undo.count(), 1);
}

void TestTrackDock::oneUndoTakesThemBack() {
    m_undo.undo();
    QCOMPARE(value("restitution_wall"), 0.5);
    QCOMPARE(value("rolling_friction"), 0.002);
}

void TestTrackDock::otherLevelForgetsTheFit() {
    QVERIFY(m_session->openLevel(m_session->levels()[4]));
    QVERIFY(!find<QPushButton>("track_take_over").isEnabled());
}

QTEST_MAIN(TestTrackDock)
#include "tst_track_dock.moc"
