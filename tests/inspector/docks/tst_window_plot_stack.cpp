// SPDX-License-Identifier: MIT
// Stacked plots: those for which the dock has no room are scrolled, and low ones can be read.
#include "ui/plots/plot_stack.h"
#include "window_fixture.h"

#include <QDockWidget>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

using namespace window_test;
using inspector::ui::QuantityPlot;

class TestWindowPlotStack : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void manyPlotsDontEnlargeTheWindow();
    void addedPlotIsScrolledIntoView();
    void plotScrolledAwayIsSavedWithTheOthers();
    void lowPlotHasItsUnitAboveTheAxis();
    void unitDoesntCoverTheLegend_data();
    void unitDoesntCoverTheLegend();
    void labelLongerThanItsAxisGivesWayToItsUnit();
    void onlyTheLowestOfLowPlotsHasTheTimes();
    void highPlotsHaveTheirLabelsAndTimes();
    void powersOfALowPlotHaveRoom();
    void timesOfANarrowPlotHaveRoom();

private:
    inspector::ui::PlotStack &stack() { return *m_fixture->find<inspector::ui::PlotStack>("plots"); }
    QScrollArea &scroll() { return *m_fixture->find<QScrollArea>("plot_scroll"); }
    // From top to bottom.
    QList<QuantityPlot *> plots();
    void add(const char *content);
    // Also lays them out.
    void draw();
    // Drags the border between the board and the plots.
    void makeDockLow();
    static QRectF unitOf(const QuantityPlot &plot);
};

void TestWindowPlotStack::init() {
    QVERIFY(open());
    m_fixture->window().resize(1000, 700);
    draw(); // after which docks aren't fitted to the window any more
    m_fixture->makeSteps(50);
}

QList<QuantityPlot *> TestWindowPlotStack::plots() {
    QList<QuantityPlot *> result;
    for (int i = 0; i < stack().count(); ++i)
        if (auto *plot = qobject_cast<QuantityPlot *>(stack().widget(i))) result += plot;
    return result;
}

void TestWindowPlotStack::add(const char *content) {
    stack().addPlot(inspector::ui::plotContentOf(QLatin1String(content)));
    QCoreApplication::processEvents();
}

void TestWindowPlotStack::draw() {
    for (int i = 0; i < 3; ++i) { // a plot asks for its height once it knows its width
        m_fixture->window().refresh();
        QCoreApplication::processEvents();
    }
    for (QuantityPlot *plot : plots()) plot->replot(QCustomPlot::rpImmediateRefresh);
}

void TestWindowPlotStack::makeDockLow() {
    auto *dock = m_fixture->find<QDockWidget>("plot_dock");
    m_fixture->window().resizeDocks({dock}, {10}, Qt::Vertical);
    QCoreApplication::processEvents();
    draw();
}

// Where the unit of the value axis is written, in the plot's pixels; empty if it isn't.
QRectF TestWindowPlotStack::unitOf(const QuantityPlot &plot) {
    for (int i = 0; i < plot.itemCount(); ++i) {
        const auto *text = qobject_cast<QCPItemText *>(plot.item(i));
        if (!text || !text->visible() || !text->text().startsWith('[')) continue;
        return {text->topLeft->pixelPosition(), text->bottomRight->pixelPosition()};
    }
    return {};
}

void TestWindowPlotStack::manyPlotsDontEnlargeTheWindow() {
    const QSize before = m_fixture->window().size();
    const int view = m_fixture->window().view().height();
    for (int i = 0; i < 8; ++i) add("tilt_x,tilt_y");
    draw();
    QCOMPARE(m_fixture->window().size(), before);
    QCOMPARE(m_fixture->window().view().height(), view);
    QVERIFY(scroll().verticalScrollBar()->maximum() > 0);
}

void TestWindowPlotStack::addedPlotIsScrolledIntoView() {
    for (int i = 0; i < 5; ++i) add("tilt_x,tilt_y");
    QuantityPlot *newest = plots().back();
    QTRY_COMPARE(newest->visibleRegion().boundingRect(), newest->rect());
}

void TestWindowPlotStack::plotScrolledAwayIsSavedWithTheOthers() {
    for (int i = 0; i < 5; ++i) add("tilt_x,tilt_y");
    QTRY_VERIFY(plots().front()->visibleRegion().isEmpty());
    m_fixture->key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    m_fixture->answerFile(m_fixture->path("all.png"));
    const QImage all(m_fixture->path("all.png"));
    QVERIFY2(all.height() >= 2 * 6 * 240, qPrintable(QString::number(all.height())));
}

void TestWindowPlotStack::lowPlotHasItsUnitAboveTheAxis() {
    makeDockLow();
    const QuantityPlot *plot = plots().front();
    const QRectF unit = unitOf(*plot);
    QVERIFY(unit.isValid());
    QVERIFY(QRectF(plot->rect()).contains(unit));
    QVERIFY(unit.bottom() <= plot->axisRect()->top() + 1.0);
    QCOMPARE(plot->yAxis->labelColor().alpha(), 0);
}

void TestWindowPlotStack::unitDoesntCoverTheLegend_data() {
    QTest::addColumn<int>("width");
    for (const int width : {900, 700}) QTest::addRow("%d", width) << width;
}

// In a narrow plot the legend begins further to the left.
void TestWindowPlotStack::unitDoesntCoverTheLegend() {
    QFETCH(int, width);
    m_fixture->trigger("show_bounces_dock"); // beside the plots
    m_fixture->window().resize(width, 700);
    add("tilt_x,tilt_y");
    makeDockLow();
    for (const QuantityPlot *plot : plots()) {
        QVERIFY(unitOf(*plot).isValid());
        QVERIFY(plot->legend->visible());
        const QRect entries = plot->legend->rect();
        QVERIFY2(unitOf(*plot).right() <= entries.left() || unitOf(*plot).top() >= entries.bottom(),
                 qPrintable(QString::number(plot->width())));
    }
}

void TestWindowPlotStack::labelLongerThanItsAxisGivesWayToItsUnit() {
    auto *dock = m_fixture->find<QDockWidget>("plot_dock");
    QuantityPlot *plot = plots().front();
    for (int height = 300; height > 80; height -= 20) {
        m_fixture->window().resizeDocks({dock}, {height}, Qt::Vertical);
        draw();
        const int length = plot->fontMetrics().horizontalAdvance(plot->yAxis->label());
        const double middle = plot->axisRect()->center().y();
        const bool isCut = middle + 0.5 * length > plot->height() || middle - 0.5 * length < plot->legend->rect().top();
        if (isCut) QCOMPARE(plot->yAxis->labelColor().alpha(), 0);
        QCOMPARE(unitOf(*plot).isValid(), plot->yAxis->labelColor().alpha() == 0);
    }
}

void TestWindowPlotStack::onlyTheLowestOfLowPlotsHasTheTimes() {
    add("tilt_x,tilt_y");
    add("speed");
    makeDockLow();
    QCOMPARE(plots().size(), 3);
    QVERIFY(!plots()[0]->xAxis->tickLabels() && !plots()[1]->xAxis->tickLabels());
    QVERIFY(plots()[2]->xAxis->tickLabels());
    stack().removePlot(plots()[2]);
    draw();
    QVERIFY(plots()[1]->xAxis->tickLabels());
}

void TestWindowPlotStack::highPlotsHaveTheirLabelsAndTimes() {
    m_fixture->window().resize(1000, 900);
    add("tilt_x,tilt_y");
    m_fixture->window().resizeDocks({m_fixture->find<QDockWidget>("plot_dock")}, {500}, Qt::Vertical);
    draw();
    for (const QuantityPlot *plot : plots()) {
        QVERIFY(plot->xAxis->tickLabels());
        QCOMPARE(plot->xAxis->label(), QString("Time [s]"));
        QCOMPARE(plot->yAxis->labelColor().alpha(), 255);
        QVERIFY(!unitOf(*plot).isValid());
    }
}

void TestWindowPlotStack::powersOfALowPlotHaveRoom() {
    add("log:speed");
    add("log:step_time");
    plots()[1]->yAxis->setRange(1e-6, 1.0);
    makeDockLow();
    for (const QuantityPlot *plot : {plots()[1], plots()[2]}) {
        const QVector<double> ticks = plot->yAxis->tickVector();
        const auto shown =
            std::ranges::count_if(ticks, [plot](double tick) { return plot->yAxis->range().contains(tick); });
        QVERIFY(shown >= 1);
        QVERIFY2((shown - 1) * plot->fontMetrics().ascent() <= plot->axisRect()->height(),
                 qPrintable(QString("%1 in %2").arg(shown).arg(plot->axisRect()->height())));
    }
}

void TestWindowPlotStack::timesOfANarrowPlotHaveRoom() {
    m_fixture->trigger("text_size_3");
    m_fixture->trigger("show_bounces_dock"); // beside the plots
    draw();
    const QuantityPlot *plot = plots().front();
    const QVector<double> ticks = plot->xAxis->tickVector();
    const int wide = plot->fontMetrics().horizontalAdvance(QStringLiteral("10"));
    for (qsizetype i = 1; i < ticks.size(); ++i)
        QVERIFY(plot->xAxis->coordToPixel(ticks[i]) - plot->xAxis->coordToPixel(ticks[i - 1]) > wide);
}

QTEST_MAIN(TestWindowPlotStack)
#include "tst_window_plot_stack.moc"
