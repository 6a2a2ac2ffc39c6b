// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QWidget>

namespace inspector::ui {

// What the game says over the view.
struct OverlayText {
    QString clock; // in the upper left corner
    QString title; // on a card in the middle: title, line, hint
    QString line;
    QString hint;
    bool operator==(const OverlayText &) const = default;
};

// What the open level is called: "Level 3", or the name of a file that isn't in the list.
QString levelTitle(const Session &session);

// now: of the session's simulation.
OverlayText overlayText(Session &session, const Snapshot &now);

// Shows the text over its parent, as large as the parent, and lets the mouse through.
class GameOverlay : public QWidget {
    Q_OBJECT

public:
    explicit GameOverlay(QWidget *parent);

    void setText(const OverlayText &text);
    const OverlayText &text() const { return m_text; }

protected:
    void paintEvent(QPaintEvent *event) override;
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void paintClock(QPainter &painter) const;
    void paintCard(QPainter &painter) const;
    void paintPlate(QPainter &painter, const QRectF &rect) const;

    OverlayText m_text;
};

} // namespace inspector::ui
