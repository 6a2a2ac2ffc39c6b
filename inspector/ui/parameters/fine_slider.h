// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>

namespace inspector::ui {

/// A slider whose notches are `fine` positions apart. It moves by notches, with Shift by single positions; a drag with
/// Shift is ten times slower. A press next to the handle moves the handle there.
class FineSlider : public QSlider {
    Q_OBJECT

public:
    /// last: the position at the right end. fine: > 0.
    FineSlider(int last, int fine, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {120, QSlider::sizeHint().height()}; }
    QSize minimumSizeHint() const override { return {56, QSlider::minimumSizeHint().height()}; }

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    QRect handle() const;
    double placesPerPixel() const;
    void stepBy(double notches, Qt::KeyboardModifiers modifiers);

    int m_fine;
    int m_lastX = 0;        ///< of the mouse during a drag
    double m_dragged = 0.0; ///< exact position of the handle during a slow drag
};

} // namespace inspector::ui
