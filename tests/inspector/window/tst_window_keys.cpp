// SPDX-License-Identifier: MIT
// Keys have the effects that Help > Keys lists, wherever the focus is.
#include "gl/view/maze_view.h"
#include "ui/parameters/slider_scale.h"
#include "ui/parts/number_box.h"
#include "window_fixture.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>

using namespace window_test;
using inspector::Game;
using inspector::ui::NumberBox;

class TestWindowKeys : public WindowSuite {
    Q_OBJECT

private slots:
    void enterStartsTheGame();
    void enterStartsTheGameFromAList_data();
    void enterStartsTheGameFromAList();
    void floatingDockLeavesTheGameItsKeys();
    void closedDockReturnsTheKeyboard_data();
    void closedDockReturnsTheKeyboard();
    void dockThatIsOpenedTakesWhatIsTyped_data();
    void dockThatIsOpenedTakesWhatIsTyped();
    void arrowTiltsTheBoardTowardsItself_data();
    void arrowTiltsTheBoardTowardsItself();
    void releasedArrowLevelsTheBoard();
    void tiltOfTheKeysIsShownInTenths();
    void arrowsAreTheGamesEvenIfASliderHasTheFocus();
    void arrowsAreTheSlidersBeforeTheGame();
    void spaceRunsAndPauses();
    void spaceRunsAfterADockWasOpened();
    void spaceTypedAfterAClickOnASwitchStillPauses();
    void spacePressesTheFocusedButtonBeforeTheGame();
    void escapePauses();
    void periodMakesOneStep();
    void rPutsTheBallBack();
    void aTogglesTheAutopilot();
    void enterInANumberIsNotTheGames();
    void lettersInANumberAreNotCommands();
    void ballRollsWhereTheArrowsPoint();
    void tabLeavesOutDocksBehindOthers();
    void f6GoesFromTheBoardToTheDocksAndBack();
    void everyFocusIsSeen_data();
    void everyFocusIsSeen();
    void everyShortcutIsListed();
    void noShortcutIsThereTwice();
    void keysCanBeSearched();

private:
    phys_state ball() { return m_fixture->simulation().latest().current; }
    bool isRunning() { return m_fixture->simulation().latest().running; }
    void startGame();
};

void TestWindowKeys::startGame() {
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(isRunning());
}

void TestWindowKeys::enterStartsTheGame() {
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Prompt);
    startGame();
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Playing);
    QTRY_VERIFY(ball().step > 0);
}

void TestWindowKeys::enterStartsTheGameFromAList_data() {
    QTest::addColumn<QString>("dock");
    QTest::addColumn<QString>("list");
    QTest::newRow("levels") << "levels_dock"
                            << "levels";
    QTest::newRow("bounces") << "bounces_dock"
                             << "bounces_table";
    QTest::newRow("watch") << "watch_dock"
                           << "watched";
    QTest::newRow("trade") << "trade_dock"
                           << "trade_table";
    QTest::newRow("runs, of which there is none yet") << "runs_dock"
                                                      << "runs";
}

// As the line above the board says; then the view has the keyboard.
void TestWindowKeys::enterStartsTheGameFromAList() {
    QFETCH(QString, dock);
    QFETCH(QString, list);
    if (!m_fixture->find<QDockWidget>(dock)->isVisible()) m_fixture->trigger("show_" + dock);
    m_fixture->find<QWidget>(list)->setFocus(Qt::TabFocusReason);
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(isRunning());
    QTRY_VERIFY(m_fixture->window().view().hasFocus());
}

void TestWindowKeys::floatingDockLeavesTheGameItsKeys() {
    m_fixture->trigger("show_trade_dock");
    auto *dock = m_fixture->find<QDockWidget>("trade_dock");
    dock->setFloating(true);
    dock->activateWindow();
    QTRY_COMPARE(QApplication::activeWindow(), dock);
    auto *table = m_fixture->find<QWidget>("trade_table");
    table->setFocus();
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(isRunning());
    QTest::keyPress(table, Qt::Key_Up);
    QTRY_VERIFY(m_fixture->simulated("tilt_y") > 1.0);
    QTest::keyRelease(table, Qt::Key_Up);
    QTRY_COMPARE(m_fixture->simulated("tilt_y"), 0.0);
}

void TestWindowKeys::closedDockReturnsTheKeyboard_data() {
    QTest::addColumn<QString>("dock");
    QTest::addColumn<Qt::Key>("key"); // none: its button
    QTest::newRow("levels by the key") << "levels_dock" << Qt::Key_2;
    QTest::newRow("trade by the key") << "trade_dock" << Qt::Key_4;
    QTest::newRow("levels by the button") << "levels_dock" << Qt::Key_unknown;
}

// Not to what happens to be next, here the watched quantities.
void TestWindowKeys::closedDockReturnsTheKeyboard() {
    QFETCH(QString, dock);
    QFETCH(Qt::Key, key);
    auto *closed = m_fixture->find<QDockWidget>(dock);
    m_fixture->trigger("show_watch_dock");
    if (!closed->isVisible()) m_fixture->trigger("show_" + dock);
    closed->widget()->setFocus();
    QVERIFY(closed->isAncestorOf(QApplication::focusWidget()));
    if (key == Qt::Key_unknown)
        click(closed->findChild<QWidget *>("qt_dockwidget_closebutton"));
    else
        m_fixture->key(key, Qt::ControlModifier);
    QTRY_VERIFY(closed->isHidden());
    QCOMPARE(QApplication::focusWidget(), &m_fixture->window().view());
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(isRunning());
}

void TestWindowKeys::dockThatIsOpenedTakesWhatIsTyped_data() {
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<QString>("box");
    QTest::newRow("measured ball") << Qt::Key_7 << "track_file";
    QTest::newRow("ball") << Qt::Key_0 << "ball_x";
}

void TestWindowKeys::dockThatIsOpenedTakesWhatIsTyped() {
    QFETCH(Qt::Key, key);
    QFETCH(QString, box);
    m_fixture->key(key, Qt::ControlModifier);
    m_fixture->type("a.csv");
    QCOMPARE(m_fixture->find<QLineEdit>(box)->text(), QString("a.csv")); // in place of what was there
    QVERIFY(!m_fixture->session().hasAutopilot() && !m_fixture->session().comparison().isOn());
    QCOMPARE(ball().step, 0u);
}

void TestWindowKeys::arrowTiltsTheBoardTowardsItself_data() {
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<QString>("id");
    QTest::addColumn<double>("tilt");
    QTest::newRow("right") << Qt::Key_Right << "tilt_x" << inspector::kPlayTilt;
    QTest::newRow("left") << Qt::Key_Left << "tilt_x" << -inspector::kPlayTilt;
    QTest::newRow("up") << Qt::Key_Up << "tilt_y" << inspector::kPlayTilt;
    QTest::newRow("down") << Qt::Key_Down << "tilt_y" << -inspector::kPlayTilt;
}

void TestWindowKeys::arrowTiltsTheBoardTowardsItself() {
    QFETCH(Qt::Key, key);
    QFETCH(QString, id);
    QFETCH(double, tilt);
    startGame();
    QTest::keyPress(&m_fixture->window(), key);
    // The tilt approaches the limit without end; half of it is on the way.
    QTRY_VERIFY(m_fixture->simulated(id) / tilt > 0.5);
    QTest::keyRelease(&m_fixture->window(), key);
}

void TestWindowKeys::releasedArrowLevelsTheBoard() {
    startGame();
    QTest::keyPress(&m_fixture->window(), Qt::Key_Up);
    QTRY_VERIFY(m_fixture->simulated("tilt_y") > 1.0);
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Up);
    QTRY_COMPARE(m_fixture->simulated("tilt_y"), 0.0);
}

// On its way the tilt passes through numbers of any length.
void TestWindowKeys::tiltOfTheKeysIsShownInTenths() {
    startGame();
    auto *box = m_fixture->find<NumberBox>("tilt_y_box");
    QTest::keyPress(&m_fixture->window(), Qt::Key_Up);
    for (int i = 0; i < 20; ++i) {
        const double before = box->value();
        QTRY_VERIFY(box->value() != before || m_fixture->simulated("tilt_y") > 7.9);
        QVERIFY2(box->text().length() == 5, qPrintable(box->text())); // 7.1 and the unit
    }
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Up);
}

void TestWindowKeys::arrowsAreTheGamesEvenIfASliderHasTheFocus() {
    startGame();
    auto *slider = m_fixture->find<QSlider>("gravity_slider");
    slider->setFocus();
    const int before = slider->value();
    QTest::keyPress(slider, Qt::Key_Right);
    QTRY_VERIFY(m_fixture->simulated("tilt_x") > 1.0);
    QTest::keyRelease(slider, Qt::Key_Right);
    QCOMPARE(slider->value(), before);
}

void TestWindowKeys::arrowsAreTheSlidersBeforeTheGame() {
    auto *slider = m_fixture->find<QSlider>("gravity_slider");
    slider->setFocus();
    const int before = slider->value();
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(slider->value(), before + inspector::ui::SliderScale::kFine);
}

void TestWindowKeys::spaceRunsAndPauses() {
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(isRunning());
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(!isRunning());
}

// Its first control has the keyboard, but nobody chose to press it.
void TestWindowKeys::spaceRunsAfterADockWasOpened() {
    m_fixture->key(Qt::Key_5, Qt::ControlModifier);
    QTRY_COMPARE(QApplication::focusWidget(), m_fixture->find<QWidget>("comparison_compare"));
    m_fixture->key(Qt::Key_Space);
    QTRY_VERIFY(isRunning());
    m_fixture->find<QAction>("run")->setEnabled(false);
    m_fixture->key(Qt::Key_Space);
    QVERIFY(!m_fixture->session().comparison().isOn());
}

void TestWindowKeys::spaceTypedAfterAClickOnASwitchStillPauses() {
    startGame();
    click(m_fixture->find<QWidget>("plot_pause"));
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(!isRunning());
}

// Without a mouse, one tabs to a button and presses it.
void TestWindowKeys::spacePressesTheFocusedButtonBeforeTheGame() {
    m_fixture->parameters().set({{QStringLiteral("gravity"), 3.0}});
    auto *button = m_fixture->find<QPushButton>("reset_all");
    button->setFocus(Qt::TabFocusReason);
    QTest::keyClick(button, Qt::Key_Space);
    QTRY_COMPARE(m_fixture->simulated("gravity"), 9.81);
    QVERIFY(!isRunning());
    startGame();
    QTest::keyClick(button, Qt::Key_Space);
    QTRY_VERIFY(!isRunning()); // while playing it pauses
}

void TestWindowKeys::escapePauses() {
    startGame();
    m_fixture->press(Qt::Key_Escape);
    QTRY_VERIFY(!isRunning());
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Playing);
}

void TestWindowKeys::periodMakesOneStep() {
    m_fixture->press(Qt::Key_Period);
    QTRY_COMPARE(ball().step, 1u);
    m_fixture->press(Qt::Key_Period);
    QTRY_COMPARE(ball().step, 2u);
    QVERIFY(!isRunning());
}

void TestWindowKeys::rPutsTheBallBack() {
    m_fixture->press(Qt::Key_Period);
    QTRY_COMPARE(ball().step, 1u);
    m_fixture->press(Qt::Key_R);
    QTRY_COMPARE(ball().step, 0u);
}

void TestWindowKeys::aTogglesTheAutopilot() {
    m_fixture->press(Qt::Key_A);
    QVERIFY(m_fixture->session().hasAutopilot());
    QVERIFY(m_fixture->find<QAction>("autopilot")->isChecked());
    m_fixture->press(Qt::Key_A);
    QVERIFY(!m_fixture->session().hasAutopilot());
    QVERIFY(!m_fixture->find<QAction>("autopilot")->isChecked());
}

void TestWindowKeys::enterInANumberIsNotTheGames() {
    auto *box = m_fixture->find<NumberBox>("gravity_box");
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Prompt);
}

void TestWindowKeys::lettersInANumberAreNotCommands() {
    auto *box = m_fixture->find<NumberBox>("gravity_box");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, "3.5");
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(box->value(), 3.5);
    QCOMPARE(ball().step, 0u); // the point was no single step
}

// The start of level 1 is open to the back.
void TestWindowKeys::ballRollsWhereTheArrowsPoint() {
    startGame();
    const double start = ball().position.y;
    QTest::keyPress(&m_fixture->window(), Qt::Key_Up);
    QTRY_VERIFY(ball().position.y > start + 0.01);
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Up);
}

void TestWindowKeys::tabLeavesOutDocksBehindOthers() {
    const auto isBehind = [](const QWidget *widget) {
        while (widget && !qobject_cast<const QDockWidget *>(widget)) widget = widget->parentWidget();
        return widget && widget->visibleRegion().isEmpty();
    };
    for (const Qt::Key key : {Qt::Key_4, Qt::Key_7, Qt::Key_8, Qt::Key_5}) m_fixture->press(key, Qt::ControlModifier);
    QTRY_VERIFY(!m_fixture->find<QWidget>("comparison_dock")->visibleRegion().isEmpty());
    for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
        m_fixture->find<QWidget>("view")->setFocus();
        QList<const QWidget *> seen;
        do {
            m_fixture->key(key);
            const QWidget *focus = QApplication::focusWidget();
            QVERIFY2(focus && !isBehind(focus), qPrintable(focus ? focus->objectName() : QString()));
            seen += focus;
        } while (!m_fixture->find<QWidget>("view")->hasFocus() && seen.size() < 200);
        QVERIFY(m_fixture->find<QWidget>("view")->hasFocus());
        QVERIFY(seen.size() > 10);
    }
}

void TestWindowKeys::f6GoesFromTheBoardToTheDocksAndBack() {
    m_fixture->find<QDockWidget>("levels_dock")->setFloating(true);
    m_fixture->trigger("show_watch_dock");
    QApplication::processEvents();
    auto *view = m_fixture->find<QWidget>("view");
    view->activateWindow();
    QTRY_COMPARE(QApplication::activeWindow(), &m_fixture->window());
    view->setFocus();
    const auto part = [] {
        const QWidget *widget = QApplication::focusWidget();
        while (widget && !qobject_cast<const QDockWidget *>(widget) && widget->objectName() != "view")
            widget = widget->parentWidget();
        return widget ? widget->objectName() : QString();
    };
    const QStringList order{"parameters_dock", "levels_dock", "plot_dock", "watch_dock", "view"};
    for (const QString &name : order) {
        m_fixture->key(Qt::Key_F6);
        QTRY_COMPARE(part(), name);
    }
    for (qsizetype i = order.size() - 1; i-- > 0;) {
        m_fixture->key(Qt::Key_F6, Qt::ShiftModifier);
        QTRY_COMPARE(part(), order[i]);
    }
}

void TestWindowKeys::everyFocusIsSeen_data() {
    QTest::addColumn<QString>("theme");
    QTest::newRow("light") << "theme_1";
    QTest::newRow("dark") << "theme_2";
}

// A control with the keyboard looks different from one without.
void TestWindowKeys::everyFocusIsSeen() {
    QFETCH(QString, theme);
    m_fixture->trigger(theme);
    m_fixture->window().resize(1270, 1000);
    m_fixture->key(Qt::Key_F6);
    QStringList unseen;
    int count = 0;
    for (QDockWidget *dock : m_fixture->window().findChildren<QDockWidget *>()) {
        if (dock->visibleRegion().isEmpty()) m_fixture->trigger("show_" + dock->objectName());
        QApplication::processEvents();
        for (QWidget *control : dock->findChildren<QWidget *>()) {
            const bool takesTab = control->isEnabled() && (control->focusPolicy() & Qt::TabFocus);
            if (!takesTab || control->focusProxy() || control->visibleRegion().isEmpty()) continue;
            const auto *table = qobject_cast<QAbstractItemView *>(control);
            if (table && table->model()->rowCount() == 0) continue; // no row to mark
            m_fixture->find<QWidget>("view")->setFocus();
            const QImage without = control->grab().toImage();
            control->setFocus(Qt::TabFocusReason);
            if (!control->hasFocus()) continue;
            ++count;
            if (control->grab().toImage() == without)
                unseen += QString("%1 %2 in %3")
                              .arg(control->metaObject()->className(), control->objectName(), dock->objectName());
        }
    }
    m_fixture->trigger("theme_1");
    QVERIFY(count > 50);
    QCOMPARE(unseen.join(", "), QString());
}

void TestWindowKeys::everyShortcutIsListed() {
    m_fixture->press(Qt::Key_F1);
    const QString text = m_fixture->find<QWidget>("keys_dialog")->findChild<QLabel *>()->text();
    int count = 0;
    for (const QAction *action : m_fixture->window().findChildren<QAction *>()) {
        if (action->shortcut().isEmpty()) continue;
        const QString keys = action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped();
        QVERIFY2(text.contains("<b>" + keys + "</b>"), qPrintable(action->text() + " " + keys));
        ++count;
    }
    QVERIFY(count > 10);
}

void TestWindowKeys::keysCanBeSearched() {
    m_fixture->press(Qt::Key_F1);
    auto *sought = m_fixture->find<QLineEdit>("keys_sought");
    sought->window()->activateWindow(); // as window managers do
    QTRY_COMPARE(QApplication::activeWindow(), sought->window());
    m_fixture->type("autopilot"); // the keyboard is there immediately
    const QString text = m_fixture->find<QWidget>("keys_dialog")->findChild<QLabel *>()->text();
    QCOMPARE(text.count("<tr>"), 1);
    QVERIFY(text.contains("<b>A</b>"));
    QVERIFY(sought->window()->height() <= sought->screen()->availableSize().height());
}

void TestWindowKeys::noShortcutIsThereTwice() {
    QSet<QString> seen;
    for (const QAction *action : m_fixture->window().findChildren<QAction *>()) {
        for (const QKeySequence &keys : action->shortcuts()) {
            if (keys.isEmpty()) continue;
            QVERIFY2(!seen.contains(keys.toString()), qPrintable(keys.toString()));
            seen.insert(keys.toString());
        }
    }
}

QTEST_MAIN(TestWindowKeys)
#include "tst_window_keys.moc"
