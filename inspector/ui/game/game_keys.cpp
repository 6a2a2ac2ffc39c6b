// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/game/game_keys.h"

#include "gl/view/maze_view.h"
#include "ui/parts/theme.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>

#include <algorithm>

namespace inspector::ui {

namespace {

constexpr int kPulse = 16;           ///< ms
constexpr double kLongestTurn = 0.1; ///< s, so that the board doesn't jump after a stall

bool isArrow(int key) { return key >= Qt::Key_Left && key <= Qt::Key_Down; }
bool isEnter(int key) { return key == Qt::Key_Return || key == Qt::Key_Enter; }

/// Whether the widget accepts text, or is an open list of choices.
bool isText(const QWidget *widget) {
    const auto *combo = qobject_cast<const QComboBox *>(widget);
    return qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget) ||
           (combo && combo->isEditable()) || QApplication::activePopupWidget();
}

bool isPressedBySpace(const QWidget *widget) {
    return qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QComboBox *>(widget);
}

bool isTable(const QWidget *widget) { return qobject_cast<const QAbstractItemView *>(widget); }

bool isList(const QWidget *widget) { return isTable(widget) || qobject_cast<const QComboBox *>(widget); }

bool isInDialog(const QWidget *widget) {
    for (; widget; widget = widget->parentWidget())
        if (qobject_cast<const QDialog *>(widget)) return true;
    return false;
}

/// Whether the text is marked as invalid, so that editing must continue.
bool isUnreadable(const QWidget *widget) {
    const auto *combo = qobject_cast<const QComboBox *>(widget);
    const QWidget *field = combo ? combo->lineEdit() : widget;
    return field && AlarmText::isOn(*field);
}

} // namespace

GameKeys::GameKeys(Session &session, QWidget &window, gl::MazeView &view)
    : QObject(&window)
    , m_session(session)
    , m_window(window)
    , m_view(view) {
    qApp->installEventFilter(this);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, &GameKeys::releaseAll);
    connect(&m_pulse, &QTimer::timeout, this, &GameKeys::advance);
    m_pulse.setTimerType(Qt::PreciseTimer);
    m_pulse.start(kPulse);
    m_clock.start();
}

/// The main window, or a dock that floats.
bool GameKeys::hasKeyboard() const {
    const QWidget *active = QApplication::activeWindow();
    return active == &m_window || (qobject_cast<const QDockWidget *>(active) && active->parentWidget() == &m_window);
}

bool GameKeys::isForGame(const QKeyEvent &event) const {
    if (!isArrow(event.key()) || (event.modifiers() & ~Qt::KeypadModifier)) return false;
    if (m_session.isReplaying()) return false;
    if (!hasKeyboard() || QApplication::activePopupWidget()) return false;
    const QWidget *focus = QApplication::focusWidget();
    if (isTable(focus) && (m_session.hasAutopilot() || !m_session.simulation().latest().running)) return false;
    return m_session.game().phase() == Game::Phase::Playing || !focus || focus == &m_view || focus == &m_window;
}

/// Keys that a widget needs although the window has a command for them.
bool GameKeys::isForWidget(const QKeyEvent &event, const QWidget *widget) const {
    if (isEnter(event.key())) return isText(widget) || qobject_cast<const QComboBox *>(widget);
    if (event.key() == Qt::Key_Escape) return isText(widget);
    const bool isPlaying = m_session.game().phase() == Game::Phase::Playing;
    return event.key() == Qt::Key_Space && isPressedBySpace(widget) && m_isControlChosen && !isPlaying;
}

/// The first control of a dock that was opened by its key has the keyboard, but nobody chose to press it.
void GameKeys::noticeFocus(Qt::FocusReason reason) {
    const bool isReturn = reason == Qt::ActiveWindowFocusReason || reason == Qt::PopupFocusReason;
    if (!isReturn) m_isControlChosen = reason != Qt::ShortcutFocusReason;
}

bool GameKeys::eventFilter(QObject *object, QEvent *event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::FocusIn) noticeFocus(static_cast<const QFocusEvent *>(event)->reason());
    if (type != QEvent::KeyPress && type != QEvent::KeyRelease && type != QEvent::ShortcutOverride) return false;
    const auto *key = static_cast<const QKeyEvent *>(event);
    const auto *widget = qobject_cast<const QWidget *>(object);
    if (type == QEvent::ShortcutOverride) {
        if (isEnter(key->key()) && isTable(widget) && !isInDialog(widget)) returnKeyboardAfter(widget);
        if (!isForWidget(*key, widget)) return false;
        event->accept();
        if (!QApplication::activePopupWidget()) return true;
        if (isEnter(key->key())) returnKeyboardAfter(widget);
        return false; // an open list needs the key
    }
    // The command for it may be disabled.
    if (key->key() == Qt::Key_Space && isPressedBySpace(widget) && !m_isControlChosen) return true;
    if (takeArrow(*key)) {
        event->accept();
        return true;
    }
    const bool isEnd = isEnter(key->key()) || (key->key() == Qt::Key_Escape && isText(widget));
    if (type == QEvent::KeyPress && isEnd && (isText(widget) || isList(widget)) && !isInDialog(widget))
        returnKeyboardAfter(widget);
    return false;
}

/// If the game received a key's press, it must also receive its release, or the board would stay tilted.
bool GameKeys::takeArrow(const QKeyEvent &event) {
    if (!isArrow(event.key())) return false;
    unsigned &held = m_held[size_t(event.key() - Qt::Key_Left)];
    const unsigned bit = event.modifiers() & Qt::KeypadModifier ? 2U : 1U;
    const bool isRelease = event.type() == QEvent::KeyRelease;
    if (!isForGame(event) && !(isRelease && (held & bit))) return false;
    if (event.isAutoRepeat()) return true;
    held = isRelease ? held & ~bit : held | bit;
    sendKeys();
    return true;
}

/// Called after the widget has handled the key: a table ends an edit a little later, and an edit that has lost the
/// keyboard by then would end twice.
void GameKeys::returnKeyboardAfter(const QWidget *editor) {
    const auto returnKeyboard = [this, editor] {
        const QWidget *focus = QApplication::focusWidget();
        if (QApplication::activePopupWidget() || QApplication::activeWindow() != &m_window) return;
        const bool isLeft = focus && focus != editor && !isText(focus) && !isList(focus);
        if (!isLeft && !isUnreadable(focus)) m_view.setFocus();
    };
    const auto later = [this](auto call) { QMetaObject::invokeMethod(this, call, Qt::QueuedConnection); };
    later([later, returnKeyboard] { later(returnKeyboard); });
}

/// At azimuth -90 degrees, the camera's initial one, up on the screen is +y of the board.
void GameKeys::sendKeys() {
    TiltKeys keys{m_held[0] != 0, m_held[2] != 0, m_held[1] != 0, m_held[3] != 0, 0.0};
    keys.heading = gl::OrbitCamera::kStartAzimuth - m_view.camera().azimuth();
    m_session.setKeys(keys);
}

void GameKeys::releaseAll() {
    m_held = {};
    sendKeys();
}

void GameKeys::advance() {
    const double seconds = 1e-9 * double(m_clock.nsecsElapsed());
    m_clock.restart();
    if (!hasKeyboard()) m_held = {}; // releases go to another window
    sendKeys();                      // the camera may have moved
    m_session.advanceKeys(std::min(seconds, kLongestTurn));
}

} // namespace inspector::ui
