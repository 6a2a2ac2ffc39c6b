// SPDX-License-Identifier: MIT
// Random keys, clicks, drags, wheels and texts, all over the window and its dialogs: whatever happens, the program
// continues and the ball has a position. Longer: MONKEY_ACTIONS=5000 MONKEY_SEED=2
// build/dev/tests/inspector/window/window_suites tst_window_monkey (under xvfb-run)
#include "gl/view/maze_view.h"
#include "window_fixture.h"

#include <QAbstractButton>
#include <QDialog>
#include <QDockWidget>
#include <QDrag>
#include <QMenu>
#include <QTimer>

#include <cmath>
#include <random>

using namespace window_test;

namespace {

constexpr int kActions = 300;
constexpr unsigned kSeed = 1;

unsigned numberOf(const char *variable, unsigned usual) {
    bool isNumber = false;
    const unsigned number = qEnvironmentVariable(variable).toUInt(&isNumber);
    return isNumber ? number : usual;
}

struct KeyStroke {
    Qt::Key key;
    Qt::KeyboardModifiers modifiers;
};

// All keys of the window except those that quit.
const KeyStroke kStrokes[] = {
    {Qt::Key_Return, {}},
    {Qt::Key_Escape, {}},
    {Qt::Key_Space, {}},
    {Qt::Key_Tab, {}},
    {Qt::Key_Left, {}},
    {Qt::Key_Right, {}},
    {Qt::Key_Up, {}},
    {Qt::Key_Down, {}},
    {Qt::Key_Home, {}},
    {Qt::Key_End, {}},
    {Qt::Key_PageUp, {}},
    {Qt::Key_Comma, {}},
    {Qt::Key_Period, {}},
    {Qt::Key_A, {}},
    {Qt::Key_B, {}},
    {Qt::Key_C, {}},
    {Qt::Key_G, {}},
    {Qt::Key_M, {}},
    {Qt::Key_R, {}},
    {Qt::Key_F, {}},
    {Qt::Key_T, {}},
    {Qt::Key_U, {}},
    {Qt::Key_W, {}},
    {Qt::Key_X, {}},
    {Qt::Key_C, Qt::ShiftModifier},
    {Qt::Key_X, Qt::ShiftModifier},
    {Qt::Key_F1, {}},
    {Qt::Key_F1, Qt::ShiftModifier},
    {Qt::Key_Left, Qt::ControlModifier},
    {Qt::Key_Right, Qt::ControlModifier},
    {Qt::Key_Home, Qt::ControlModifier},
    {Qt::Key_End, Qt::ControlModifier},
    {Qt::Key_R, Qt::ControlModifier},
    {Qt::Key_S, Qt::ControlModifier},
    {Qt::Key_Z, Qt::ControlModifier},
    {Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier},
    {Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier},
    {Qt::Key_0, Qt::ControlModifier},
    {Qt::Key_1, Qt::ControlModifier},
    {Qt::Key_2, Qt::ControlModifier},
    {Qt::Key_3, Qt::ControlModifier},
    {Qt::Key_4, Qt::ControlModifier},
    {Qt::Key_5, Qt::ControlModifier},
    {Qt::Key_6, Qt::ControlModifier},
    {Qt::Key_7, Qt::ControlModifier},
    {Qt::Key_8, Qt::ControlModifier},
    {Qt::Key_9, Qt::ControlModifier},
};

const char *const kTexts[] = {"1e-3", "0,9", "-5", "1/60", "fast", "1e400", "nan", "", "3 mm", "99999999", "0"};

} // namespace

class TestWindowMonkey : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void randomHandsBreakNothing();

private:
    int any(int count) { return int(m_random() % unsigned(count)); }
    QWidget *anyWidget();
    void act();
    void pressKey();
    void clickSomewhere(Qt::MouseButton button);
    void typeText();
    void closeDialogs();
    void chooseFromMenu();
    void leaveInnerLoops();

    std::mt19937 m_random;
};

// A random target: the window, or the dialog in front of it.
QWidget *TestWindowMonkey::anyWidget() {
    QWidget *top = QApplication::activeModalWidget();
    if (!top) top = &m_fixture->window();
    QList<QWidget *> reachable;
    for (QWidget *widget : top->findChildren<QWidget *>())
        if (widget->isVisible() && widget->isEnabled() && !widget->visibleRegion().isEmpty() && !widget->isWindow())
            reachable.append(widget);
    return reachable.isEmpty() ? top : reachable[any(int(reachable.size()))];
}

void TestWindowMonkey::pressKey() {
    const KeyStroke stroke = kStrokes[any(int(std::size(kStrokes)))];
    m_fixture->key(stroke.key, stroke.modifiers);
}

void TestWindowMonkey::clickSomewhere(Qt::MouseButton button) {
    QWidget *widget = anyWidget();
    const QPoint place(any(std::max(1, widget->width())), any(std::max(1, widget->height())));
    const QPoint other(any(std::max(1, widget->width())), any(std::max(1, widget->height())));
    const Qt::KeyboardModifiers modifiers = any(4) == 0 ? Qt::ControlModifier : Qt::NoModifier;
    switch (any(5)) {
    case 0:
        drag(widget, place, other, modifiers);
        break;
    case 1:
        turnWheel(widget, place, any(7) - 3, modifiers);
        break;
    case 2:
        QTest::mouseDClick(widget, button, modifiers, place);
        break;
    default:
        QTest::mouseClick(widget, button, modifiers, place);
        break;
    }
    if (button == Qt::RightButton) {
        QContextMenuEvent asked(QContextMenuEvent::Mouse, place, widget->mapToGlobal(place));
        QApplication::sendEvent(widget, &asked);
    }
}

void TestWindowMonkey::typeText() {
    m_fixture->type(QLatin1String(kTexts[any(int(std::size(kTexts)))]));
    if (any(2) == 0) m_fixture->key(Qt::Key_Return);
}

// File dialogs are closed; other dialogs may stay for a while.
void TestWindowMonkey::closeDialogs() {
    for (auto *dialog : m_fixture->window().findChildren<QDialog *>())
        if (dialog->isModal() || any(4) == 0) dialog->close();
}

// Closes what would leave the window.
void TestWindowMonkey::chooseFromMenu() {
    auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
    if (!menu) return;
    const QList<QAction *> actions = menu->actions();
    QAction *chosen = actions.isEmpty() ? nullptr : actions[any(int(actions.size()))];
    menu->close();
    if (chosen && chosen->isEnabled() && chosen->objectName() != "quit") chosen->trigger();
}

// A menu, a dialog or a drag may wait for an answer in an event loop of its own, which blocks this test: a drag ends
// only when the screen's own mouse button is released.
void TestWindowMonkey::leaveInnerLoops() {
    QDrag::cancel();
    if (QApplication::activePopupWidget())
        chooseFromMenu();
    else if (QWidget *dialog = QApplication::activeModalWidget())
        dialog->close();
}

void TestWindowMonkey::act() {
    if (QApplication::activePopupWidget() && any(3) == 0) chooseFromMenu();
    switch (any(8)) {
    case 0:
        clickSomewhere(Qt::RightButton);
        break;
    case 1:
    case 2:
    case 3:
        clickSomewhere(Qt::LeftButton);
        break;
    case 4:
        typeText();
        break;
    default:
        pressKey();
        break;
    }
    if (any(3) == 0) closeDialogs();
    if (!m_fixture->window().isVisible()) m_fixture->window().show(); // its frame was hit
    QApplication::processEvents();
}

void TestWindowMonkey::init() { QVERIFY(open(1, inspector::gl::Drawing::Solid)); }

void TestWindowMonkey::randomHandsBreakNothing() {
    const unsigned seed = numberOf("MONKEY_SEED", kSeed);
    const unsigned actions = numberOf("MONKEY_ACTIONS", kActions);
    qInfo("seed %u, %u actions", seed, actions);
    m_random.seed(seed);
    QTimer answers;
    connect(&answers, &QTimer::timeout, this, &TestWindowMonkey::leaveInnerLoops);
    answers.start(20);
    for (unsigned i = 0; i < actions; ++i) {
        act();
        const phys_state ball = m_fixture->simulation().latest().current;
        QVERIFY2(std::isfinite(ball.position.x + ball.position.y + ball.position.z), qPrintable(QString::number(i)));
    }
    while (QWidget *popup = QApplication::activePopupWidget()) popup->close();
    m_fixture.reset();
}

QTEST_MAIN(TestWindowMonkey)
#include "tst_window_monkey.moc"
