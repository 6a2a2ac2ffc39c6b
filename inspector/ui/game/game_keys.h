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

// The keyboard's way to the game. While a level is played, arrow keys tilt the board wherever the focus is; otherwise
// they do so with the focus on the view. They tilt it the way the view shows it, from wherever it is looked at. Where
// something is typed or chosen, Enter and Esc end that, give the keyboard back to the view and do nothing else.
class GameKeys : public QObject {
    Q_OBJECT

public:
    // All outlive this object.
    GameKeys(Session &session, QWidget &window, gl::MazeView &view);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    bool isForGame(const QKeyEvent &event) const;
    bool isForWidget(const QKeyEvent &event, const QWidget *widget) const;
    bool takeArrow(const QKeyEvent &event);
    void returnKeyboardAfter(const QWidget *editor);
    void sendKeys();
    void releaseAll();
    void advance();

    Session &m_session;
    QWidget &m_window;
    gl::MazeView &m_view;
    // Left, up, right, down (Qt's order): which of the keys for it are held, those of the keypad being others.
    std::array<unsigned, 4> m_held{};
    QTimer m_pulse;
    QElapsedTimer m_clock;
};

} // namespace inspector::ui
