// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>

namespace inspector::ui {

// A slider whose notches are `fine` places apart. It moves by notches; with Shift by places, and a drag with Shift is a
// tenth as fast as the hand. A press beside the handle brings it there.
class FineSlider : public QSlider {
    Q_OBJECT

public:
    // last: the place at the right end. fine: > 0.
    FineSlider(int last, int fine, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override { return {120, QSlider::minimumSizeHint().height()}; }

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
    int m_lastX = 0;        // of the mouse, while it drags
    double m_dragged = 0.0; // where the handle would be between two places
};

} // namespace inspector::ui
