// SPDX-License-Identifier: MIT
// The ball beside its ghost: switched on by key and dock, drawn at its position, its distance plotted.
#include "gl/view/maze_view.h"
#include "inspector/stepping.h"
#include "support/compare.h"
#include "support/files.h"
#include "ui/comparison/distance_plot.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/number_box.h"
#include "ui/parts/theme.h"
#include "ui/window/board_picture.h"
#include "window_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include <glm/geometric.hpp>

#include <cmath>

using namespace window_test;
using inspector::Channel;
using inspector::GhostChoice;
using inspector::Sample;
using inspector::Snapshot;

class TestWindowComparison : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void cSwitchesTheComparison();
    void boxInTheDockSwitchesTheComparison();
    void chosenStepperMovesTheGhost();
    void typedSubstepsMoveTheGhost();
    void lookAtAnotherLevelsRunKeepsTheGhost();
    void mBringsThemTogether();
    void rBringsThemTogether();
    void figuresAreThoseOfTheMoment();
    void statusSaysHowFarTheGhostIs();
    void plotShowsTheDistance();
    void plotMarksTheMomentShown();
    void zeroHasAPlaceOnTheAxis();
    void gapsAreWhereThereWasNoGhost();
    void radiiAreAtTheRightBorder();
    void legendNamesBoth();
    void bandOfWhatIsntKnownLiesBehind();
    void bandBeginsWhereTheyMeet();
    void noneTypedInTheTradeTakesTheBandAway();
    void readOutIsInBothUnits();
    void readOutIsWholeBesideALongLegend();
    void missingValueHasNoDot();
    void curveBeginsAnewWithAnotherGhost();
    void savedTableHasTheGhost();
    void fileBesideTheTableNamesTheGhostOfEachRow();
    void ghostIsDrawnWhereItIs();
    void ghostOnTheBallIsHidden();
    void trailsAreBoundedAndOfTheLegendsColours();
    void coloursCanBeTold_data();
    void coloursCanBeTold();
    void refusalIsOneLineInBarAndDock();
    void refusalIsForgottenAtARestart();
    void optionOpensTheDock();

private:
    Snapshot now() { return m_fixture->simulation().latest(); }
    double distance() { return now().ghost ? now().ghost->deviation.distance : std::nan(""); }
    void compareWith(const GhostChoice &ghostChoice);
    void makeSteps(uint64_t count);
    void refuseTheGhost();
    QImage picture();
    QString figures();
    QCPGraph *bandGraph(); // its upper edge, which the legend names; null: there is none
    bool showsBandUntil(double time);

    inspector::ui::DistancePlot *m_plot = nullptr;
};

// Stepped manually: the same in every run.
void TestWindowComparison::init() {
    QVERIFY(open(3, solidIn({"ghostIsDrawnWhereItIs", "ghostOnTheBallIsHidden"})));
    m_plot = m_fixture->find<inspector::ui::DistancePlot>("distance_plot");
    m_fixture->parameters().set({{"tilt_x", 3.0}, {"tilt_y", 4.0}});
    m_fixture->press(Qt::Key_5, Qt::ControlModifier);
    QTRY_VERIFY(m_plot->isVisible());
    const auto *dock = m_fixture->find<QDockWidget>("comparison_dock");
    QTRY_VERIFY(dock->height() >
                0.3 * m_fixture->window().height()); // higher than the plot's: pictures are of one size
}

void TestWindowComparison::compareWith(const GhostChoice &ghostChoice) {
    m_fixture->session().comparison().start(ghostChoice);
    QTRY_VERIFY(now().ghost);
}

void TestWindowComparison::makeSteps(uint64_t count) {
    m_fixture->makeSteps(count);
    m_fixture->window().refresh();
}

QImage TestWindowComparison::picture() { return m_fixture->window().view().grabFramebuffer(); }

QString TestWindowComparison::figures() {
    m_fixture->window().refresh();
    return m_fixture->find<QLabel>("comparison_figures")->text();
}

void TestWindowComparison::cSwitchesTheComparison() {
    QVERIFY(!m_fixture->find<QAction>("meet_again")->isEnabled());
    m_fixture->press(Qt::Key_C);
    QTRY_VERIFY(now().ghost);
    QVERIFY(m_fixture->find<QAction>("compare")->isChecked());
    QVERIFY(m_fixture->find<QCheckBox>("comparison_compare")->isChecked());
    QVERIFY(m_fixture->find<QAction>("meet_again")->isEnabled());
    m_fixture->press(Qt::Key_C);
    QTRY_VERIFY(!now().ghost);
    QVERIFY(!m_fixture->find<QAction>("compare")->isChecked());
    QVERIFY(!m_fixture->find<QCheckBox>("comparison_compare")->isChecked());
}

void TestWindowComparison::boxInTheDockSwitchesTheComparison() {
    auto *box = m_fixture->find<QCheckBox>("comparison_compare");
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    QTRY_VERIFY(now().ghost);
    QVERIFY(m_fixture->find<QAction>("compare")->isChecked());
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    QTRY_VERIFY(!now().ghost);
}

// By keyboard: Home is the crudest stepper, then down.
void TestWindowComparison::chosenStepperMovesTheGhost() {
    auto *box = m_fixture->find<QComboBox>("comparison_stepper");
    QCOMPARE(box->currentData().toByteArray(), QByteArray("exact"));
    m_fixture->press(Qt::Key_C);
    box->setFocus(Qt::TabFocusReason);
    box->showPopup();
    QWidget *list = QApplication::activePopupWidget();
    QVERIFY(list);
    QWidget *keys = list->focusWidget() ? list->focusWidget() : list;
    QTest::keyClick(keys, Qt::Key_Home);
    QTest::keyClick(keys, Qt::Key_Down);
    QTest::keyClick(keys, Qt::Key_Return);
    QCOMPARE(m_fixture->session().comparison().ghostChoice().stepper, QByteArray("symplectic-euler"));
    makeSteps(20);
    COMPARE_EXACT(distance(), 0.0); // the ball's own
}

void TestWindowComparison::typedSubstepsMoveTheGhost() {
    compareWith({"symplectic-euler", 1});
    auto *box = m_fixture->find<inspector::ui::NumberBox>("comparison_substeps");
    QCOMPARE(box->text(), QString("1"));
    box->setFocus(Qt::TabFocusReason);
    box->selectAll();
    QTest::keyClicks(box, "10");
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(m_fixture->session().comparison().ghostChoice(), (GhostChoice{"symplectic-euler", 10}));
    QCOMPARE(m_fixture->game().phase(), inspector::Game::Phase::Prompt); // Enter was the box's
    QCOMPARE(box->text(), QString("10"));
    makeSteps(20);
    QVERIFY(distance() > 0.0);
    QCOMPARE(now().ghost->current.step, uint64_t(200));
}

void TestWindowComparison::lookAtAnotherLevelsRunKeepsTheGhost() {
    makeSteps(5);
    QVERIFY(m_fixture->session().openLevel(m_fixture->session().levels().listed()[0]));
    QTRY_COMPARE(now().current.step, uint64_t(0));
    compareWith({"exact", 1});
    makeSteps(10);
    const uint64_t ghost = now().ghost->number;
    m_fixture->session().lookAt(m_fixture->session().history().runs().front().end);
    QTRY_COMPARE(m_fixture->session().level().name, QString("03"));
    m_fixture->window().refresh();
    m_fixture->key(Qt::Key_Escape);
    QTRY_VERIFY(!m_fixture->session().isInPast() && now().current.step == 10);
    makeSteps(1);
    QCOMPARE(now().ghost->number, ghost);
    QCOMPARE(now().ghost->met.step, uint64_t(0));
}

void TestWindowComparison::mBringsThemTogether() {
    compareWith({});
    makeSteps(20);
    QVERIFY(distance() > 0.0);
    m_fixture->press(Qt::Key_M);
    QTRY_COMPARE(distance(), 0.0);
    QVERIFY(support::sameBits(now().ghost->current, now().current));
    QCOMPARE(now().current.step, uint64_t(20));
}

void TestWindowComparison::rBringsThemTogether() {
    compareWith({});
    makeSteps(20);
    m_fixture->press(Qt::Key_R);
    QTRY_COMPARE(now().current.step, uint64_t(0));
    QVERIFY(support::sameBits(now().ghost->current, now().current));
}

void TestWindowComparison::figuresAreThoseOfTheMoment() {
    QVERIFY2(figures().startsWith("A second ball"), qPrintable(figures()));
    compareWith({});
    makeSteps(20);
    const QString expected =
        QString("Distance %1 mm = %2 R, speed ").arg(distance() * 1e3, 0, 'g', 4).arg(distance() / 0.006, 0, 'g', 3);
    QVERIFY2(figures().startsWith(expected), qPrintable(figures() + " / " + expected));
    QVERIFY2(figures().contains("0.20 s after they met"), qPrintable(figures()));
}

void TestWindowComparison::statusSaysHowFarTheGhostIs() {
    compareWith({"exact"});
    makeSteps(20);
    const auto *label = m_fixture->find<QLabel>("status_ghost");
    QVERIFY(label->isVisible());
    QCOMPARE(label->text(), QString("Ghost: %1 mm apart").arg(distance() * 1e3, 0, 'g', 3));
}

void TestWindowComparison::plotShowsTheDistance() {
    compareWith({});
    makeSteps(30);
    const auto data = m_plot->graph(m_plot->graphCount() - 1)->data();
    QCOMPARE(data->size(), 30);
    Sample sample;
    for (int i = 0; i < 30; ++i) {
        QVERIFY(m_fixture->simulation().samples().read(uint64_t(i), sample));
        QVERIFY(sample[Channel::Distance] > 0.0);
        QCOMPARE(data->at(i)->key, sample.time);
        COMPARE_EXACT(data->at(i)->value, sample[Channel::Distance] * 1e3);
        QVERIFY(m_plot->yAxis->range().contains(data->at(i)->value));
    }
    QCOMPARE(m_plot->yAxis->scaleType(), QCPAxis::stLogarithmic);
    QVERIFY(m_plot->yAxis->label().contains("[mm]"));
}

void TestWindowComparison::plotMarksTheMomentShown() {
    const auto marked = [this] { // the time of the only line there
        m_fixture->window().refresh();
        double time = std::nan("");
        for (int i = 0; i < m_plot->itemCount(); ++i) {
            const auto *line = qobject_cast<QCPItemStraightLine *>(m_plot->item(i));
            if (line && line->visible()) time = line->point1->coords().x();
        }
        return time;
    };
    makeSteps(20);
    QVERIFY(std::isnan(marked()));
    m_fixture->key(Qt::Key_Comma);
    QTRY_COMPARE(now().current.step, uint64_t(19));
    QTRY_COMPARE(marked(), now().current.time);
}

// Below all others, at a tick that says so.
void TestWindowComparison::zeroHasAPlaceOnTheAxis() {
    compareWith({"symplectic-euler", 1});
    makeSteps(10);
    const auto data = m_plot->graph(m_plot->graphCount() - 1)->data();
    const double zero = data->at(0)->value;
    QVERIFY(zero > m_plot->yAxis->range().lower);
    m_fixture->session().comparison().setOwnParameters(true);
    m_fixture->session().comparison().parameters().set({{"rolling_friction", 0.01}});
    makeSteps(10);
    m_plot->replot();
    const double border = m_plot->yAxis->range().lower;
    const double low = data->at(0)->value;
    for (int i = 0; i < 10; ++i) COMPARE_EXACT(data->at(i)->value, low);
    for (int i = 10; i < 20; ++i) QVERIFY(data->at(i)->value >= 10.0 * low);
    QVERIFY(low > border);
    const QVector<double> ticks = m_plot->yAxis->tickVector();
    const QVector<QString> labels = m_plot->yAxis->tickVectorLabels();
    const qsizetype place = labels.indexOf("0");
    QVERIFY(place >= 0);
    COMPARE_WITHIN(ticks[place], low, 1e-9 * low); // powers of ten computed in different ways
}

void TestWindowComparison::gapsAreWhereThereWasNoGhost() {
    makeSteps(10);
    compareWith({});
    makeSteps(10);
    const auto data = m_plot->graph(m_plot->graphCount() - 1)->data();
    for (const QCPGraphData &point : *data) QCOMPARE(std::isnan(point.value), point.key < 0.105);
}

void TestWindowComparison::radiiAreAtTheRightBorder() {
    compareWith({});
    makeSteps(10);
    QVERIFY(m_plot->yAxis2->visible());
    QVERIFY(m_plot->yAxis2->label().contains("[R]"));
    const double place = m_plot->yAxis->coordToPixel(6.0);          // 6 mm are a radius
    COMPARE_WITHIN(m_plot->yAxis2->coordToPixel(1.0), place, 1e-6); // px
}

void TestWindowComparison::legendNamesBoth() {
    compareWith({"exact", 10});
    const auto texts = [this] {
        QStringList names;
        for (int i = 0; i < m_plot->legend->itemCount(); ++i)
            names << static_cast<QCPPlottableLegendItem *>(m_plot->legend->item(i))->plottable()->name();
        return names;
    };
    QCOMPARE(texts(), QStringList({"Ball: Symplectic Euler, 10 ms", "Ghost: Exact, 1 ms"}));
    chooseDt(m_fixture->session(), 0.005);
    chooseStepper(m_fixture->session(), "rk4");
    QCOMPARE(texts(), QStringList({"Ball: Runge-Kutta 4, 5 ms", "Ghost: Exact, 0.5 ms"}));
}

QCPGraph *TestWindowComparison::bandGraph() {
    m_fixture->window().refresh();
    for (int i = 0; i < m_plot->legend->itemCount(); ++i) {
        auto *graph =
            qobject_cast<QCPGraph *>(static_cast<QCPPlottableLegendItem *>(m_plot->legend->item(i))->plottable());
        if (graph && graph->name() == "Not known (9 boards in 10)") return graph;
    }
    return nullptr;
}

bool TestWindowComparison::showsBandUntil(double time) {
    const QCPGraph *graph = bandGraph();
    return graph && !graph->data()->isEmpty() && std::prev(graph->data()->constEnd())->key > time - 0.071;
}

void TestWindowComparison::bandOfWhatIsntKnownLiesBehind() {
    compareWith({});
    makeSteps(40);
    QTRY_VERIFY(showsBandUntil(0.4));
    const QCPGraph *high = bandGraph();
    const QCPGraph *low = high->channelFillGraph();
    QVERIFY(low);
    QCOMPARE(low->data()->size(), high->data()->size());
    QCOMPARE(high->data()->at(0)->key, 0.0);
    QVERIFY(high->brush().style() != Qt::NoBrush);
    for (int i = 0; i < high->data()->size(); ++i) QVERIFY(low->data()->at(i)->value <= high->data()->at(i)->value);
    QVERIFY(m_plot->yAxis->range().contains(std::prev(high->data()->constEnd())->value));
    QVERIFY2(figures().contains("; not known: "), qPrintable(figures()));
    const QString picture = qEnvironmentVariable("BAND_PICTURE"); // to look at
    if (!picture.isEmpty()) QVERIFY(m_fixture->window().grab().save(picture));
}

void TestWindowComparison::bandBeginsWhereTheyMeet() {
    compareWith({});
    makeSteps(40);
    QTRY_VERIFY(showsBandUntil(0.4));
    m_fixture->press(Qt::Key_M);
    makeSteps(20);
    QTRY_VERIFY(showsBandUntil(0.6));
    COMPARE_WITHIN(bandGraph()->data()->at(0)->key, 0.4, 1e-12);
}

void TestWindowComparison::noneTypedInTheTradeTakesTheBandAway() {
    compareWith({});
    makeSteps(40);
    QTRY_VERIFY(bandGraph());
    m_fixture->press(Qt::Key_4, Qt::ControlModifier);
    auto *unknowns = m_fixture->find<QLineEdit>("trade_unknowns");
    QTRY_VERIFY(unknowns->isVisible());
    unknowns->setFocus(Qt::TabFocusReason);
    unknowns->selectAll();
    QTest::keyClicks(unknowns, "none");
    m_fixture->press(Qt::Key_5, Qt::ControlModifier);
    QTRY_VERIFY(m_plot->isVisible());
    QTRY_VERIFY(!bandGraph());
}

void TestWindowComparison::readOutIsInBothUnits() {
    compareWith({});
    chooseDt(m_fixture->session(), 0.1);
    makeSteps(30);
    const QPoint middle = m_plot->axisRect()->rect().center();
    hover(m_plot, QPoint(int(m_plot->xAxis->coordToPixel(2.0)), middle.y()));
    m_fixture->window().refresh();
    const QString text = readOutOf(m_plot);
    Sample sample;
    const inspector::SampleRing &samples = m_fixture->simulation().samples();
    QVERIFY(samples.read(samples.find(text.section(' ', 0, 0).toDouble() - 1e-6), sample));
    const double shown = sample[Channel::Distance];
    const QString expected = QString("%1 mm = %2 R").arg(shown * 1e3, 0, 'g', 4).arg(shown / 0.006, 0, 'g', 3);
    QVERIFY2(text.contains(expected), qPrintable(text));
}

void TestWindowComparison::readOutIsWholeBesideALongLegend() {
    compareWith({});
    makeSteps(40);
    QTRY_VERIFY(showsBandUntil(0.3)); // which the legend names, too
    hover(m_plot, m_plot->axisRect()->rect().center());
    m_fixture->window().refresh();
    m_plot->replot();
    QVERIFY2(isReadOutWhole(m_plot), qPrintable(readOutOf(m_plot)));
}

// Under the cursor; a dot at NaN would be drawn at no sample.
void TestWindowComparison::missingValueHasNoDot() {
    const auto dots = [this] {
        int count = 0;
        for (int i = 0; i < m_plot->itemCount(); ++i) {
            const auto *dot = qobject_cast<QCPItemTracer *>(m_plot->item(i));
            count += dot && dot->visible();
        }
        return count;
    };
    makeSteps(10);
    hover(m_plot, m_plot->axisRect()->rect().center());
    m_fixture->window().refresh();
    QVERIFY(!readOutOf(m_plot).isEmpty());
    QCOMPARE(dots(), 0);
    compareWith({});
    makeSteps(10);
    QVERIFY(!readOutOf(m_plot).isEmpty());
    hover(m_plot, QPoint(int(m_plot->xAxis->coordToPixel(0.15)), m_plot->axisRect()->rect().center().y()));
    m_fixture->window().refresh();
    QCOMPARE(dots(), 1);
}

// Steps made by the ghost that the legend names.
void TestWindowComparison::curveBeginsAnewWithAnotherGhost() {
    compareWith({"exact", 1});
    makeSteps(20);
    m_fixture->session().comparison().setGhostChoice({"explicit-euler", 1});
    makeSteps(10);
    const auto data = m_plot->graph(m_plot->graphCount() - 1)->data();
    QCOMPARE(data->size(), 10);
    Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(20, sample));
    QCOMPARE(data->at(0)->key, sample.time);
}

void TestWindowComparison::fileBesideTheTableNamesTheGhostOfEachRow() {
    compareWith({"exact", 4});
    makeSteps(20);
    m_fixture->session().comparison().setGhostChoice({"explicit-euler", 4});
    makeSteps(10);
    m_fixture->session().comparison().setGhostChoice({"rk4", 4}); // makes no row
    m_fixture->trigger("save_run");
    m_fixture->answerFile(m_fixture->path("t.csv"));
    QByteArrayList compare;
    for (const QByteArray &line : support::contentOf(m_fixture->path("t.csv.txt")).split('\n'))
        if (line.contains("compare")) compare += line.left(line.lastIndexOf(' ')); // without versions
    QCOMPARE(compare, QByteArrayList({"compare exact", "compare-substeps", "from 0.21 s: compare explicit-euler",
                                      "from 0.21 s: compare starts anew at the"}));
}

void TestWindowComparison::savedTableHasTheGhost() {
    compareWith({});
    makeSteps(5);
    const QString file = m_fixture->path("distance.csv");
    QString error;
    QVERIFY2(m_plot->save(file, &error), qPrintable(error));
    QFile table(file);
    QVERIFY(table.open(QIODevice::ReadOnly));
    const QByteArrayList lines = table.readAll().trimmed().split('\n');
    QCOMPARE(lines.size(), 6);
    QVERIFY(lines[0].contains(",ghost_x [m],"));
    QCOMPARE(lines[5].split(',').value(2 + qsizetype(Channel::Distance)).toDouble(), distance());
}

// Where the ghost is, the picture becomes bluer when it appears; elsewhere, except for the trails, no pixel changes.
void TestWindowComparison::ghostIsDrawnWhereItIs() {
    QVERIFY(m_fixture->session().openLevel(m_fixture->session().levels().listed().at(1)));
    m_fixture->parameters().set({{"tilt_x", 8.0}, {"tilt_y", 8.0}});
    chooseDt(m_fixture->session(), 0.1);
    compareWith({"explicit-euler", 1});
    for (int i = 0; i < 40 && distance() < 2.5 * 0.006; ++i) makeSteps(1);
    QVERIFY(distance() >= 2.5 * 0.006); // nothing of the ghost is behind the ball

    const inspector::gl::MazeView &view = m_fixture->window().view();
    const QImage with = picture();
    const auto placeOf = [&](const glm::dvec3 &point) {
        return (view.positionOf(point) * view.devicePixelRatioF()).toPoint();
    };
    const inspector::gl::Frame frame = inspector::ui::currentFrame(m_fixture->session());
    const glm::dvec3 centre = frame.ghosts.at(0).ball.position;
    const QPoint place = placeOf(centre);
    const int radius = int(QLineF(place, placeOf(centre + glm::dvec3(0.006, 0.0, 0.0))).length());
    QRect changed(place, place);
    for (const inspector::gl::Trail &trail : frame.trails)
        for (const glm::dvec3 &point : trail.points) changed |= QRect(placeOf(point), QSize(1, 1));
    changed.adjust(-2 * radius, -2 * radius, 2 * radius, 2 * radius);

    m_fixture->press(Qt::Key_C);
    QTRY_VERIFY(!now().ghost);
    const QImage without = picture();
    QVERIFY(with.rect().contains(place));
    const auto blue = [](QRgb colour) { return qBlue(colour) - qRed(colour); };
    QVERIFY(blue(with.pixel(place)) > blue(without.pixel(place)) + 40);
    for (int y = 0; y < with.height(); ++y)
        for (int x = 0; x < with.width(); ++x)
            if (!changed.contains(x, y)) QCOMPARE(with.pixel(x, y), without.pixel(x, y));
}

void TestWindowComparison::ghostOnTheBallIsHidden() {
    const QImage without = picture();
    compareWith({});
    const QImage with = picture();
    QCOMPARE(with, without);
}

void TestWindowComparison::trailsAreBoundedAndOfTheLegendsColours() {
    m_fixture->parameters().set({{"restitution_wall", 1.0}}); // both are still moving at the end
    chooseDt(m_fixture->session(), 0.1);
    compareWith({"explicit-euler", 1});
    makeSteps(40); // 4 s
    const inspector::gl::Frame frame = inspector::ui::currentFrame(m_fixture->session());
    QCOMPARE(frame.ghosts.size(), size_t(1));
    QCOMPARE(frame.trails.size(), size_t(2));
    Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(m_fixture->simulation().samples().find(0.99), sample));
    const glm::dvec3 oldest[] = {{sample[Channel::PositionX], sample[Channel::PositionY], sample[Channel::PositionZ]},
                                 {sample[Channel::GhostX], sample[Channel::GhostY], sample[Channel::GhostZ]}};
    for (size_t i = 0; i < 2; ++i) {
        const inspector::gl::Trail &trail = frame.trails[i];
        QVERIFY(trail.points.size() <= 32); // 3 s and the end
        QVERIFY(glm::distance(trail.points.front(), oldest[i]) == 0.0);
        const QColor legend = m_plot->graph(int(i))->pen().color();
        QCOMPARE(QColor::fromRgbF(trail.colour.r, trail.colour.g, trail.colour.b).rgb(), legend.rgb());
    }
    QVERIFY(frame.trails[0].points.back() != frame.trails[1].points.back());
    m_fixture->press(Qt::Key_M);
    QTRY_COMPARE(distance(), 0.0);
    QVERIFY(inspector::ui::currentFrame(m_fixture->session()).trails[1].points.size() <= 1); // begins anew
}

void TestWindowComparison::coloursCanBeTold_data() {
    QTest::addColumn<QString>("theme");
    for (const char *theme : {"theme_1", "theme_2"}) QTest::newRow(theme) << theme;
}

// WCAG 2.1, 1.4.11: the luminance of lines and of their background differ by a factor of 3.
void TestWindowComparison::coloursCanBeTold() {
    QFETCH(QString, theme);
    m_fixture->trigger(theme);
    QTRY_COMPARE(m_plot->palette().color(QPalette::Base).lightness() < 128, theme == "theme_2"); // the dark one
    compareWith({});
    const auto luminance = [](const QColor &colour) {
        const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
        return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
    };
    const double back = luminance(m_plot->palette().color(QPalette::Base));
    for (int i = 0; i < m_plot->graphCount(); ++i) {
        if (m_plot->graph(i)->pen().style() == Qt::NoPen) continue; // the edges of the band
        const double front = luminance(m_plot->graph(i)->pen().color());
        QVERIFY((std::max(front, back) + 0.05) / (std::min(front, back) + 0.05) >= 3.0);
    }
}

// Straight up, so fast that the ghost would need more substeps than are allowed; exact has no such limit in free
// flight.
void TestWindowComparison::refuseTheGhost() {
    chooseStepper(m_fixture->session(), "exact");
    compareWith({"symplectic-euler", 1});
    phys_state state = now().current;
    state.velocity.z = 1e6;
    m_fixture->simulation().setState(state);
    m_fixture->trigger("step");
    QTRY_VERIFY(!m_fixture->window().messages().line().isEmpty());
}

void TestWindowComparison::refusalIsOneLineInBarAndDock() {
    refuseTheGhost();
    const QString line = m_fixture->window().messages().line();
    QVERIFY2(line.startsWith("comparison with Symplectic Euler: this step needs"), qPrintable(line));
    QVERIFY(!now().ghost);
    QCOMPARE(figures(), line);
    makeSteps(3);
    QCOMPARE(m_fixture->window().messages().line(), line);
}

// Where both have met again.
void TestWindowComparison::refusalIsForgottenAtARestart() {
    refuseTheGhost();
    m_fixture->press(Qt::Key_R);
    QTRY_VERIFY(now().ghost);
    QTRY_VERIFY(m_fixture->window().messages().line().isEmpty());
    QVERIFY(m_fixture->session().comparison().refusal().isEmpty());
}

void TestWindowComparison::optionOpensTheDock() {
    m_fixture->find<QDockWidget>("comparison_dock")->close();
    compareWith({}); // like a session that was opened with the option
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    const auto *dock = m_fixture->find<QDockWidget>("comparison_dock");
    QTRY_VERIFY(dock->isVisible() && !dock->visibleRegion().isEmpty());
    QVERIFY(m_fixture->find<QAction>("compare")->isChecked());
}

QTEST_MAIN(TestWindowComparison)
#include "tst_window_comparison.moc"
