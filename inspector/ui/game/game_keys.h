// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <array>

class QKeyEvent;
class QWidget;

namespace inspector::gl {
class MazeView;
} // namespace inspector::gl

namespace inspector::ui {

/// Routes keys to the game. While a level is played, arrow keys tilt the board whatever has the focus; otherwise only
/// if the view has it. They act in screen directions, independent of the camera's azimuth. In editors and choosers,
/// Enter and Esc finish the input and return the focus to the view, and have no other effect; a table that doesn't use
/// Enter leaves it to the game.
class GameKeys : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    GameKeys(Session &session, QWidget &window, gl::MazeView &view);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    bool hasKeyboard() const;
    bool isForGame(const QKeyEvent &event) const;
    void noticeFocus(Qt::FocusReason reason);
    bool isForWidget(const QKeyEvent &event, const QWidget *widget) const;
    bool takeArrow(const QKeyEvent &event);
    void returnKeyboardAfter(const QWidget *editor);
    void sendKeys();
    void releaseAll();
    void advance();

    Session &m_session;
    QWidget &m_window;
    gl::MazeView &m_view;
    /// Bit masks of the held keys for left, up, right, down (Qt's order); the keypad's keys count separately.
    std::array<unsigned, 4> m_held{};
    bool m_isControlChosen = true; ///< the focused one, by Tab or the mouse
    QTimer m_pulse;
    QElapsedTimer m_clock;
};

} // namespace inspector::ui
