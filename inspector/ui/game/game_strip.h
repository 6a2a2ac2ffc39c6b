// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QFrame>

class QLabel;
class QToolButton;

namespace inspector::ui {

class ElidedLabel;

/// The game's text above the view.
struct GameText {
    QString title;
    QString line;
    QString hint;
    QString clock;
    bool isResult = false; ///< a level is finished; it can be dismissed
    bool operator==(const GameText &) const = default;
};

/// A level's title: "Level 3", or the name of a file outside of the list.
QString levelTitle(const Session &session, const Level &level);

/// now: of the session's simulation.
GameText gameText(Session &session, const Snapshot &now);

/// A banner above the view, so that nothing covers the board; of one line, and of more where those have no room beside
/// each other.
class GameStrip : public QFrame {
    Q_OBJECT

public:
    explicit GameStrip(QWidget *parent = nullptr);

    void setText(const GameText &text);
    const GameText &text() const { return m_text; } ///< the shown text
    /// Dismisses a result; false if none is shown.
    bool dismiss();

protected:
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;

private:
    void show(const GameText &text);
    void takeFont();

    GameText m_text;
    GameText m_dismissed;
    ElidedLabel *m_title;
    ElidedLabel *m_line;
    ElidedLabel *m_hint;
    QLabel *m_clock;
    QToolButton *m_close;
};

} // namespace inspector::ui
