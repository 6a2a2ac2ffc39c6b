// SPDX-License-Identifier: MIT
// The trade in the window: measured in the background, chosen by the user, applied.
#include "ui/trade/trade_dock.h"

#include "inspector/dock_fixture.h"
#include "ui/parts/number_box.h"
#include "ui/parts/stepper_items.h"
#include "ui/trade/trade_chart.h"
#include "ui/trade/trade_table_model.h"

#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QTableView>
#include <QToolTip>

#include <algorithm>
#include <cmath>

using namespace inspector;
using namespace inspector::ui;

namespace {

constexpr QSize kUsualSize(920, 360); // in a window of 1280 x 800

} // namespace

class TestTradeDock : public QObject, support::DockFixture<TradeDock> {
    Q_OBJECT

private slots:
    void initTestCase();
    void headerNamesTheUsualSpanAtFirst();
    void numbersAreReadAsPeopleWriteThem_data();
    void numbersAreReadAsPeopleWriteThem();
    void whatIsNoNumberIsRefusedWithAReason_data();
    void whatIsNoNumberIsRefusedWithAReason();
    void measureRefusesANumberStillTyped();
    void measuringFillsTableAndChart();
    void chartSaysOfWhichSpanItsErrorsAre();
    void headerSaysOfWhichSpanItsErrorsAre();
    void chartIsWhole_data();
    void chartIsWhole();
    void columnsThatMatterAreSeenAtTheUsualWidth();
    void columnIsShownByTheHeadersMenu();
    void stepperHasOneNameEverywhere();
    void stepperHasTheColourOfItsCurve();
    void otherWishPutsTheAnswerOutOfDate_data();
    void otherWishPutsTheAnswerOutOfDate();
    void changedParameterPutsTheFiguresOutOfDate();
    void figuresOfAnotherLevelKeepTheirBallsRadius();
    void figuresAreOfTheirLevelAgainAfterAnother();
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
    void fileThatIsntThereIsSaid();
    void fileThatCantBeReadIsSaid();
    void reasonOfUnknownsIsWhole();
    void otherModelShowsItsOwnPoints();
    void cancelKeepsWhatIsKnown();
    void levelOpenedWhileMeasuringIsAnother();

private:
    void type(const char *box, const char *text);
    void showAt(const QSize &size);
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

void TestTradeDock::type(const char *box, const char *text) {
    auto &field = find<QLineEdit>(box);
    QTest::mouseClick(&field, Qt::LeftButton);
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

void TestTradeDock::initTestCase() {
    const QString error = open(1);
    QVERIFY2(error.isEmpty(), qPrintable(error));
    type("trade_duration", "500 ms");
}

void TestTradeDock::headerNamesTheUsualSpanAtFirst() {
    const int column = TradeTableModel::columnOf("share_of_unknown [%]");
    QCOMPARE(table().model()->headerData(column, Qt::Horizontal).toString(), QString("of unknown\nin 1 s [%]"));
}

void TestTradeDock::numbersAreReadAsPeopleWriteThem_data() {
    QTest::addColumn<QByteArray>("box");
    QTest::addColumn<QByteArray>("typed");
    QTest::addColumn<double>("value");
    QTest::newRow("power of ten") << QByteArray("trade_duration") << QByteArray("1e1") << 10.0;
    QTest::newRow("unit") << QByteArray("trade_duration") << QByteArray("500 ms") << 0.5;
    QTest::newRow("decimal comma") << QByteArray("trade_horizon") << QByteArray("1,5") << 1.5;
    QTest::newRow("quotient") << QByteArray("trade_horizon") << QByteArray("1/4") << 0.25;
    QTest::newRow("share with decimals") << QByteArray("trade_share") << QByteArray("12.5") << 12.5;
    QTest::newRow("share with its sign") << QByteArray("trade_share") << QByteArray("12.5 %") << 12.5;
}

void TestTradeDock::numbersAreReadAsPeopleWriteThem() {
    QFETCH(const QByteArray, box);
    QFETCH(const QByteArray, typed);
    QFETCH(const double, value);
    auto &field = find<NumberBox>(box.constData());
    const QString before = field.exactText();
    type(box.constData(), typed.constData());
    QCOMPARE(field.value(), value);
    type(box.constData(), qPrintable(before));
}

void TestTradeDock::whatIsNoNumberIsRefusedWithAReason_data() {
    QTest::addColumn<QByteArray>("box");
    QTest::addColumn<QByteArray>("typed");
    QTest::addColumn<QString>("reason");
    QTest::newRow("too short") << QByteArray("trade_duration") << QByteArray("1e-3")
                               << "expected a number from 0.5 to 600 s, found '1e-3'";
    QTest::newRow("horizon below the least")
        << QByteArray("trade_horizon") << QByteArray("1/60") << "expected a number from 0.1 to 60 s, found '1/60'";
    QTest::newRow("share beyond the whole")
        << QByteArray("trade_share") << QByteArray("101") << "expected a number from 1 to 100 %, found '101'";
    QTest::newRow("no number") << QByteArray("trade_share") << QByteArray("half")
                               << "expected a number from 1 to 100 %, found 'half'";
}

void TestTradeDock::whatIsNoNumberIsRefusedWithAReason() {
    QFETCH(const QByteArray, box);
    QFETCH(const QByteArray, typed);
    QFETCH(const QString, reason);
    auto &field = find<NumberBox>(box.constData());
    type(box.constData(), typed.constData());
    QCOMPARE(field.reason(), reason);
    QCOMPARE(field.text(), QString(typed));
    QTest::keyClick(&field, Qt::Key_Escape);
}

// The click leaves the keyboard in the field.
void TestTradeDock::measureRefusesANumberStillTyped() {
    auto &field = find<NumberBox>("trade_duration");
    QTest::mouseClick(&field, Qt::LeftButton);
    field.selectAll();
    QTest::keyClicks(&field, "soon");
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QVERIFY(!isMeasuring());
    QCOMPARE(remark(), QString("Duration: expected a number from 0.5 to 600 s, found 'soon'"));
    QTest::keyClick(&field, Qt::Key_Escape);
}

void TestTradeDock::measuringFillsTableAndChart() {
    QVERIFY(!find<QPushButton>("trade_use").isEnabled());
    QVERIFY(table().isColumnHidden(table().model()->columnCount() - 1)); // nor to note
    QVERIFY(!chart().legend->visible());                                 // there is nothing to name
    QCOMPARE(find<QLineEdit>("trade_unknowns").cursorPosition(), 0);     // so that its beginning is seen
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QVERIFY(isMeasuring());
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    // Every stepper at seven step sizes; the session's own, 10 ms, is one of them.
    QCOMPARE(table().model()->rowCount(), int(phys_registry_count(nullptr)) * 7);
    QVERIFY(remark().contains("compared up to 0.50 s"));
    QVERIFY2(find<QLabel>("trade_answer").text().contains(" mm in the first 0.5 s of each schedule;"),
             qPrintable(find<QLabel>("trade_answer").text()));
    QVERIFY(chart().legend->visible());
    QCOMPARE(find<QLabel>("trade_remark").text().left(9), QString("schedule ")); // a box has the unknowns
    const QString picture = qEnvironmentVariable("TRADE_PICTURE");               // to look at
    if (!picture.isEmpty()) QVERIFY(m_dock->grab().save(picture));
}

void TestTradeDock::chartSaysOfWhichSpanItsErrorsAre() {
    const auto *title = qobject_cast<QCPTextElement *>(chart().plotLayout()->element(0, 0));
    QVERIFY(title);
    QVERIFY2(title->text().startsWith("errors up to 0.50 s on schedule busy"), qPrintable(title->text()));
}

void TestTradeDock::headerSaysOfWhichSpanItsErrorsAre() {
    const QString tip = table().model()->headerData(3, Qt::Horizontal, Qt::ToolTipRole).toString();
    QVERIFY2(tip.contains("in the whole comparison, on the worst schedule"), qPrintable(tip));
}

void TestTradeDock::showAt(const QSize &size) {
    m_dock->resize(size);
    QTRY_COMPARE(m_dock->size(), size);
    chart().replot();
    chart().replot(); // margins fit the content only the second time
}

void TestTradeDock::chartIsWhole_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("in a window of 1280 x 800") << kUsualSize;
    QTest::newRow("beside wider parameters") << QSize(915, 355);
    QTest::newRow("low") << QSize(915, 310);
    QTest::newRow("wide") << QSize(1200, 420);
}

void TestTradeDock::chartIsWhole() {
    QFETCH(QSize, size);
    showAt(size);
    const auto *title = qobject_cast<QCPTextElement *>(chart().plotLayout()->element(0, 0));
    const QRect needed =
        QFontMetrics(title->font()).boundingRect(title->rect(), title->textFlags() | Qt::TextWordWrap, title->text());
    QVERIFY2(title->rect().height() >= needed.height(), qPrintable(title->text()));
    const QCPAxisRect *curves = chart().axisRect();
    for (const QCPAxis *axis : {chart().xAxis, chart().yAxis}) {
        const int length = axis == chart().xAxis ? curves->width() : curves->height();
        QVERIFY2(QFontMetrics(axis->labelFont()).horizontalAdvance(axis->label()) <= length + 20,
                 qPrintable(axis->label()));
    }
    const QCPLegend *legend = chart().legend;
    QVERIFY(legend->visible() == bool(legend->layout()));
    if (legend->visible()) {
        QVERIFY(!legend->outerRect().intersects(curves->rect()));
        QVERIFY(chart().rect().contains(legend->outerRect()));
        QVERIFY(legend->outerRect().height() >= legend->minimumOuterSizeHint().height());
    }
    QVERIFY2(curves->height() >= 120, qPrintable(QString::number(curves->height())));
    const QString folder = qEnvironmentVariable("TRADE_PICTURES"); // to look at
    if (!folder.isEmpty()) QVERIFY(m_dock->grab().save(QString("%1/%2.png").arg(folder, QTest::currentDataTag())));
    m_dock->resize(1200, 420);
}

void TestTradeDock::columnsThatMatterAreSeenAtTheUsualWidth() {
    showAt(kUsualSize);
    const int error = TradeTableModel::columnOf("position_largest [R]");
    const int cost = TradeTableModel::columnOf("cpu_per_second [us]");
    QVERIFY(table().horizontalHeader()->visualIndex(cost) < table().horizontalHeader()->visualIndex(error));
    for (const char *id : {"cpu_per_second [us]", "position_largest [R]", "share_of_unknown [%]", "wrong_impacts"}) {
        const int column = TradeTableModel::columnOf(id);
        QVERIFY2(!table().isColumnHidden(column) &&
                     table().columnViewportPosition(column) + table().columnWidth(column) <=
                         table().viewport()->width(),
                 id);
    }
    QVERIFY(table().model()->index(0, error).data(Qt::ToolTipRole).toString().contains("\nend error: "));
    m_dock->resize(1200, 420);
}

void TestTradeDock::columnIsShownByTheHeadersMenu() {
    const int column = TradeTableModel::columnOf("penetration_largest [R]");
    QVERIFY(table().isColumnHidden(column));
    QHeaderView *header = table().horizontalHeader();
    const QPoint place = header->viewport()->rect().center();
    QContextMenuEvent ask(QContextMenuEvent::Mouse, place, header->viewport()->mapToGlobal(place));
    QApplication::sendEvent(header->viewport(), &ask);
    auto *menu = m_dock->findChild<QMenu *>("trade_columns");
    QVERIFY(menu);
    for (QAction *choice : menu->actions())
        if (choice->text() == "overlap")
            QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(choice).center());
    QVERIFY(!table().isColumnHidden(column));
    TradeDock next(*m_session, m_undo);
    QVERIFY(!next.findChild<QTableView *>("trade_table")->isColumnHidden(column)); // remembered
    m_settings.remove("trade/columns");
}

void TestTradeDock::stepperHasOneNameEverywhere() {
    QComboBox list;
    addStepperItems(list, m_session->registry());
    for (int row = 0; row < table().model()->rowCount(); ++row) QVERIFY(list.findText(cell(row, 0)) >= 0);
    int found = 0;
    for (int i = 0; i < chart().plottableCount(); ++i)
        found += list.findText(chart().plottable(i)->name()) >= 0 ? 1 : 0;
    QCOMPARE(found, list.count());
    const QString answer = find<QLabel>("trade_good_enough").text();
    QVERIFY2(list.findText(answer.section(": ", 1).section(" at ", 0, 0)) >= 0, qPrintable(answer));
}

// The table is the legend of a chart that has no room for its own.
void TestTradeDock::stepperHasTheColourOfItsCurve() {
    int found = 0;
    for (int row = 0; row < table().model()->rowCount(); ++row) {
        for (int i = 0; i < chart().plottableCount(); ++i) {
            if (chart().plottable(i)->name() != cell(row, 0)) continue;
            const QVariant swatch = table().model()->index(row, 0).data(Qt::DecorationRole);
            QCOMPARE(swatch.value<QColor>(), chart().plottable(i)->pen().color());
            ++found;
        }
    }
    QCOMPARE(found, table().model()->rowCount());
}

void TestTradeDock::otherWishPutsTheAnswerOutOfDate_data() {
    QTest::addColumn<QByteArray>("box");
    QTest::addColumn<QByteArray>("typed");
    QTest::newRow("share") << QByteArray("trade_share") << QByteArray("30");
    QTest::newRow("horizon") << QByteArray("trade_horizon") << QByteArray("400 ms");
    QTest::newRow("what isn't known") << QByteArray("trade_unknowns") << QByteArray("tilt=0.2deg");
    QTest::newRow("nothing that can be read") << QByteArray("trade_unknowns") << QByteArray("tilt=");
}

void TestTradeDock::otherWishPutsTheAnswerOutOfDate() {
    QFETCH(const QByteArray, box);
    QFETCH(const QByteArray, typed);
    const auto &answer = find<QLabel>("trade_good_enough");
    const auto &use = find<QPushButton>("trade_use_good_enough");
    const QString before = find<QLineEdit>(box.constData()).text();
    const QString measured = answer.text();
    const auto *title = qobject_cast<QCPTextElement *>(chart().plotLayout()->element(0, 0));
    const QString shown = title->text();
    const int columns = chart().legend->columnCount();
    QVERIFY2(measured.startsWith("Good enough: "), qPrintable(measured));
    type(box.constData(), typed.constData());
    QCOMPARE(answer.text(), "Out of date, measure again. " + measured);
    QVERIFY(!use.isEnabled());
    QCOMPARE(title->text(), shown + " (out of date)");
    QCOMPARE(chart().legend->columnCount(), columns);
    type(box.constData(), qPrintable(before));
    QCOMPARE(answer.text(), measured);
    QVERIFY(use.isEnabled());
    QCOMPARE(title->text(), shown);
}

void TestTradeDock::changedParameterPutsTheFiguresOutOfDate() {
    const QString measured = remark();
    const auto &goodEnough = find<QLabel>("trade_good_enough");
    const auto &answer = find<QLabel>("trade_answer");
    Parameters &parameters = m_session->parameters();
    QVERIFY(parameters.set({{"tilt_x", 3.0}}));
    QCOMPARE(remark(), measured); // the schedules tilt
    QVERIFY(parameters.set({{"restitution_wall", 0.6}, {"gravity", 3.7}}));
    QCOMPARE(remark(),
             QString("These figures are of other parameters: Gravity of 9.81 m/s², Restitution, walls of 0.5."));
    QVERIFY2(goodEnough.text().startsWith("Out of date, measure again. Good"), qPrintable(goodEnough.text()));
    QVERIFY2(answer.text().startsWith("Out of date, measure again. Cheapest"), qPrintable(answer.text()));
    QVERIFY(!find<QPushButton>("trade_use_good_enough").isEnabled());
    QVERIFY(parameters.set({{"tilt_x", 0.0}, {"restitution_wall", 0.5}, {"gravity", 9.81}}));
    QCOMPARE(remark(), measured);
    QVERIFY(goodEnough.text().startsWith("Good enough"));
    QVERIFY(answer.text().startsWith("Cheapest"));
}

void TestTradeDock::figuresOfAnotherLevelKeepTheirBallsRadius() {
    const QString answer = find<QLabel>("trade_answer").text();
    const QString asked = find<QLabel>("trade_tolerance_text").text();
    const int chosen = chosenRow();
    QFile maze(m_folder.filePath("large_ball.txt"));
    QVERIFY(maze.open(QIODevice::WriteOnly));
    maze.write("physics-maze 1\nunits m\nball 0.012\nstart 0 0 0.012\nbox -0.1 -0.1 -0.01 0.1 0.1 0\n");
    maze.close();
    QVERIFY(m_session->openLevel(levelOfFile(maze.fileName())));
    QCOMPARE(find<QLabel>("trade_answer").text(), "Out of date, measure again. " + answer);
    QCOMPARE(find<QLabel>("trade_tolerance_text").text(), asked);
    auto &slider = find<QSlider>("trade_tolerance");
    slider.triggerAction(QSlider::SliderPageStepAdd);
    slider.triggerAction(QSlider::SliderPageStepSub);
    QCOMPARE(chosenRow(), chosen);
    QVERIFY(m_session->openLevel(m_session->levels().listed()[0]));
    QCOMPARE(find<QLabel>("trade_answer").text(), answer);
}

void TestTradeDock::figuresAreOfTheirLevelAgainAfterAnother() {
    const QString measured = remark();
    QVERIFY(m_session->openLevel(m_session->levels().listed()[1]));
    QCOMPARE(remark(), QString("These figures are of another level."));
    QVERIFY(!find<QPushButton>("trade_use").isEnabled());
    QVERIFY(m_session->openLevel(m_session->levels().listed()[0]));
    QCOMPARE(remark(), measured);
    QVERIFY(find<QPushButton>("trade_use").isEnabled());
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

// Asking for a smaller error can't make the recommended setting's error larger.
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
    for (int i = 0; i < chart().plottableCount(); ++i) {
        const auto *curve = qobject_cast<const QCPCurve *>(chart().plottable(i));
        if (!curve) continue;
        for (const QCPCurveData &drawn : *curve->data()) {
            const QPointF place(chart().xAxis->coordToPixel(drawn.key), chart().yAxis->coordToPixel(drawn.value));
            if (chart().pointAt(place)) return place;
        }
    }
    qFatal("no point is drawn");
}

// The mouse moves again each time, as a tool tip disappears with any change of the window.
QString TestTradeDock::tipAt(const QPointF &place) {
    QTest::mouseMove(&chart(), {1, 1});
    QTest::mouseMove(&chart(), place.toPoint());
    return QToolTip::text();
}

// Its text changes as well: it isn't the error over another span.
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
    choosePoint("Runge-Kutta 4", "2 ms");
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
    choosePoint("Exact", "10 ms");
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
    auto &seed = find<QLineEdit>("trade_seed");
    QVERIFY(!seed.isVisible());
    kind.setCurrentText("Random tilts");
    QVERIFY(seed.isVisible());
    type("trade_seed", "7");
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
    QVERIFY(!find<QLineEdit>("trade_seed").isVisible());
    QVERIFY(!measure().isEnabled()); // no file yet
    find<QLineEdit>("trade_file").setText(path);
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(table().model()->rowCount() > 0, kLong);
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    QVERIFY2(remark().contains("schedule " + path + ","), qPrintable(remark()));
}

void TestTradeDock::fileThatIsntThereIsSaid() {
    find<QComboBox>("trade_schedule").setCurrentText("Tilts from a file");
    type("trade_file", qPrintable(m_folder.filePath("missing.txt")));
    QVERIFY(!measure().isEnabled());
    QVERIFY2(remark().endsWith("missing.txt': there is no such file"), qPrintable(remark()));
    find<QComboBox>("trade_schedule").setCurrentIndex(0);
    QVERIFY(measure().isEnabled());
    QVERIFY(!remark().contains("missing.txt"));
}

void TestTradeDock::fileThatCantBeReadIsSaid() {
    QFile file(m_folder.filePath("words.txt"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no tilts\n") > 0);
    file.close();
    find<QComboBox>("trade_schedule").setCurrentText("Tilts from a file");
    find<QLineEdit>("trade_file").setText(file.fileName());
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    QVERIFY(remark().contains("words.txt"));
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
    type("trade_duration", "10 min");
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QVERIFY(isMeasuring());
    QTRY_VERIFY_WITH_TIMEOUT(table().model()->rowCount() > 0, kLong);
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    QVERIFY(remark().startsWith("Cancelled"));
    QVERIFY(table().model()->rowCount() > 0);
}

void TestTradeDock::levelOpenedWhileMeasuringIsAnother() {
    QTest::mouseClick(&measure(), Qt::LeftButton);
    QVERIFY(isMeasuring());
    QVERIFY(m_session->openLevel(m_session->levels().listed()[1]));
    QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong);
    QCOMPARE(remark(), QString("These figures are of another level."));
}

QTEST_MAIN(TestTradeDock)
#include "tst_trade_dock.moc"
