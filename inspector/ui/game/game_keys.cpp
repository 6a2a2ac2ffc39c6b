// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/game/game_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

#include <algorithm>

namespace inspector::ui {

namespace {

constexpr int kPulse = 16;           // ms
constexpr double kLongestTurn = 0.1; // s: after a stall the board doesn't jump

bool isArrow(int key) { return key >= Qt::Key_Left && key <= Qt::Key_Down; }
bool isEnter(int key) { return key == Qt::Key_Return || key == Qt::Key_Enter; }

bool isText(const QWidget *widget) {
    return qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget);
}

} // namespace

GameKeys::GameKeys(Session &session, QWidget &window, QWidget &view)
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

bool GameKeys::isForGame(const QKeyEvent &event) const {
    if (!isArrow(event.key()) || (event.modifiers() & ~Qt::KeypadModifier)) return false;
    if (m_session.isReplaying()) return false;
    if (QApplication::activeWindow() != &m_window || QApplication::activePopupWidget()) return false;
    const QWidget *focus = QApplication::focusWidget();
    const bool isList = qobject_cast<const QAbstractItemView *>(focus);
    if (isList && (m_session.hasAutopilot() || !m_session.simulation().latest().running)) return false;
    return m_session.game().phase() == Game::Phase::Playing || !focus || focus == &m_view || focus == &m_window;
}

// Keys that a widget needs although the window has a command for them.
bool GameKeys::isForWidget(const QKeyEvent &event, const QWidget *widget) const {
    if (isEnter(event.key())) return isText(widget);
    const bool isPressed = qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QComboBox *>(widget);
    return event.key() == Qt::Key_Space && isPressed && m_session.game().phase() != Game::Phase::Playing;
}

bool GameKeys::eventFilter(QObject *object, QEvent *event) {
    const QEvent::Type type = event->type();
    if (type != QEvent::KeyPress && type != QEvent::KeyRelease && type != QEvent::ShortcutOverride) return false;
    auto *key = static_cast<QKeyEvent *>(event);
    if (type == QEvent::ShortcutOverride) {
        if (!isForWidget(*key, qobject_cast<QWidget *>(object))) return false;
        event->accept();
        return true;
    }
    // A key that went down as the game's also comes up as the game's, or the board would stay tilted.
    const bool isRelease = type == QEvent::KeyRelease;
    if (!isForGame(*key) && !(isRelease && isArrow(key->key()) && m_keys.any())) return false;
    if (!key->isAutoRepeat()) hold(key->key(), !isRelease);
    event->accept();
    return true;
}

void GameKeys::hold(int key, bool isDown) {
    bool *const keys[] = {&m_keys.left, &m_keys.up, &m_keys.right, &m_keys.down}; // Qt's order
    *keys[key - Qt::Key_Left] = isDown;
    m_session.setKeys(m_keys);
}

void GameKeys::releaseAll() {
    m_keys = {};
    m_session.setKeys(m_keys);
}

void GameKeys::advance() {
    const double seconds = 1e-9 * double(m_clock.nsecsElapsed());
    m_clock.restart();
    m_session.advanceKeys(std::min(seconds, kLongestTurn));
}

} // namespace inspector::ui
