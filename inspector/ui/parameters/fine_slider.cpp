// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameters/fine_slider.h"

#include <QKeyEvent>
#include <QStyleOptionSlider>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {
constexpr double kSlow = 0.1; ///< speed of a drag with Shift
}

FineSlider::FineSlider(int last, int fine, QWidget *parent)
    : QSlider(Qt::Horizontal, parent)
    , m_fine(fine) {
    setFocusPolicy(Qt::StrongFocus);
    setRange(0, last);
    setSingleStep(fine);
    setPageStep(std::max(fine, last / fine / 20 * fine));
}

QRect FineSlider::handle() const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    return style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
}

double FineSlider::placesPerPixel() const {
    return double(maximum() - minimum()) / std::max(1, width() - handle().width());
}

void FineSlider::stepBy(double notches, Qt::KeyboardModifiers modifiers) {
    setValue(value() + int(std::lround(notches * (modifiers & Qt::ShiftModifier ? 1 : m_fine))));
}

void FineSlider::keyPressEvent(QKeyEvent *event) {
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        return stepBy(-1.0, event->modifiers());
    case Qt::Key_Right:
    case Qt::Key_Up:
        return stepBy(1.0, event->modifiers());
    default:
        return QSlider::keyPressEvent(event);
    }
}

/// With Shift the wheel scrolls horizontally on some systems.
void FineSlider::wheelEvent(QWheelEvent *event) {
    const QPoint turned = event->angleDelta();
    stepBy((turned.y() != 0 ? turned.y() : turned.x()) / 120.0, event->modifiers());
    event->accept();
}

void FineSlider::mousePressEvent(QMouseEvent *event) {
    if (event->button() != Qt::LeftButton) return event->ignore();
    m_lastX = event->pos().x();
    setSliderDown(true);
    if (!handle().contains(event->pos())) {
        const double place = (m_lastX - 0.5 * handle().width()) * placesPerPixel();
        setValue(int(std::lround(place / m_fine)) * m_fine);
    }
    m_dragged = value();
}

void FineSlider::mouseMoveEvent(QMouseEvent *event) {
    if (!isSliderDown()) return;
    const bool isFine = event->modifiers() & Qt::ShiftModifier;
    m_dragged += (event->pos().x() - m_lastX) * placesPerPixel() * (isFine ? kSlow : 1.0);
    m_lastX = event->pos().x();
    setValue(isFine ? int(std::lround(m_dragged)) : int(std::lround(m_dragged / m_fine)) * m_fine);
}

void FineSlider::mouseReleaseEvent(QMouseEvent *) { setSliderDown(false); }

} // namespace inspector::ui
