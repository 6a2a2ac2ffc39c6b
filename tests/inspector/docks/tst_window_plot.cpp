// SPDX-License-Identifier: MIT
// The live plot shows the ring's samples, and its mouse and keyboard actions work.
#include "inspector/stepping.h"
#include "ui/parts/message_bar.h"
#include "ui/plots/phase_plot.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/quantity_menu.h"
#include "window_fixture.h"

#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>

using namespace window_test;
using inspector::Channel;
using inspector::Sample;

class TestWindowPlot : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void curvesAreTheRingsSamples();
    void axesAndLegendSayWhatIsShown();
    void followsTheNewestSample();
    void dragPansAndEndsFollowing();
    void followButtonFollowsAgain();
    void wheelZoomsTheTime();
    void wheelOverTheAxisZoomsTheValues();
    void doubleClickFollowsAgain();
    void zoomHasLimits();
    void doubleClickRestoresBothAxesAtAStandstill();
    void pauseHoldsThePlotWhileTheBallRolls();
    void clearForgetsWhatWas();
    void restartShowsTheNewRun();
    void readOutIsTheSampleUnderTheCursor();
    void unitsThatDifferAreInLegendAndValues();
    void readOutEndsWhereTheCursorLeaves();
    void readOutIsWhole_data();
    void readOutIsWhole();
    void tableHasEverySample();
    void pictureAndDocumentAreWritten_data();
    void pictureAndDocumentAreWritten();
    void nameWithoutAKnownEndingIsRefused();
    void fileThatCantBeWrittenIsShown();
    void saveAsksForAName();
    void savePlotSavesWhatIsSeen();
    void darkPaletteGivesADarkPlot();
    void addedPlotSharesTheTime();
    void plotIsAddedWhileValuesAreRead();
    void addedPlotSharesTheHeight();
    void chosenQuantityIsPlotted();
    void valuesOnALogarithmicAxisFitIt();
    void labelsOfALogarithmicAxisAreItsTicks();
    void plotFollowsTheMomentShown();
    void wheelZoomsAPausedPlotAtThePointer();
    void quantityOverAnotherIsTheSamples();
    void valuesUnderTheCursorOfAPhasePlotAreShown();
    void unknownQuantitiesOfTheSettingsAreNotSet();
    void droppedQuantityIsAdded();
    void plotsAreRememberedAndReset();
    void plotHasAQuarterOfTheWindow();

private:
    void makeSteps(uint64_t count);
    QMenu *menuOf(QWidget *plot);
    inspector::ui::PlotStack &stack() { return *m_fixture->find<inspector::ui::PlotStack>("plots"); }
    // In the order in which they are stacked.
    template<class Plot>
    QList<Plot *> shown() {
        QList<Plot *> result;
        for (int i = 0; i < stack().count(); ++i) {
            auto *plot = qobject_cast<Plot *>(stack().widget(i));
            if (plot && !plot->isHidden()) result += plot;
        }
        return result;
    }
    QList<inspector::ui::QuantityPlot *> plots() { return shown<inspector::ui::QuantityPlot>(); }
    QList<inspector::ui::PhasePlot *> phasePlots() { return shown<inspector::ui::PhasePlot>(); }
    QString readOut() const { return readOutOf(m_plot); }
    QPoint middle() const { return m_plot->axisRect()->rect().center(); }

    inspector::ui::QuantityPlot *m_plot = nullptr;
};

void TestWindowPlot::init() {
    QVERIFY(open());
    m_plot = m_fixture->find<inspector::ui::QuantityPlot>("velocity_plot");
    inspector::Parameters &parameters = m_fixture->parameters();
    parameters.set(parameters.indexOf("tilt_y"), 5.0); // so that there is something to see
}

// By hand: the same samples in every run.
void TestWindowPlot::makeSteps(uint64_t count) {
    m_fixture->makeSteps(count);
    m_fixture->window().refresh();
}

void TestWindowPlot::curvesAreTheRingsSamples() {
    makeSteps(20);
    const Channel channels[] = {Channel::VelocityX, Channel::VelocityY, Channel::Speed};
    QCOMPARE(m_plot->graphCount(), 4); // the last is a ghost's
    for (int i = 0; i < 3; ++i) {
        const auto data = m_plot->graph(i)->data();
        QCOMPARE(data->size(), 20);
        for (int n = 0; n < 20; ++n) {
            Sample sample;
            QVERIFY(m_fixture->simulation().samples().read(uint64_t(n), sample));
            QCOMPARE(data->at(n)->key, sample.time);
            QCOMPARE(data->at(n)->value, sample[channels[i]]);
        }
    }
}

void TestWindowPlot::axesAndLegendSayWhatIsShown() {
    QVERIFY(m_plot->xAxis->label().contains("[s]"));
    QVERIFY(m_plot->yAxis->label().contains("[m/s]"));
    QVERIFY(m_plot->legend->visible());
    QCOMPARE(m_plot->legend->itemCount(), 3);
}

void TestWindowPlot::followsTheNewestSample() {
    chooseDt(m_fixture->session(), 1.0 / 16.0);
    makeSteps(200); // 12.5 s, more than the window of time
    Sample newest;
    QVERIFY(m_fixture->simulation().samples().read(199, newest));
    QCOMPARE(m_plot->xAxis->range().upper, newest.time);
}

void TestWindowPlot::dragPansAndEndsFollowing() {
    makeSteps(20);
    const QCPRange before = m_plot->xAxis->range();
    drag(m_plot, middle(), middle() - QPoint(100, 0));
    const double moved = 100.0 * before.size() / m_plot->axisRect()->width();
    QVERIFY(!m_plot->isFollowing());
    QVERIFY(!m_fixture->find<QToolButton>("plot_follow")->isChecked());
    // Accurate to a pixel.
    QVERIFY(std::abs(m_plot->xAxis->range().lower - (before.lower + moved)) <
            before.size() / m_plot->axisRect()->width());
}

void TestWindowPlot::followButtonFollowsAgain() {
    makeSteps(20);
    const QCPRange before = m_plot->xAxis->range();
    drag(m_plot, middle(), middle() - QPoint(100, 0));
    click(m_fixture->find<QToolButton>("plot_follow"));
    QVERIFY(m_plot->isFollowing());
    m_fixture->window().refresh();
    QCOMPARE(m_plot->xAxis->range().lower, before.lower);
}

void TestWindowPlot::wheelZoomsTheTime() {
    makeSteps(20);
    const double before = m_plot->xAxis->range().size();
    turnWheel(m_plot, middle(), 2);
    m_fixture->window().refresh();
    QVERIFY(m_plot->xAxis->range().size() < before);
    QVERIFY(m_plot->isFollowing());
}

void TestWindowPlot::wheelOverTheAxisZoomsTheValues() {
    makeSteps(20);
    const QCPRange times = m_plot->xAxis->range();
    const double before = m_plot->yAxis->range().size();
    turnWheel(m_plot, QPoint(m_plot->axisRect()->left() - 20, middle().y()), 2);
    m_fixture->window().refresh();
    QVERIFY(m_plot->yAxis->range().size() < before);
    QCOMPARE(m_plot->xAxis->range().size(), times.size());
}

void TestWindowPlot::doubleClickFollowsAgain() {
    makeSteps(20);
    drag(m_plot, middle(), middle() - QPoint(100, 0));
    QVERIFY(!m_plot->isFollowing());
    QTest::mouseDClick(m_plot, Qt::LeftButton, {}, middle());
    QVERIFY(m_plot->isFollowing());
}

// Both axes, in both directions, following and not.
void TestWindowPlot::zoomHasLimits() {
    makeSteps(20);
    const QPoint axis(m_plot->axisRect()->left() - 20, middle().y());
    for (const bool isFollowing : {true, false}) {
        m_plot->setFollowing(isFollowing);
        for (const int notches : {1, -1}) {
            for (int i = 0; i < 300; ++i) {
                turnWheel(m_plot, middle(), notches);
                turnWheel(m_plot, axis, notches);
            }
            m_fixture->window().refresh();
            QVERIFY(m_plot->xAxis->range().size() >= 0.0099 && m_plot->xAxis->range().size() <= 3601.0);
            QVERIFY(m_plot->yAxis->range().size() >= 0.99e-9 && m_plot->yAxis->range().size() <= 1.01e9);
        }
    }
}

void TestWindowPlot::doubleClickRestoresBothAxesAtAStandstill() {
    makeSteps(20);
    m_plot->setFollowing(false);
    m_plot->setFollowing(true);
    m_fixture->window().refresh();
    const QCPRange times = m_plot->xAxis->range();
    const QCPRange values = m_plot->yAxis->range();
    drag(m_plot, middle(), middle() - QPoint(100, 0));
    turnWheel(m_plot, QPoint(m_plot->axisRect()->left() - 20, middle().y()), 5);
    QVERIFY(m_plot->yAxis->range().size() < 0.9 * values.size());
    QTest::mouseDClick(m_plot, Qt::LeftButton, {}, middle());
    QCOMPARE(m_plot->xAxis->range().lower, times.lower);
    QCOMPARE(m_plot->yAxis->range().lower, values.lower);
    QCOMPARE(m_plot->yAxis->range().upper, values.upper);
}

void TestWindowPlot::pauseHoldsThePlotWhileTheBallRolls() {
    makeSteps(20);
    click(m_fixture->find<QToolButton>("plot_pause"));
    QVERIFY(m_plot->isPaused());
    makeSteps(20);
    QCOMPARE(m_plot->graph(0)->data()->size(), 20);
    click(m_fixture->find<QToolButton>("plot_pause"));
    m_fixture->window().refresh();
    QCOMPARE(m_plot->graph(0)->data()->size(), 40);
}

void TestWindowPlot::clearForgetsWhatWas() {
    makeSteps(20);
    click(m_fixture->find<QToolButton>("plot_clear"));
    QCOMPARE(m_plot->graph(0)->data()->size(), 0);
    makeSteps(5);
    QCOMPARE(m_plot->graph(0)->data()->size(), 5);
}

void TestWindowPlot::restartShowsTheNewRun() {
    makeSteps(20);
    m_fixture->press(Qt::Key_R);
    QTRY_COMPARE(m_plot->graph(0)->data()->size(), 0);
}

void TestWindowPlot::readOutIsTheSampleUnderTheCursor() {
    makeSteps(20);
    Sample wanted;
    QVERIFY(m_fixture->simulation().samples().read(12, wanted));
    hover(m_plot, QPoint(int(std::lround(m_plot->xAxis->coordToPixel(wanted.time))), middle().y()));
    m_fixture->window().refresh();
    QVERIFY2(readOut().startsWith(QString("%1 s ").arg(wanted.time, 0, 'f', 4)), qPrintable(readOut()));
}

void TestWindowPlot::unitsThatDifferAreInLegendAndValues() {
    makeSteps(20);
    m_plot->setContent(inspector::ui::plotContentOf("speed,position_z"));
    QCOMPARE(m_plot->graph(1)->name(), QString("Position z [m]"));
    hover(m_plot, middle());
    m_fixture->window().refresh();
    QVERIFY2(readOut().contains(" m/s | ") && readOut().endsWith(" m"), qPrintable(readOut()));
}

void TestWindowPlot::readOutEndsWhereTheCursorLeaves() {
    makeSteps(20);
    hover(m_plot, middle());
    m_fixture->window().refresh();
    QVERIFY(!readOut().isEmpty());
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(m_plot, &leave);
    m_fixture->window().refresh();
    QVERIFY(readOut().isEmpty());
}

void TestWindowPlot::readOutIsWhole_data() {
    QTest::addColumn<QString>("content");
    QTest::newRow("one quantity") << "speed";
    QTest::newRow("several") << "velocity_x,velocity_y,speed";
    QTest::newRow("many") << "velocity_x,velocity_y,speed,position_x,position_y";
}

void TestWindowPlot::readOutIsWhole() {
    QFETCH(const QString, content);
    makeSteps(20);
    m_plot->setContent(inspector::ui::plotContentOf(content));
    m_fixture->window().resize(800, 600);
    QTRY_VERIFY(m_plot->width() < 450);
    m_fixture->window().refresh();
    hover(m_plot, middle());
    m_fixture->window().refresh();
    m_plot->replot();
    QVERIFY(!readOut().isEmpty());
    QVERIFY2(isReadOutWhole(m_plot), qPrintable(readOut()));
    QVERIFY2(m_plot->axisRect()->height() >= 20, qPrintable(QString::number(m_plot->axisRect()->height())));
}

void TestWindowPlot::tableHasEverySample() {
    makeSteps(20);
    const QString path = m_fixture->path("plot.csv");
    QVERIFY(m_plot->save(path, nullptr));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
    QCOMPARE(lines.size(), 21);
    QVERIFY(lines[0].startsWith("time [s],step,"));
    const qsizetype speed = lines[0].split(',').indexOf("speed [m/s]");
    Sample last;
    QVERIFY(m_fixture->simulation().samples().read(19, last));
    QCOMPARE(lines[20].split(',').value(speed).toDouble(), last[Channel::Speed]);
}

void TestWindowPlot::pictureAndDocumentAreWritten_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("magic");
    QTest::newRow("png") << "plot.png" << QByteArray("\x89PNG");
    QTest::newRow("pdf") << "plot.pdf" << QByteArray("%PDF-");
}

void TestWindowPlot::pictureAndDocumentAreWritten() {
    QFETCH(QString, name);
    QFETCH(QByteArray, magic);
    makeSteps(20);
    QVERIFY(m_plot->save(m_fixture->path(name), nullptr));
    QFile file(m_fixture->path(name));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.read(magic.size()), magic);
}

void TestWindowPlot::nameWithoutAKnownEndingIsRefused() {
    QString error;
    QVERIFY(!m_plot->save(m_fixture->path("plot.doc"), &error));
    QVERIFY2(error.contains("plot.doc") && error.contains(".csv"), qPrintable(error));
    QVERIFY(!QFile::exists(m_fixture->path("plot.doc")));
}

void TestWindowPlot::fileThatCantBeWrittenIsShown() {
    for (const char *name : {"missing/plot.csv", "missing/plot.png", "missing/plot.pdf"}) {
        QString error;
        QVERIFY(!m_plot->save(m_fixture->path(name), &error));
        QVERIFY2(error.contains(name), qPrintable(error));
    }
}

void TestWindowPlot::saveAsksForAName() {
    makeSteps(20);
    click(m_fixture->find<QToolButton>("plot_save"));
    auto *dialog = m_fixture->window().findChild<QFileDialog *>();
    QVERIFY(dialog);
    auto *name = dialog->findChild<QLineEdit *>("fileNameEdit");
    QVERIFY(name);
    name->setText(m_fixture->path("chosen")); // the ending comes from the kind of file
    click(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Save));
    QTRY_VERIFY(QFile::exists(m_fixture->path("chosen.png")));
    QCOMPARE(m_fixture->game().phase(), inspector::Game::Phase::Prompt);
}

void TestWindowPlot::savePlotSavesWhatIsSeen() {
    const auto suggested = [this] {
        m_fixture->trigger("save_plot");
        auto *dialog = m_fixture->window().findChild<QFileDialog *>();
        const QString name = dialog ? dialog->findChild<QLineEdit *>("fileNameEdit")->text() : QString();
        delete dialog;
        return name.section('/', -1);
    };
    QCOMPARE(suggested(), QString("plot"));
    for (const auto &[key, name] : {std::pair(Qt::Key_4, "trade"), std::pair(Qt::Key_5, "distance")}) {
        m_fixture->press(key, Qt::ControlModifier);
        QTRY_VERIFY(m_plot->visibleRegion().isEmpty());
        QCOMPARE(suggested(), QString(name));
    }
    m_fixture->find<QDockWidget>("comparison_dock")->setFloating(true); // beside the curves, both are seen
    m_fixture->press(Qt::Key_3, Qt::ControlModifier);
    QTRY_VERIFY(!m_plot->visibleRegion().isEmpty());
    QCOMPARE(suggested(), QString("plot"));
}

void TestWindowPlot::darkPaletteGivesADarkPlot() {
    m_fixture->trigger("theme_2");
    QTRY_VERIFY(m_plot->toPixmap().toImage().pixelColor(2, 2).lightness() < 80);
    m_fixture->trigger("theme_1");
    QTRY_VERIFY(m_plot->toPixmap().toImage().pixelColor(2, 2).lightness() > 200);
}

// As a right click opens it.
QMenu *TestWindowPlot::menuOf(QWidget *plot) {
    const QPoint place = plot->rect().center();
    QContextMenuEvent asked(QContextMenuEvent::Mouse, place, plot->mapToGlobal(place));
    QApplication::sendEvent(plot, &asked);
    auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
    if (!menu) qFatal("no menu");
    return menu;
}

void TestWindowPlot::addedPlotSharesTheTime() {
    makeSteps(20);
    QMenu *menu = menuOf(m_plot);
    for (QAction *entry : menu->findChildren<QAction *>())
        if (entry->text() == "Energy") entry->trigger();
    menu->close();
    QCOMPARE(plots().size(), 2);
    inspector::ui::QuantityPlot *added = plots()[1];
    QTRY_VERIFY(added->height() > 0);
    drag(m_plot, middle(), middle() - QPoint(100, 0));
    m_fixture->window().refresh();
    QCOMPARE(added->xAxis->range(), m_plot->xAxis->range());
    QVERIFY(!added->isFollowing());
    hover(m_plot, middle());
    m_fixture->window().refresh();
    QCOMPARE(readOutOf(added).isEmpty(), readOut().isEmpty());
    QTest::mouseDClick(added, Qt::LeftButton, {}, added->axisRect()->center());
    QVERIFY(m_plot->isFollowing());
    QCOMPARE(added->axisRect()->left(), m_plot->axisRect()->left()); // aligned
}

void TestWindowPlot::plotIsAddedWhileValuesAreRead() {
    makeSteps(20);
    hover(m_plot, middle());
    m_fixture->window().refresh();
    QVERIFY(!readOut().isEmpty());
    QMenu *menu = menuOf(m_plot);
    for (QAction *entry : menu->findChildren<QAction *>())
        if (entry->text() == "Energy") entry->trigger();
    menu->close();
    m_fixture->window().refresh();
    QCOMPARE(plots().size(), 2);
    QVERIFY(!readOutOf(plots()[1]).isEmpty());
}

void TestWindowPlot::addedPlotSharesTheHeight() {
    m_fixture->window().resizeDocks({m_fixture->find<QDockWidget>("plot_dock")}, {400}, Qt::Vertical);
    for (const char *name : {"Energy", "The way on the board (y over x)"}) {
        QMenu *menu = menuOf(m_plot);
        for (QAction *entry : menu->findChildren<QAction *>())
            if (entry->text() == QLatin1String(name)) entry->trigger();
        menu->close();
        QApplication::processEvents();
        const QList<int> heights = stack().sizes();
        const auto [least, largest] = std::minmax_element(heights.begin(), heights.end());
        QVERIFY2(*largest - *least <= 2, qPrintable(QStringLiteral("%1 to %2").arg(*least).arg(*largest)));
    }
    QCOMPARE(stack().count(), 3);
}

void TestWindowPlot::chosenQuantityIsPlotted() {
    makeSteps(20);
    QMenu *menu = menuOf(m_plot);
    menu->findChild<QMenu *>("Energy")->findChild<QAction *>("kinetic")->trigger();
    menu->close();
    m_fixture->window().refresh();
    QCOMPARE(m_plot->graphCount(), 5);
    Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(7, sample));
    QCOMPARE(m_plot->graph(4)->data()->at(7)->value, sample[Channel::Kinetic]);
    // E = v^2 / 2 + (R w)^2 / 5; a rolling ball's two are 7/10 v^2.
    QVERIFY(std::abs(sample[Channel::Kinetic] - 0.7 * std::pow(sample[Channel::Speed], 2)) < 1e-12);
}

void TestWindowPlot::valuesOnALogarithmicAxisFitIt() {
    makeSteps(20);
    m_plot->setContent(inspector::ui::plotContentOf("log:speed"));
    m_fixture->window().refresh();
    Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(19, sample));
    QVERIFY(m_plot->yAxis->range().upper >= sample[Channel::Speed]);
    QVERIFY(m_plot->yAxis->range().upper <= 10.0 * sample[Channel::Speed]);
    QVERIFY(m_plot->yAxis->range().lower > 0.0);
}

// However far it is zoomed in.
void TestWindowPlot::labelsOfALogarithmicAxisAreItsTicks() {
    makeSteps(20);
    m_plot->setContent(inspector::ui::plotContentOf("log:speed"));
    m_fixture->window().refresh();
    for (int notches = 0; notches < 12; ++notches) {
        turnWheel(m_plot, QPoint(m_plot->axisRect()->left() - 20, middle().y()), 1);
        m_fixture->window().refresh();
        m_plot->replot();
        const QVector<double> ticks = m_plot->yAxis->tickVector();
        const QVector<QString> labels = m_plot->yAxis->tickVectorLabels();
        QVERIFY(ticks.size() > 1);
        for (qsizetype i = 0; i < ticks.size(); ++i) {
            const double told = labels[i].toDouble();
            QVERIFY2(std::abs(told - ticks[i]) <= 1e-6 * ticks[i], qPrintable(labels[i]));
        }
    }
}

void TestWindowPlot::plotFollowsTheMomentShown() {
    makeSteps(150);
    m_plot->time().setRange({1.0, 1.5});
    m_plot->time().followAtThisZoom();
    m_fixture->window().refresh();
    QCOMPARE(m_plot->xAxis->range().upper, 1.5);
    for (const double time : {0.2, 1.0, 0.0}) {
        m_fixture->session().lookAtTime(time);
        QTRY_COMPARE(m_fixture->simulation().latest().current.time, time);
        m_fixture->window().refresh();
        QVERIFY(m_plot->xAxis->range().contains(time));
    }
    m_fixture->press(Qt::Key_Escape);
    QTRY_VERIFY(!m_fixture->session().isInPast());
    m_fixture->window().refresh();
    QCOMPARE(m_plot->xAxis->range().upper, 1.5);
}

// No new sample has to be seen then.
void TestWindowPlot::wheelZoomsAPausedPlotAtThePointer() {
    makeSteps(150);
    const int x = m_plot->axisRect()->left() + 30;
    const double time = m_plot->xAxis->pixelToCoord(x);
    turnWheel(m_plot, QPoint(x, middle().y()), 8);
    m_fixture->window().refresh();
    QVERIFY(m_plot->xAxis->range().size() < 5.0);
    QVERIFY(std::abs(m_plot->xAxis->pixelToCoord(x) - time) < 0.01);
}

void TestWindowPlot::quantityOverAnotherIsTheSamples() {
    makeSteps(20);
    const inspector::ui::PhasePlot *phase = stack().addPhasePlot(Channel::PositionY, Channel::VelocityY);
    m_fixture->window().refresh();
    QCOMPARE(phase->curve().data()->size(), 20);
    Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(7, sample));
    QCOMPARE(phase->curve().data()->at(7)->key, sample[Channel::PositionY]);
    QCOMPARE(phase->curve().data()->at(7)->value, sample[Channel::VelocityY]);
}

// The time plots show the same moment.
void TestWindowPlot::valuesUnderTheCursorOfAPhasePlotAreShown() {
    makeSteps(20);
    inspector::ui::PhasePlot *phase = stack().addPhasePlot(Channel::PositionX, Channel::PositionY);
    m_fixture->window().refresh();
    QTRY_VERIFY(phase->axisRect()->height() > 0);
    const QCPCurveData point = *phase->curve().data()->at(7);
    hover(phase,
          QPoint(qRound(phase->xAxis->coordToPixel(point.key)), qRound(phase->yAxis->coordToPixel(point.value))));
    m_fixture->window().refresh();
    const QString time = readOutOf(phase).section(' ', 0, 0);
    Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(qRound(time.toDouble() / 0.01) - 1, sample));
    const QString values =
        QString("%1 | %2").arg(sample[Channel::PositionX], 0, 'g', 6).arg(sample[Channel::PositionY], 0, 'g', 6);
    QVERIFY2(readOutOf(phase).endsWith(values), qPrintable(readOutOf(phase) + " and not " + values));
    QVERIFY2(readOutOf(m_plot).startsWith(time + " s"), qPrintable(readOutOf(m_plot)));
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(phase, &leave);
    m_fixture->window().refresh();
    QCOMPARE(readOutOf(phase), QString());
}

void TestWindowPlot::unknownQuantitiesOfTheSettingsAreNotSet() {
    m_fixture->settings().setValue("window/plots", QStringList{"weight", "log:colour"});
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    QCOMPARE(plots().size(), 1);
    QCOMPARE(textOf(stack().first().content()), QString("velocity_x,velocity_y,speed,ghost_speed"));
}

void TestWindowPlot::droppedQuantityIsAdded() {
    QMimeData data;
    data.setData(QLatin1String(inspector::ui::kQuantityMime), "spin_x");
    QDragEnterEvent entered(middle(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(m_plot, &entered);
    QVERIFY(entered.isAccepted());
    QDropEvent dropped(middle(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(m_plot, &dropped);
    QCOMPARE(m_plot->content().channels.back(), Channel::SpinX);
}

void TestWindowPlot::plotsAreRememberedAndReset() {
    stack().addPlot(inspector::ui::plotContentOf("log:distance"));
    stack().addPhasePlot(Channel::PositionX, Channel::PositionY);
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    QCOMPARE(plots().size(), 2);
    QCOMPARE(textOf(plots()[1]->content()), QString("log:distance"));
    QCOMPARE(phasePlots().size(), 1);
    m_fixture->trigger("reset_layout");
    QCOMPARE(plots().size(), 1);
    QVERIFY(phasePlots().isEmpty());
    QCOMPARE(textOf(stack().first().content()), QString("velocity_x,velocity_y,speed,ghost_speed"));
}

void TestWindowPlot::plotHasAQuarterOfTheWindow() {
    QTRY_VERIFY2(4 * m_plot->height() >= m_fixture->window().height(), qPrintable(QString::number(m_plot->height())));
}

QTEST_MAIN(TestWindowPlot)
#include "tst_window_plot.moc"
