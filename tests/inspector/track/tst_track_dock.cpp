// SPDX-License-Identifier: MIT
// A measured ball in the window: opening its file, the fit in the background, applying and undoing values.
#include "ui/track/track_dock.h"

#include "inspector/dock_fixture.h"
#include "inspector/track/made_track.h"
#include "support/files.h"
#include "ui/parts/theme.h"
#include "ui/track/fit_table.h"
#include "ui/track/residual_plot.h"

#include <QImage>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

using namespace inspector;
using namespace inspector::ui;

class TestTrackDock : public QObject, support::DockFixture<TrackDock> {
    Q_OBJECT

private slots:
    void initTestCase();
    void withoutAFileThereIsNothingToFit();
    void withoutAFitThereIsNothingToSave();
    void fileThatIsntThereIsSaid();
    void wrongUnitsAreSaid();
    void enterInTheUnitsReadsTheTableAnew();
    void pointsBesideTheBoardAreSaid();
    void fitTellsTheVerdictAndTheValues();
    void valuesAreTakenOver();
    void ballRollsAlongFromTheStartThatWasFitted();
    void oneUndoTakesThemBack();
    void tableShowsWhatWasFound();
    void resultSaysOfWhichParametersItIs();
    void resultSaysOfWhichFrameItIs();
    void resultIsSavedWithWhatItBeganWith();
    void savedPictureIsLargeEnoughHoweverSmallTheDock();
    void takeOverSetsWhatTheFitAssumed();
    void onlyWhatIsTickedIsLookedFor();
    void typedBeginningsCount();
    void wrongBeginningStaysInRed();
    void nothingIsFittedFromAWrongBeginning();
    void ticksAreRemembered();
    void foundIsReadWhole();
    void narrowDockHasRoomForWhatWasFound();
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

    FitTable &table() { return find<FitTable>("track_quantities"); }
    int rowOf(const char *label) {
        for (int row = 0; row < table().rowCount(); ++row)
            if (table().item(row, FitTable::Name)->text() == QLatin1String(label)) return row;
        qFatal("no row %s", label);
    }
    // With the mouse, onto its box.
    void tick(const char *label) {
        const QRect cell = table().visualItemRect(table().item(rowOf(label), FitTable::Name));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, QPoint(cell.left() + 10, cell.center().y()));
    }
    QString text(const char *label, FitTable::Column column) { return table().item(rowOf(label), column)->text(); }
    // Into the cell of its beginning.
    void typeBegin(const char *label, const QString &number) {
        const QPoint place = table().visualItemRect(table().item(rowOf(label), FitTable::Begin)).center();
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, place);
        auto *edit = qobject_cast<QLineEdit *>(QApplication::focusWidget()); // one before goes a little later
        QVERIFY(edit);
        edit->selectAll();
        QTest::keyClicks(edit, number);
        QTest::keyClick(edit, Qt::Key_Return);
        QApplication::processEvents(); // what was typed counts a little later
    }
    void nameFile() { type("track_file", m_folder.filePath("track.csv")); }
    void fit() {
        nameFile();
        click("track_fit");
        QTRY_COMPARE_WITH_TIMEOUT(find<QPushButton>("track_fit").text(), QString("Fit"), kLong);
    }

    // So that each fact can be run by itself.
    void fitOnce() {
        if (!find<QPushButton>("track_take_over").isEnabled()) fit();
        QVERIFY2(find<QPushButton>("track_take_over").isEnabled(), qPrintable(report()));
    }

    BoardParameters m_truth = support::drawTruth(PHYS_MODEL_ROLLING, 2);
};

void TestTrackDock::initTestCase() {
    const QString error = open(3);
    QVERIFY2(error.isEmpty(), qPrintable(error));
    const Track track =
        support::makeTrack(m_session->registry(), m_session->scene(), m_truth, {.duration = 8.0, .seed = 2});
    QFile file(m_folder.filePath("track.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(support::csvOf(track));
}

void TestTrackDock::withoutAFileThereIsNothingToFit() {
    QVERIFY(!find<QPushButton>("track_fit").isEnabled());
    QVERIFY(!find<QPushButton>("track_take_over").isEnabled());
}

void TestTrackDock::withoutAFitThereIsNothingToSave() {
    QString error;
    QVERIFY(!m_dock->save(m_folder.filePath("none.csv"), &error));
    QVERIFY2(error.endsWith("nothing has been fitted yet"), qPrintable(error));
    QVERIFY(!QFile::exists(m_folder.filePath("none.csv")));
}

void TestTrackDock::fileThatIsntThereIsSaid() {
    auto &file = find<QLineEdit>("track_file");
    type("track_file", m_folder.filePath("missing.csv"));
    QVERIFY(!find<QPushButton>("track_fit").isEnabled());
    QTest::keyClick(&file, Qt::Key_Return);
    QVERIFY2(report().contains("missing.csv"), qPrintable(report()));
    QVERIFY2(file.toolTip().endsWith("missing.csv': there is no such file"), qPrintable(file.toolTip()));
    QVERIFY(!find<QPushButton>("track_fit").isEnabled());
    nameFile();
    QVERIFY(find<QPushButton>("track_fit").isEnabled());
    QVERIFY(!file.toolTip().contains("missing.csv"));
}

void TestTrackDock::wrongUnitsAreSaid() {
    nameFile();
    type("track_units", "x=miles");
    click("track_fit");
    QVERIFY2(report().endsWith("found 'x=miles'"), qPrintable(report()));
    type("track_units", "");
}

void TestTrackDock::enterInTheUnitsReadsTheTableAnew() {
    nameFile();
    const auto &rollAlong = find<QPushButton>("track_follow");
    type("track_units", "px=abc, t=-1");
    QTest::keyClick(&find<QLineEdit>("track_units"), Qt::Key_Return);
    QVERIFY2(report().contains("px=abc"), qPrintable(report()));
    type("track_units", "");
    QTest::keyClick(&find<QLineEdit>("track_units"), Qt::Key_Return);
    QVERIFY2(!report().contains("px=abc"), qPrintable(report()));
    QVERIFY(rollAlong.isEnabled());
}

void TestTrackDock::pointsBesideTheBoardAreSaid() {
    nameFile();
    const auto open = [this] { QTest::keyClick(&find<QLineEdit>("track_file"), Qt::Key_Return); };
    open();
    QVERIFY2(!report().contains("beside the board"), qPrintable(report()));
    typeBegin("Frame x", "1000");
    open();
    QVERIFY2(report().contains("481 of 481 points lie beside the board"), qPrintable(report()));
    typeBegin("Frame x", "0");
}

void TestTrackDock::fitTellsTheVerdictAndTheValues() {
    nameFile();
    click("track_fit");
    QCOMPARE(find<QPushButton>("track_fit").text(), QString("Cancel"));
    QTRY_COMPARE_WITH_TIMEOUT(find<QPushButton>("track_fit").text(), QString("Fit"), kLong);
    QVERIFY2(report().contains("verdict: the rolling model suffices"), qPrintable(report()));
    QVERIFY2(report().contains("bounces: "), qPrintable(report()));
    QVERIFY2(!report().contains("±"), qPrintable(report()));       // those are in the table beside it
    const QString picture = qEnvironmentVariable("TRACK_PICTURE"); // to look at
    if (!picture.isEmpty()) QVERIFY(m_dock->grab().save(picture));
}

void TestTrackDock::valuesAreTakenOver() {
    fitOnce();
    QVERIFY(find<QPushButton>("track_take_over").isEnabled());
    click("track_take_over");
    QVERIFY(std::abs(value("restitution_wall") - m_truth.params.restitution_wall) < 0.001);
    QVERIFY(std::abs(value("rolling_friction") - m_truth.params.rolling_friction) < 0.0001);
    QCOMPARE(m_undo.count(), 1);
}

// Not from the one that the first points tell. The made ball starts at rest.
void TestTrackDock::ballRollsAlongFromTheStartThatWasFitted() {
    fitOnce();
    const auto speed = [](const phys_state &state) { return std::hypot(state.velocity.x, state.velocity.y); };
    const phys_scene *scene = m_session->scene().get();
    const double guessed = speed(m_session->track()->start(scene));
    click("track_follow");
    m_session->simulation().pause();
    const double fitted = speed(m_session->track()->start(scene));
    QVERIFY2(fitted < guessed, qPrintable(QStringLiteral("%1 %2").arg(fitted).arg(guessed)));
    click("track_follow");
    QVERIFY(!m_session->isFollowingTrack());
}

void TestTrackDock::oneUndoTakesThemBack() {
    m_undo.undo();
    QCOMPARE(value("restitution_wall"), 0.5);
    QCOMPARE(value("rolling_friction"), 0.002);
}

void TestTrackDock::tableShowsWhatWasFound() {
    fitOnce();
    QVERIFY2(text("Restitution, walls", FitTable::Found).contains(" ± "),
             qPrintable(text("Restitution, walls", FitTable::Found)));
    QCOMPARE(text("Restitution, floor", FitTable::Found), QString()); // it wasn't fitted
    QCOMPARE(text("Sliding friction", FitTable::Found), QString("not determined: no effect in the rolling model"));
    QCOMPARE(text("Restitution, walls", FitTable::Begin), QString("0.5"));
    QCOMPARE(text("Delay of the tilt", FitTable::Unit), QString("ms"));
}

void TestTrackDock::resultSaysOfWhichParametersItIs() {
    fitOnce();
    QVERIFY2(!report().contains("other parameters"), qPrintable(report()));
    QVERIFY(m_session->parameters().set({{QStringLiteral("rolling_friction"), 0.01}})); // which it has found itself
    QVERIFY2(!report().contains("other parameters"), qPrintable(report()));
    QVERIFY(m_session->parameters().set({{QStringLiteral("gravity"), 1.62}}));
    QVERIFY2(report().startsWith("Found with other parameters than are set now: Gravity of 9.81 m/s²."),
             qPrintable(report()));
    QVERIFY2(report().contains("verdict: "), qPrintable(report()));
    QVERIFY(
        m_session->parameters().set({{QStringLiteral("gravity"), 9.81}, {QStringLiteral("rolling_friction"), 0.002}}));
    QVERIFY2(!report().contains("other parameters"), qPrintable(report()));
}

// The delay is looked for, the frame isn't.
void TestTrackDock::resultSaysOfWhichFrameItIs() {
    fitOnce();
    typeBegin("Delay of the tilt", "20");
    QVERIFY2(!report().contains("other parameters"), qPrintable(report()));
    typeBegin("Frame x", "3");
    QVERIFY2(report().startsWith("Found with other parameters than are set now: Frame x of 0 mm."),
             qPrintable(report()));
    typeBegin("Frame x", "0");
    typeBegin("Delay of the tilt", "0");
    QVERIFY2(!report().contains("other parameters"), qPrintable(report()));
}

void TestTrackDock::resultIsSavedWithWhatItBeganWith() {
    fitOnce();
    QSignalSpy wanted(m_dock.get(), &TrackDock::saveWanted);
    QTest::mouseClick(&find<QToolButton>("track_save"), Qt::LeftButton);
    QCOMPARE(wanted.size(), 1);
    QString error;
    QVERIFY(m_session->parameters().set({{QStringLiteral("gravity"), 1.62}})); // since
    QVERIFY2(m_dock->save(m_folder.filePath("fit.csv"), &error), qPrintable(error));
    QVERIFY(m_session->parameters().set({{QStringLiteral("gravity"), 9.81}}));
    const QByteArray table = support::contentOf(m_folder.filePath("fit.csv"));
    QVERIFY2(table.count('\n') > 100, table.constData());
    const QByteArray beside = support::contentOf(m_folder.filePath("fit.csv.txt"));
    for (const char *line :
         {"\nlevel 03\n", "track.csv\n", "\ntrack-frame 0,0,0,1\n", "\ngravity 9.81 m/s^2\n", "verdict: "})
        QVERIFY2(beside.contains(line), qPrintable(QString("%1 in %2").arg(QString(line), QString(beside))));
    QVERIFY2(m_dock->save(m_folder.filePath("fit.png"), &error), qPrintable(error));
    QVERIFY(!m_dock->save(m_folder.filePath("fit.doc"), &error) && error.contains("fit.doc"));
}

// At two pixels per screen pixel.
void TestTrackDock::savedPictureIsLargeEnoughHoweverSmallTheDock() {
    fitOnce();
    m_dock->findChild<ResidualPlot *>()->resize(200, 100);
    QString error;
    QVERIFY2(m_dock->save(m_folder.filePath("fit.png"), &error), qPrintable(error));
    QCOMPARE(QImage(m_folder.filePath("fit.png")).size(), QSize(1280, 480));
}

void TestTrackDock::takeOverSetsWhatTheFitAssumed() {
    fitOnce();
    QVERIFY(m_session->parameters().set({{QStringLiteral("gravity"), 1.62}}));
    click("track_take_over");
    QCOMPARE(value("gravity"), 9.81);
    QVERIFY(std::abs(value("rolling_friction") - m_truth.params.rolling_friction) < 0.0001);
    QVERIFY2(!report().contains("other parameters"), qPrintable(report()));
    m_undo.undo();
    QCOMPARE(value("gravity"), 1.62);
    QCOMPARE(value("rolling_friction"), 0.002);
    QVERIFY(m_session->parameters().set({{QStringLiteral("gravity"), 9.81}}));
}

void TestTrackDock::onlyWhatIsTickedIsLookedFor() {
    tick("Delay of the tilt");
    QVERIFY(table().item(rowOf("Delay of the tilt"), FitTable::Name)->checkState() == Qt::Unchecked);
    QVERIFY(!table().words().contains("delay"));
    typeBegin("Delay of the tilt", QString::number(m_truth.delay * 1e3, 'g', 12));
    fit();
    QCOMPARE(text("Delay of the tilt", FitTable::Found), QString());
    QVERIFY2(!report().contains("delay"), qPrintable(report()));
    QVERIFY2(report().contains("verdict: the rolling model suffices"), qPrintable(report()));
}

// What isn't fitted is taken as true.
void TestTrackDock::typedBeginningsCount() {
    typeBegin("Delay of the tilt", "-200");
    QCOMPARE(table().begin(m_session->parameters().inputs()).delay, -0.2);
}

void TestTrackDock::wrongBeginningStaysInRed() {
    const QTableWidgetItem *cell = table().item(rowOf("Delay of the tilt"), FitTable::Begin);
    const QString usualTip = cell->toolTip();
    typeBegin("Delay of the tilt", "-200");
    typeBegin("Delay of the tilt", "1e400");
    QCOMPARE(table().begin(m_session->parameters().inputs()).delay, -0.2);
    typeBegin("Frame x", "0"); // all cells are written anew
    QVERIFY(m_session->parameters().set({{QStringLiteral("gravity"), 9.0}}));
    QVERIFY(m_session->parameters().set({{QStringLiteral("gravity"), 9.81}}));
    QCOMPARE(cell->text(), QString("1e400"));
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        applyTheme(theme);
        QTRY_COMPARE(cell->foreground().color(), accentsFor(QApplication::palette()).alarm);
    }
    applyTheme(Theme::System);
    QVERIFY2(cell->toolTip().contains("found '1e400'"), qPrintable(cell->toolTip()));
    typeBegin("Delay of the tilt", "-100");
    QCOMPARE(cell->foreground().style(), Qt::NoBrush);
    QCOMPARE(cell->toolTip(), usualTip);
    QCOMPARE(table().begin(m_session->parameters().inputs()).delay, -0.1);
}

void TestTrackDock::nothingIsFittedFromAWrongBeginning() {
    nameFile();
    typeBegin("Delay of the tilt", "soon");
    click("track_fit");
    QCOMPARE(find<QPushButton>("track_fit").text(), QString("Fit"));
    QVERIFY2(report().startsWith("delay: ") && report().endsWith("found 'soon'"), qPrintable(report()));
    typeBegin("Delay of the tilt", "0");
}

void TestTrackDock::ticksAreRemembered() {
    if (table().words().contains("delay")) tick("Delay of the tilt");
    const TrackDock other(*m_session, m_undo);
    QVERIFY(!other.findChild<FitTable *>("track_quantities")->words().contains("delay"));
    QVERIFY(other.findChild<FitTable *>("track_quantities")->words().contains("restitution_wall"));
}

// Also where a reason needs two lines.
void TestTrackDock::foundIsReadWhole() {
    fitOnce();
    const QSize before = m_dock->size();
    for (const int width : {1200, 760}) {
        m_dock->resize(width, 420);
        QApplication::processEvents();
        const auto isWhole = [this](const char *label) {
            const QRect cell = table().visualItemRect(table().item(rowOf(label), FitTable::Found));
            const int margin = table().style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1;
            const QRect needed = table().fontMetrics().boundingRect(cell.adjusted(margin, 0, -margin, 0),
                                                                    Qt::TextWordWrap, text(label, FitTable::Found));
            return needed.height() <= cell.height() && needed.width() <= cell.width() - 2 * margin;
        };
        QTRY_VERIFY2(isWhole("Sliding friction"), qPrintable(QString::number(width)));
        QTRY_VERIFY2(isWhole("Restitution, walls"), qPrintable(QString::number(width)));
    }
    m_dock->resize(before);
}

// Beside the bounces in a window of 1280 pixels.
void TestTrackDock::narrowDockHasRoomForWhatWasFound() {
    fitOnce();
    const QSize before = m_dock->size();
    m_dock->resize(465, 300);
    const auto placeOf = [this](const QWidget &widget) { return widget.mapTo(m_dock.get(), QPoint(0, 0)); };
    auto &residuals = *m_dock->findChild<ResidualPlot *>();
    QTRY_VERIFY(placeOf(residuals).y() > placeOf(find<QPlainTextEdit>("track_report")).y());
    const QString found = text("Restitution, walls", FitTable::Found);
    QVERIFY(!found.isEmpty());
    const int room =
        table().columnWidth(FitTable::Found) - 2 * table().style()->pixelMetric(QStyle::PM_FocusFrameHMargin);
    QVERIFY2(table().fontMetrics().horizontalAdvance(found) < room, qPrintable(QString::number(room)));
    const int height = table().rowHeight(rowOf("Restitution, walls"));
    QVERIFY2(height < 2 * table().fontMetrics().height(), qPrintable(QString::number(height)));
    m_dock->resize(before);
    QTRY_COMPARE(placeOf(residuals).y(), placeOf(find<QPlainTextEdit>("track_report")).y());
}

void TestTrackDock::otherLevelForgetsTheFit() {
    fitOnce();
    QVERIFY(find<QPushButton>("track_take_over").isEnabled());
    QVERIFY(m_session->openLevel(m_session->levels().listed()[4]));
    QVERIFY(!find<QPushButton>("track_take_over").isEnabled());
    QCOMPARE(text("Restitution, walls", FitTable::Found), QString());
    QVERIFY2(!report().contains("verdict"), qPrintable(report()));
    QCOMPARE(m_dock->findChild<ResidualPlot *>()->graph(0)->dataCount(), 0);
}

QTEST_MAIN(TestTrackDock)
#include "tst_track_dock.moc"
