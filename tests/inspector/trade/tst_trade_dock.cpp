// SPDX-License-Identifier: MIT
// The trade in the window: measured in the background, chosen by hand, put to use.
#include "ui/trade/trade_dock.h"

#include "inspector/dock_fixture.h"
#include "ui/trade/trade_chart.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QSpinBox>
#include <QTableView>
#include <QToolTip>

#include <algorithm>
#include <cmath>

using namespace inspector;
using namespace inspector::ui;

class TestTradeDock : public QObject, support::DockFixture<TradeDock> {
    Q_OBJECT

private slots:
    void initTestCase();
    void measuringFillsTableAndChart();
    void rowsShownStayUsableWhileMeasuredAnew();
    void headerSortsByTheFigure();
    void tighterToleranceRecommendsNothingWorse();
    void answerKeepsWhatWasAskedFor();
    void pointUnderTheMouseIsNamed();
    void clickOnAPointChoosesIt();
    void useAppliesStepperAndStepSize();
    void oneUndoTakesTheUseBack();
    void seedIsTheRandomSchedules();
    void fileGivesTheSchedule();
    void fileThatCantBeReadIsSaid();
    void reasonOfUnknownsIsWhole();
    void otherModelShowsItsOwnPoints();
    void cancelKeepsWhatIsKnown();

private:
    QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
    QTableView &table() { return find<QTableView>("trade_table"); }
    TradeChart &chart() { return find<TradeChart>("trade_chart"); }
    QPushButton &measure() { return find<QPushButton>("trade_measure"); }
    bool isMeasuring() { return measure().text() == "Cancel"; }
    QString remark() { return find<QLabel>("trade_remark").text(); }
    int chosenRow() {
        const QModelIndexList rows = table().selectionModel()->selectedRows();
        return rows.isEmpty() ? -1 : rows.first().row();
    }
    void choosePoint(const char *stepper, const char *stepSize);
    QPointF placeOnChart();
    QString tipAt(const QPointF &place);
};

void TestTradeDock::initTestCase() {
    const QString error = open(1);
    QVERIFY2(error.isEmpty(), qPrintable(error));
    find<QDoubleSpinBox>("trade_duration").setValue(0.5);
}

void TestTradeDock::measuringFillsTableAndChart() {
    QVERIFY(!find<QPushButton>("trade_use").isEnabled());
    QVERIFY(!chart().legend->visible());                             // there is nothing that it could name
    QCOMPARE(find<QLineEdit>("trade_unknowns").cursorPosition(), 0); // so that its beginning is seen
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QVERIFY(isMeasuring());
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    // Every stepper at seven step sizes; the session's own, 10 ms, is one of them.
    QCOMPARE(table().model()->rowCount(), int(phys_registry_count(nullptr)) * 7);
    QVERIFY(remark().contains("compared up to 0.50 s"));
    QVERIFY2(find<QLabel>("trade_answer").text().contains(" mm in 0.5 s;"),
             qPrintable(find<QLabel>("trade_answer").text()));
    QVERIFY(chart().legend->visible());
    QCOMPARE(find<QLabel>("trade_remark").text().left(9), QString("schedule ")); // a box has the unknowns
    const QString picture = qEnvironmentVariable("TRADE_PICTURE");               // to look at
    if (!picture.isEmpty()) QVERIFY(m_dock->grab().save(picture));
}

// Before the first of the new figures replaces them.
void TestTradeDock::rowsShownStayUsableWhileMeasuredAnew() {
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QVERIFY(isMeasuring());
    table().scrollToTop();
    const int other = chosenRow() == 0 ? 1 : 0;
    const QPoint place = table().visualRect(table().model()->index(other, 0)).center();
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place);
    QCOMPARE(chosenRow(), other);
    QVERIFY(find<QPushButton>("trade_use").isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    QCOMPARE(table().model()->rowCount(), int(phys_registry_count(nullptr)) * 7);
}

void TestTradeDock::headerSortsByTheFigure() {
    table().sortByColumn(1, Qt::AscendingOrder);
    QCOMPARE(cell(0, 1), QString("0.1 ms"));
    table().sortByColumn(1, Qt::DescendingOrder);
    QCOMPARE(cell(0, 1), QString("16.67 ms")); // as a text "5 ms" would be first
}

// To ask for less error can't make the recommended error larger.
void TestTradeDock::tighterToleranceRecommendsNothingWorse() {
    QSlider &slider = find<QSlider>("trade_tolerance");
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_End); // 100 mm
    QVERIFY(chosenRow() >= 0);
    const double loose = cell(chosenRow(), 3).toDouble();
    QTest::keyClick(&slider, Qt::Key_Home); // a nanometre, 1.7e-7 radii
    QVERIFY(chosenRow() >= 0);
    const double tight = cell(chosenRow(), 3).toDouble();
    QVERIFY2(tight <= 1.7e-7 && tight <= loose, qPrintable(QString("%1 %2").arg(tight).arg(loose)));
}

QPointF TestTradeDock::placeOnChart() {
    for (size_t i = 0; i < 42; ++i) {
        const std::optional<QPointF> place = chart().placeOf(i);
        if (place && chart().pointAt(*place) == i) return *place;
    }
    qFatal("no point is drawn");
}

// The mouse comes anew each time: a tip goes away with whatever happens to the window meanwhile.
QString TestTradeDock::tipAt(const QPointF &place) {
    QTest::mouseMove(&chart(), {1, 1});
    QTest::mouseMove(&chart(), place.toPoint());
    return QToolTip::text();
}

// Of what it says, too: not the error of another span.
void TestTradeDock::answerKeepsWhatWasAskedFor() {
    static const QRegularExpression off("off by ([0-9.e+-]+) mm");
    QSlider &slider = find<QSlider>("trade_tolerance");
    slider.setFocus();
    for (int notch = slider.maximum(); notch > slider.minimum(); notch -= slider.pageStep()) {
        slider.setValue(notch);
        const QString answer = find<QLabel>("trade_answer").text();
        const double asked = 1.0 * std::pow(10.0, double(notch) / slider.pageStep());
        QVERIFY2(off.match(answer).captured(1).toDouble() <= 1.05 * asked, qPrintable(answer));
    }
}

void TestTradeDock::pointUnderTheMouseIsNamed() {
    const QPointF place = placeOnChart();
    QTRY_VERIFY(!tipAt(place).isEmpty());
    QVERIFY2(QToolTip::text().contains("max error:") && QToolTip::text().contains(" ms, rolling"),
             qPrintable(QToolTip::text()));
}

void TestTradeDock::clickOnAPointChoosesIt() {
    const QPointF place = placeOnChart();
    table().clearSelection();
    QTest::mouseClick(&chart(), Qt::LeftButton, {}, place.toPoint());
    QVERIFY(chosenRow() >= 0);
    QTRY_VERIFY(tipAt(place).startsWith(cell(chosenRow(), 0) + ", " + cell(chosenRow(), 1)));
    QVERIFY(find<QPushButton>("trade_use").isEnabled());
}

void TestTradeDock::choosePoint(const char *stepper, const char *stepSize) {
    for (int row = 0; row < table().model()->rowCount(); ++row)
        if (cell(row, 0) == stepper && cell(row, 1) == stepSize) table().selectRow(row);
}

void TestTradeDock::useAppliesStepperAndStepSize() {
    choosePoint("rk4", "2 ms");
    QTest::mouseClick(&find<QPushButton>("trade_use"), Qt::LeftButton);
    QCOMPARE(m_session->stepperId(), QByteArray("rk4"));
    QVERIFY(m_session->dt() == 0.002);
    QCOMPARE(m_session->parameters().inputs().params.model, uint32_t(PHYS_MODEL_ROLLING));
}

// Stepper, step size and model together, with the value of the row that only the first stepper has.
void TestTradeDock::oneUndoTakesTheUseBack() {
    const Stepping before{"symplectic-euler", 0.005, {{"model", PHYS_MODEL_RIGID}, {"as_reported", 1.0}}};
    QVERIFY(m_session->setStepping(before));
    QCOMPARE(m_session->stepping(), before);
    const int steps = m_undo.index();
    choosePoint("exact", "10 ms");
    QTest::mouseClick(&find<QPushButton>("trade_use"), Qt::LeftButton);
    const Stepping after{"exact", 0.01, {{"model", PHYS_MODEL_ROLLING}}};
    QCOMPARE(m_session->stepping(), after);
    QCOMPARE(m_undo.index(), steps + 1);
    m_undo.undo();
    QCOMPARE(m_session->stepping(), before);
    QTRY_COMPARE(m_session->simulation().latest().dt, 0.005);
    QTRY_COMPARE(m_session->simulation().latest().inputs.params.model, uint32_t(PHYS_MODEL_RIGID));
    QTRY_COMPARE(m_session->simulation().latest().inputs.params.stepper[0], 1.0);
    m_undo.redo();
    QCOMPARE(m_session->stepping(), after);
}

void TestTradeDock::seedIsTheRandomSchedules() {
    auto &kind = find<QComboBox>("trade_schedule");
    auto &seed = find<QSpinBox>("trade_seed");
    QVERIFY(!seed.isVisible());
    kind.setCurrentText("Random tilts");
    QVERIFY(seed.isVisible());
    seed.setValue(7);
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(table().model()->rowCount() > 0, kLong);
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    QVERIFY2(remark().contains("schedule random:7,"), qPrintable(remark()));
}

void TestTradeDock::fileGivesTheSchedule() {
    const QString path = m_folder.filePath("tilts.txt");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("0 2 0\n0.25 0 -3\n");
    file.close();
    find<QComboBox>("trade_schedule").setCurrentText("Tilts from a file");
    QVERIFY(!find<QSpinBox>("trade_seed").isVisible());
    QVERIFY(!measure().isEnabled()); // no file yet
    find<QLineEdit>("trade_file").setText(path);
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(table().model()->rowCount() > 0, kLong);
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    QVERIFY2(remark().contains("schedule " + path + ","), qPrintable(remark()));
}

void TestTradeDock::fileThatCantBeReadIsSaid() {
    find<QComboBox>("trade_schedule").setCurrentText("Tilts from a file");
    find<QLineEdit>("trade_file").setText(m_folder.filePath("missing.txt"));
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    QVERIFY(remark().contains("missing.txt"));
    find<QComboBox>("trade_schedule").setCurrentIndex(0);
}

void TestTradeDock::reasonOfUnknownsIsWhole() {
    auto &box = find<QLineEdit>("trade_unknowns");
    const QString before = box.text();
    box.setText("tilt=0.1deg,stickiness=3");
    m_dock->resize(460, 420);
    const auto &reason = find<QLabel>("trade_unknowns_error");
    QTRY_VERIFY(reason.isVisible());
    QVERIFY(!find<QPushButton>("trade_measure").isEnabled());
    QTRY_VERIFY(reason.width() <= m_dock->width() && reason.height() >= reason.heightForWidth(reason.width()));
    m_dock->resize(1200, 420);
    box.setText(before);
    QVERIFY(!reason.isVisible());
}

void TestTradeDock::otherModelShowsItsOwnPoints() {
    find<QComboBox>("trade_model").setCurrentIndex(PHYS_MODEL_RIGID);
    for (int row = 0; row < table().model()->rowCount(); ++row) QCOMPARE(cell(row, 2), QString("rigid"));
    find<QComboBox>("trade_model").setCurrentIndex(PHYS_MODEL_ROLLING);
}

void TestTradeDock::cancelKeepsWhatIsKnown() {
    find<QDoubleSpinBox>("trade_duration").setValue(600.0);
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QVERIFY(isMeasuring());
    QTRY_VERIFY_WITH_TIMEOUT(table().model()->rowCount() > 0, kLong);
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    QVERIFY(remark().startsWith("Cancelled"));
    QVERIFY(table().model()->rowCount() > 0);
}

QTEST_MAIN(TestTradeDock)
#include "tst_trade_dock.moc"
