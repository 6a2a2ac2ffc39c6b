// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

class QKeyEvent;
class QWidget;

namespace inspector::ui {

// The keyboard's way to the game. While a level is played, arrow keys tilt the board wherever the focus is; otherwise
// they do so with the focus on the view. Where text is typed, Enter belongs to the text and not to the game.
class GameKeys : public QObject {
    Q_OBJECT

public:
    // All outlive this object.
    GameKeys(Session &session, QWidget &window, QWidget &view);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    bool isForGame(const QKeyEvent &event) const;
    bool isForWidget(const QKeyEvent &event, const QWidget *widget) const;
    void hold(int key, bool isDown);
    void releaseAll();
    void advance();

    Session &m_session;
    QWidget &m_window;
    QWidget &m_view;
    TiltKeys m_keys;
    QTimer m_pulse;
    QElapsedTimer m_clock;
};

} // namespace inspector::ui
