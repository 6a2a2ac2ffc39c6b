// SPDX-License-Identifier: MIT
// Docks, bars and menus: closed, opened, moved, remembered and reset.
#include "gl/view/maze_view.h"
#include "inspector/camera_elevation.h"
#include "inspector/contrast.h"
#include "support/compare.h"
#include "ui/game/game_strip.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/theme.h"
#include "window_fixture.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QScreen>
#include <QScrollArea>
#include <QSignalSpy>
#include <QStyleOptionViewItem>
#include <QTimer>
#include <QToolButton>
#include <QWindow>

#include <algorithm>

#include <qcustomplot.h>

using namespace window_test;

namespace {
/// Windows in the order in which they are shown.
struct ShownWindows : QObject {
    bool eventFilter(QObject *object, QEvent *event) override {
        if (object->isWindowType() && event->type() == QEvent::Show) list << object;
        return false;
    }
    QList<const QObject *> list;
};

/// A row for each dock of a window that is one of those.
template<class Predicate>
void addDocks(Predicate isOneOfThose) {
    QTest::addColumn<QString>("name");
    Fixture fixture;
    QVERIFY(fixture.isReady());
    for (QDockWidget *dock : fixture.window().findChildren<QDockWidget *>())
        if (isOneOfThose(fixture.window().dockWidgetArea(dock), *dock))
            QTest::newRow(qPrintable(dock->objectName())) << dock->objectName();
}
} // namespace

class TestWindowDocks : public WindowSuite {
    Q_OBJECT

private slots:
    void dockClosesByItsButtonAndReopensByTheMenu_data();
    void dockClosesByItsButtonAndReopensByTheMenu();
    void keyOpensADockAndGivesItTheKeyboard_data();
    void keyOpensADockAndGivesItTheKeyboard();
    void keyRaisesADockThatLiesBehindAnother();
    void viewMenuTicksWhatIsOpen();
    void resetLayoutBringsEveryDockBack();
    void layoutIsRemembered();
    void layoutStaysHoweverOftenTheWindowIsReopened();
    void floatingDockIsShownAfterTheWindow();
    void viewIsTheLargestPart();
    void noTextOfTheParametersIsCut();
    void parametersNeedLittleRoom();
    void dockGivesItsRoomBack_data();
    void dockGivesItsRoomBack();
    void lastDockGivesItsRoomBack();
    void docksAtTheSideGiveTheirRoomBack();
    void hintsAreReadableOnADarkDesktop();
    void emptyCheckBoxesAreSeen_data();
    void emptyCheckBoxesAreSeen();
    void qualityReachesTheView_data();
    void qualityReachesTheView();
    void qualityIsRemembered();
    void viewChoosesTheQualityAgain();
    void windowLargerThanTheScreenIsFitted();
    void cameraLooksFromAboveAndBack();
    void chosenSpeedReachesTheSimulation();
    void anySpeedOfTheCommandLineIsInTheList();
    void chosenTimeStepReachesTheSimulation();
    void typedTimeStepReachesTheSimulation_data();
    void typedTimeStepReachesTheSimulation();
    void chosenStepperReachesTheSession();
    void statusSaysWhatTheSimulationDoes();
    void statusWritesTheSpeedAsItsChooser();
    void statusHasNoSignBeforeZero();
    void aboutNamesVersionsAndLicences();
    void stripWidensNoWindow();
    void standingWindowDrawsNothing();
    void messageCanBeReadInEveryTheme_data();
    void messageCanBeReadInEveryTheme();
    void watchedValueIsThatOfTheMoment();
    void bouncesLieBesideThePlots();

private:
    void chooseIn(const QString &chooser, int index);
};

// As with the keyboard: Home, then down.
void TestWindowDocks::chooseIn(const QString &chooser, int index) {
    auto *box = m_fixture->find<QComboBox>(chooser);
    box->setFocus(Qt::TabFocusReason);
    box->showPopup();
    QWidget *list = QApplication::activePopupWidget();
    QVERIFY(list);
    QTest::keyClick(list->focusWidget() ? list->focusWidget() : list, Qt::Key_Home);
    for (int i = 0; i < index; ++i) QTest::keyClick(list->focusWidget() ? list->focusWidget() : list, Qt::Key_Down);
    QTest::keyClick(list->focusWidget() ? list->focusWidget() : list, Qt::Key_Return);
}

void TestWindowDocks::dockClosesByItsButtonAndReopensByTheMenu_data() {
    addDocks([](Qt::DockWidgetArea, const QDockWidget &) { return true; });
}

void TestWindowDocks::dockClosesByItsButtonAndReopensByTheMenu() {
    QFETCH(QString, name);
    auto *dock = m_fixture->find<QDockWidget>(name);
    if (dock->isHidden()) m_fixture->trigger("show_" + name);
    QTRY_VERIFY(dock->isVisible());
    click(dock->findChild<QAbstractButton *>("qt_dockwidget_closebutton"));
    QTRY_VERIFY(!dock->isVisible());
    m_fixture->trigger("show_" + name);
    QTRY_VERIFY(dock->isVisible());
}

void TestWindowDocks::keyOpensADockAndGivesItTheKeyboard_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<Qt::Key>("key");
    QTest::newRow("parameters") << "parameters_dock" << Qt::Key_1;
    QTest::newRow("levels") << "levels_dock" << Qt::Key_2;
    QTest::newRow("plot") << "plot_dock" << Qt::Key_3;
    QTest::newRow("trade") << "trade_dock" << Qt::Key_4;
    QTest::newRow("comparison") << "comparison_dock" << Qt::Key_5;
    QTest::newRow("bounces") << "bounces_dock" << Qt::Key_6;
    QTest::newRow("track") << "track_dock" << Qt::Key_7;
    QTest::newRow("runs") << "runs_dock" << Qt::Key_8;
    QTest::newRow("watch") << "watch_dock" << Qt::Key_9;
    QTest::newRow("ball") << "ball_dock" << Qt::Key_0;
}

void TestWindowDocks::keyOpensADockAndGivesItTheKeyboard() {
    QFETCH(QString, name);
    QFETCH(Qt::Key, key);
    auto *dock = m_fixture->find<QDockWidget>(name);
    dock->close();
    m_fixture->press(key, Qt::ControlModifier);
    QVERIFY(dock->isVisible());
    QVERIFY(dock->isAncestorOf(QApplication::focusWidget()));
    m_fixture->press(key, Qt::ControlModifier);
    QVERIFY(!dock->isVisible());
}

void TestWindowDocks::keyRaisesADockThatLiesBehindAnother() {
    auto *plot = m_fixture->find<QDockWidget>("plot_dock");
    auto *trade = m_fixture->find<QDockWidget>("trade_dock");
    const auto isSeen = [](const QDockWidget *dock) { return dock->isVisible() && !dock->visibleRegion().isEmpty(); };
    m_fixture->press(Qt::Key_4, Qt::ControlModifier);
    QTRY_VERIFY(isSeen(trade) && !isSeen(plot));
    m_fixture->press(Qt::Key_3, Qt::ControlModifier);
    QTRY_VERIFY(isSeen(plot) && !isSeen(trade));
    QVERIFY(plot->isAncestorOf(QApplication::focusWidget()));
    QVERIFY(!trade->isHidden()); // behind
    m_fixture->press(Qt::Key_3, Qt::ControlModifier);
    QTRY_VERIFY(plot->isHidden() && isSeen(trade));
}

// Also for a dock behind another, which its entry brings to the front.
void TestWindowDocks::viewMenuTicksWhatIsOpen() {
    for (const QDockWidget *dock : m_fixture->window().findChildren<QDockWidget *>())
        QCOMPARE(m_fixture->find<QAction>("show_" + dock->objectName())->isChecked(), !dock->isHidden());
    auto *entry = m_fixture->find<QAction>("show_plot_dock");
    m_fixture->press(Qt::Key_4, Qt::ControlModifier);
    QVERIFY(entry->isChecked());
    entry->trigger();
    QVERIFY(entry->isChecked());
    entry->trigger();
    QVERIFY(!entry->isChecked());
}

void TestWindowDocks::resetLayoutBringsEveryDockBack() {
    auto *parameters = m_fixture->find<QDockWidget>("parameters_dock");
    auto *levels = m_fixture->find<QDockWidget>("levels_dock");
    auto *plot = m_fixture->find<QDockWidget>("plot_dock");
    parameters->close();
    levels->setFloating(true);
    m_fixture->window().addDockWidget(Qt::TopDockWidgetArea, plot);
    m_fixture->trigger("reset_layout");
    for (QDockWidget *dock : {parameters, levels, plot}) {
        QTRY_VERIFY(dock->isVisible());
        QVERIFY(!dock->isFloating());
    }
    QCOMPARE(m_fixture->window().dockWidgetArea(plot), Qt::BottomDockWidgetArea);
    QCOMPARE(m_fixture->window().dockWidgetArea(parameters), Qt::RightDockWidgetArea);
}

void TestWindowDocks::layoutIsRemembered() {
    m_fixture->find<QDockWidget>("levels_dock")->close();
    m_fixture->window().addDockWidget(Qt::TopDockWidgetArea, m_fixture->find<QDockWidget>("plot_dock"));
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    QVERIFY(!m_fixture->find<QDockWidget>("levels_dock")->isVisible());
    QCOMPARE(m_fixture->window().dockWidgetArea(m_fixture->find<QDockWidget>("plot_dock")), Qt::TopDockWidgetArea);
}

void TestWindowDocks::layoutStaysHoweverOftenTheWindowIsReopened() {
    m_fixture->window().resize(1280, 820);
    for (const Qt::Key key : {Qt::Key_5, Qt::Key_9, Qt::Key_0, Qt::Key_6}) m_fixture->press(key, Qt::ControlModifier);
    const auto layout = [this] {
        QStringList places;
        for (const QDockWidget *dock : m_fixture->window().findChildren<QDockWidget *>()) {
            if (dock->isHidden() || dock->visibleRegion().isEmpty()) continue;
            const QRect place = dock->geometry();
            places += QStringLiteral("%1 %2,%3 %4x%5")
                          .arg(dock->objectName())
                          .arg(place.x())
                          .arg(place.y())
                          .arg(place.width())
                          .arg(place.height());
        }
        places.sort();
        return places.join('\n');
    };
    QTRY_VERIFY(layout().contains("bounces_dock"));
    QApplication::processEvents(); // which lays out what the docks need
    const QString before = layout();
    for (int i = 0; i < 3; ++i) {
        m_fixture->reopen();
        QVERIFY(m_fixture->isReady());
        m_fixture->window().refresh();
        QCOMPARE(layout(), before);
    }
}

// Window managers keep above a window what is shown after it.
void TestWindowDocks::floatingDockIsShownAfterTheWindow() {
    m_fixture->find<QDockWidget>("levels_dock")->setFloating(true);
    ShownWindows shown;
    qApp->installEventFilter(&shown);
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    const auto *dock = m_fixture->find<QDockWidget>("levels_dock");
    QVERIFY(dock->isFloating());
    const auto *window = &m_fixture->window();
    QTRY_VERIFY(shown.list.lastIndexOf(dock->windowHandle()) > shown.list.lastIndexOf(window->windowHandle()));
    QVERIFY(dock->isVisible());
}

void TestWindowDocks::viewIsTheLargestPart() {
    const QSize view = m_fixture->window().view().size();
    const auto area = [](const QSize &size) { return size.width() * size.height(); };
    for (const QDockWidget *dock : m_fixture->window().findChildren<QDockWidget *>())
        QVERIFY2(area(dock->size()) < area(view), qPrintable(dock->objectName()));
}

void TestWindowDocks::noTextOfTheParametersIsCut() {
    for (const QLabel *label : m_fixture->find<QWidget>("parameters")->findChildren<QLabel *>())
        QVERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->text()));
}

void TestWindowDocks::parametersNeedLittleRoom() {
    auto *dock = m_fixture->find<QDockWidget>("parameters_dock");
    const auto *panel = m_fixture->find<QScrollArea>("parameters");
    m_fixture->window().resizeDocks({dock, m_fixture->find<QDockWidget>("levels_dock")}, {300, 300}, Qt::Horizontal);
    QTRY_VERIFY2(dock->width() <= 300, qPrintable(QString::number(panel->minimumWidth())));
    noTextOfTheParametersIsCut();
    for (const QLineEdit *box : panel->findChildren<QLineEdit *>())
        QVERIFY2(!box->isVisible() || box->fontMetrics().horizontalAdvance(box->text()) <= box->width() - 8,
                 qPrintable(box->objectName()));
    for (const QWidget *part : panel->widget()->findChildren<QWidget *>())
        QVERIFY2(!part->isVisible() ||
                     part->mapTo(panel->viewport(), part->rect().topRight()).x() < panel->viewport()->width(),
                 qPrintable(part->objectName()));
}

void TestWindowDocks::dockGivesItsRoomBack_data() {
    addDocks([](Qt::DockWidgetArea area, const QDockWidget &dock) {
        return area == Qt::BottomDockWidgetArea && dock.isHidden();
    });
}

// By the entry that opened it; while it is there, the board can be seen.
void TestWindowDocks::dockGivesItsRoomBack() {
    QFETCH(QString, name);
    const QWidget &view = m_fixture->window().view();
    m_fixture->window().resize(1280, 800);
    QTRY_VERIFY(view.height() > 300);
    const QSize before = view.size();
    m_fixture->trigger("show_" + name);
    QTRY_VERIFY(view.height() < before.height());
    QVERIFY2(view.height() >= 220, qPrintable(QString::number(view.height())));
    m_fixture->trigger("show_" + name);
    QTRY_COMPARE(view.size(), before);
}

// Whatever the order.
void TestWindowDocks::lastDockGivesItsRoomBack() {
    const QWidget &view = m_fixture->window().view();
    m_fixture->window().resize(1280, 800);
    QTRY_VERIFY(view.height() > 300);
    const QSize before = view.size();
    m_fixture->press(Qt::Key_4, Qt::ControlModifier);
    m_fixture->press(Qt::Key_8, Qt::ControlModifier);
    m_fixture->find<QDockWidget>("trade_dock")->close();
    m_fixture->press(Qt::Key_8, Qt::ControlModifier);
    QTRY_COMPARE(view.size(), before);
}

// At the side, too.
void TestWindowDocks::docksAtTheSideGiveTheirRoomBack() {
    m_fixture->window().resize(1280, 800);
    const QWidget *parameters = m_fixture->find<QDockWidget>("parameters_dock");
    const QWidget *levels = m_fixture->find<QDockWidget>("levels_dock");
    QTRY_VERIFY(parameters->height() > 200);
    const QSize before(parameters->height(), levels->height());
    m_fixture->press(Qt::Key_9, Qt::ControlModifier);
    m_fixture->press(Qt::Key_0, Qt::ControlModifier);
    QTRY_VERIFY(parameters->height() < before.width());
    m_fixture->press(Qt::Key_9, Qt::ControlModifier);
    m_fixture->press(Qt::Key_0, Qt::ControlModifier);
    QTRY_COMPARE(QSize(parameters->height(), levels->height()), before);
}

void TestWindowDocks::emptyCheckBoxesAreSeen_data() {
    QTest::addColumn<inspector::ui::Theme>("theme");
    QTest::newRow("light") << inspector::ui::Theme::Light;
    QTest::newRow("dark") << inspector::ui::Theme::Dark;
    QTest::newRow("desktop's") << inspector::ui::Theme::System; // a dark one
}

namespace {
QPalette darkDesktop() {
    const QColor text(252, 252, 252), button(49, 54, 59), window(42, 46, 50), base(27, 30, 32);
    QPalette dark(text, button, button.lighter(150), button.darker(), button.darker(150), text, text, base, window);
    dark.setColor(QPalette::PlaceholderText, QColor(0, 0, 0, 128));
    return dark;
}
} // namespace

void TestWindowDocks::hintsAreReadableOnADarkDesktop() {
    const QPalette palette = inspector::ui::completed(darkDesktop());
    QImage pixel(1, 1, QImage::Format_RGB32);
    pixel.fill(palette.color(QPalette::Window));
    QPainter(&pixel).fillRect(pixel.rect(), palette.color(QPalette::PlaceholderText));
    QVERIFY(support::contrastOf(pixel.pixelColor(0, 0), palette.color(QPalette::Window)) >= 4.0);
}

// In lists as well: part of an empty box differs from the base around it by a tenth of the scale.
void TestWindowDocks::emptyCheckBoxesAreSeen() {
    QFETCH(inspector::ui::Theme, theme);
    const auto restore = qScopeGuard([] { inspector::ui::applyTheme(inspector::ui::Theme::System); });
    inspector::ui::applyTheme(theme);
    QStyleOptionViewItem option;
    option.rect = QRect(0, 0, 20, 20);
    option.palette = theme == inspector::ui::Theme::System ? darkDesktop() : QApplication::palette();
    option.state = QStyle::State_Enabled | QStyle::State_Off;
    const QColor base = option.palette.color(QPalette::Base);
    QImage image(option.rect.size(), QImage::Format_RGB32);
    image.fill(base);
    QPainter painter(&image);
    QApplication::style()->drawPrimitive(QStyle::PE_IndicatorItemViewItemCheck, &option, &painter);
    painter.end();
    int farthest = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            farthest = std::max(farthest, std::abs(image.pixelColor(x, y).lightness() - base.lightness()));
    QVERIFY2(farthest >= 25, qPrintable(QString::number(farthest)));
}

void TestWindowDocks::qualityReachesTheView_data() {
    QTest::addColumn<int>("quality");
    QTest::newRow("Low") << 1;
    QTest::newRow("Medium") << 2;
    QTest::newRow("High") << 3;
}

void TestWindowDocks::qualityReachesTheView() {
    QFETCH(int, quality);
    m_fixture = std::make_unique<Fixture>(1, inspector::gl::Drawing::Solid);
    m_fixture->trigger(QStringLiteral("quality_%1").arg(quality));
    QCOMPARE(int(m_fixture->window().view().quality()), quality - 1);
}

void TestWindowDocks::qualityIsRemembered() {
    m_fixture->trigger("quality_3");
    inspector::ui::MainWindow other(m_fixture->session());
    QCOMPARE(int(other.view().quality()), 2);
}

void TestWindowDocks::viewChoosesTheQualityAgain() {
    m_fixture = std::make_unique<Fixture>(1, inspector::gl::Drawing::Solid);
    m_fixture->trigger("quality_3");
    m_fixture->trigger("quality_0");
    QVERIFY(!m_fixture->settings().contains("window/quality"));
    QCOMPARE(int(m_fixture->window().view().quality()), 1); // where it begins here
}

// Its frame included.
void TestWindowDocks::windowLargerThanTheScreenIsFitted() {
    const QSize screen = m_fixture->window().screen()->availableSize();
    m_fixture->window().resize(screen + QSize(100, 100));
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    QVERIFY(m_fixture->window().width() <= screen.width());
    QVERIFY(m_fixture->window().height() <= screen.height() - 10);
    QVERIFY(m_fixture->window().screen()->availableGeometry().contains(m_fixture->window().geometry()));
}

void TestWindowDocks::cameraLooksFromAboveAndBack() {
    const inspector::gl::OrbitCamera &camera = m_fixture->window().view().camera();
    const double before = support::elevationOf(camera);
    m_fixture->press(Qt::Key_T);
    COMPARE_WITHIN(support::elevationOf(camera), inspector::gl::OrbitCamera::kMaxElevation,
                   support::kElevationRounding);
    m_fixture->press(Qt::Key_Home);
    COMPARE_WITHIN(support::elevationOf(camera), before, support::kElevationRounding);
}

void TestWindowDocks::chosenSpeedReachesTheSimulation() {
    chooseIn("speed", 0);
    QCOMPARE(m_fixture->session().speed(), 1.0 / 16.0);
    QTRY_COMPARE(m_fixture->simulation().latest().statistics.speedAsked, 1.0 / 16.0);
}

void TestWindowDocks::anySpeedOfTheCommandLineIsInTheList() {
    QVERIFY(m_fixture->session().setSpeed(3.0));
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    const auto *speed = m_fixture->find<QComboBox>("speed");
    QCOMPARE(speed->currentText(), QString("3 ×"));
    QCOMPARE(speed->itemText(speed->currentIndex() + 1), QString("4 ×"));
    chooseIn("speed", 0);
    QCOMPARE(m_fixture->session().speed(), 1.0 / 16.0);
}

void TestWindowDocks::chosenTimeStepReachesTheSimulation() {
    chooseIn("time_step", 4);
    QTRY_COMPARE(m_fixture->simulation().latest().dt, 0.001);
}

void TestWindowDocks::typedTimeStepReachesTheSimulation_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("dt");
    QTest::newRow("a number is in s, as for --dt") << "0.003" << 0.003;
    QTest::newRow("ms") << "2.5 ms" << 0.0025;
    QTest::newRow("s") << "0.02 s" << 0.02;
    QTest::newRow("a fraction is in s") << "1/120" << 1.0 / 120.0;
    QTest::newRow("fraction and unit") << "1/60 s" << 1.0 / 60.0;
    QTest::newRow("no number: refused") << "fast" << 0.01;
    QTest::newRow("0: refused") << "0" << 0.01;
}

void TestWindowDocks::typedTimeStepReachesTheSimulation() {
    QFETCH(QString, text);
    QFETCH(double, dt);
    auto *edit = m_fixture->find<QComboBox>("time_step")->lineEdit();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
    QTRY_VERIFY(std::abs(m_fixture->simulation().latest().dt - dt) < 1e-15);
    QCOMPARE(m_fixture->game().phase(), inspector::Game::Phase::Prompt);
}

void TestWindowDocks::chosenStepperReachesTheSession() {
    const QByteArray first = m_fixture->find<QComboBox>("stepper")->itemData(0).toByteArray();
    chooseIn("stepper", 0);
    QCOMPARE(m_fixture->session().stepperId(), first);
}

void TestWindowDocks::statusSaysWhatTheSimulationDoes() {
    m_fixture->trigger("step");
    QTRY_VERIFY(m_fixture->find<QLabel>("status_time")->text().contains("0.010 s"));
    QVERIFY(m_fixture->find<QLabel>("status_speed")->text().contains("paused"));
    QVERIFY(m_fixture->find<QLabel>("status_ball")->text().contains("at rest"));
    QVERIFY(m_fixture->find<QLabel>("status_ghost")->isHidden());
}

void TestWindowDocks::statusWritesTheSpeedAsItsChooser() {
    chooseIn("speed", 0);
    const QString slowest = m_fixture->find<QComboBox>("speed")->currentText();
    QTRY_COMPARE(m_fixture->find<QLabel>("status_speed")->text(), QString("Speed: paused (%1)").arg(slowest));
}

void TestWindowDocks::statusHasNoSignBeforeZero() {
    m_fixture->parameters().set({{"tilt_x", -0.04}, {"tilt_y", -0.06}});
    m_fixture->trigger("step");
    QTRY_COMPARE(m_fixture->find<QLabel>("status_tilt")->text(), QString("Tilt: 0.0° -0.1°"));
}

void TestWindowDocks::aboutNamesVersionsAndLicences() {
    m_fixture->trigger("about");
    const QString text = m_fixture->find<QWidget>("about_dialog")->findChild<QLabel *>()->text();
    for (const char *part : {phys_version(), qVersion(), "GPL-3.0-or-later", "MIT", "LGPL-3.0", "QCustomPlot"})
        QVERIFY2(text.contains(part), part);
}

// Whatever a level is called, and however the run ended.
void TestWindowDocks::stripWidensNoWindow() {
    inspector::ui::GameStrip strip;
    inspector::ui::GameText text;
    text.title = QString(80, 'm');
    text.line = QString(80, 'm');
    text.hint = QString(80, 'm');
    text.isResult = true;
    strip.setText(text);
    QVERIFY2(strip.minimumSizeHint().width() < 300, qPrintable(QString::number(strip.minimumSizeHint().width())));
}

// Waits until there is something to see.
void TestWindowDocks::standingWindowDrawsNothing() {
    QTimer ticks;
    QSignalSpy tick(&ticks, &QTimer::timeout);
    ticks.start(16);
    uint64_t before = 0;
    const auto drawsNothingFor = [&](int count) {
        before = m_fixture->window().view().pictures();
        tick.clear();
        return QTest::qWaitFor([&] { return tick.count() >= count; }, kPatience) &&
               m_fixture->window().view().pictures() == before;
    };
    QTRY_VERIFY(drawsNothingFor(20)); // once the start is drawn
    m_fixture->trigger("step");
    QTRY_VERIFY(m_fixture->window().view().pictures() > before);
}

void TestWindowDocks::messageCanBeReadInEveryTheme_data() {
    QTest::addColumn<QString>("theme");
    for (const char *theme : {"theme_0", "theme_1", "theme_2"}) QTest::newRow(theme) << theme;
}

// WCAG 2.1, 1.4.3: the luminance of text and of its background differ by a factor of at least 4.5.
void TestWindowDocks::messageCanBeReadInEveryTheme() {
    QFETCH(QString, theme);
    m_fixture->trigger("theme_2");
    m_fixture->trigger(theme);
    const auto *text = m_fixture->find<QLabel>("message");
    const QColor front = text->palette().color(QPalette::WindowText);
    QVERIFY(support::contrastOf(front, m_fixture->window().messages().palette().color(QPalette::Window)) >= 4.5);
}

void TestWindowDocks::watchedValueIsThatOfTheMoment() {
    m_fixture->trigger("show_watch_dock");
    m_fixture->makeSteps(20);
    inspector::Sample sample;
    QVERIFY(m_fixture->simulation().samples().read(19, sample));
    const QTreeWidget *list = m_fixture->find<QTreeWidget>("watched");
    const QList<QTreeWidgetItem *> rows = list->findItems("Speed", Qt::MatchExactly);
    QCOMPARE(rows.size(), 1);
    m_fixture->window().refresh();
    QCOMPARE(rows[0]->text(1), QString::number(sample[inspector::Channel::Speed], 'g', 6));
    m_fixture->press(Qt::Key_Home, Qt::ControlModifier); // before the first step
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(0));
    m_fixture->window().refresh();
    QCOMPARE(rows[0]->text(1), QString("0"));
    QCOMPARE(list->findItems("Time a step takes", Qt::MatchExactly)[0]->text(1), QString("–"));
}

void TestWindowDocks::bouncesLieBesideThePlots() {
    m_fixture->press(Qt::Key_6, Qt::ControlModifier);
    QTRY_VERIFY(m_fixture->find<QWidget>("bounces")->isVisible());
    QVERIFY(!m_fixture->find<QWidget>("bounces")->visibleRegion().isEmpty());
    QVERIFY(!m_fixture->find<QWidget>("velocity_plot")->visibleRegion().isEmpty());
}

QTEST_MAIN(TestWindowDocks)
#include "tst_window_docks.moc"
