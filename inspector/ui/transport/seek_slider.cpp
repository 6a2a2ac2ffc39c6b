// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/transport/seek_slider.h"

#include "ui/parts/theme.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyleOptionSlider>

#include <algorithm>

namespace inspector::ui {

namespace {

constexpr size_t kMostRuns = 500; ///< more marks would merge into a grey bar

bool isEndKey(const QKeyEvent &event) {
    return (event.key() == Qt::Key_Home || event.key() == Qt::Key_End) && event.modifiers() == Qt::NoModifier;
}

} // namespace

SeekSlider::SeekSlider(QWidget *parent)
    : QSlider(Qt::Horizontal, parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumHeight(sizeHint().height() + 6); // room for the marks
}

void SeekSlider::setRuns(std::vector<int> positions) {
    m_runs = positions.size() > kMostRuns ? std::vector<int>() : std::move(positions);
    update();
}

void SeekSlider::setDifference(std::optional<int> position) {
    if (m_difference == position) return;
    m_difference = position;
    update();
}

void SeekSlider::setContinuing(bool isContinuing) {
    if (m_isContinuing == isContinuing) return;
    m_isContinuing = isContinuing;
    update();
}

void SeekSlider::setSpan(std::optional<Span> span) {
    if (m_span == span) return;
    m_span = span;
    update();
}

SeekSlider::Track SeekSlider::track() const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect groove = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
    const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    return {groove.left() + handle.width() / 2, groove.width() - handle.width()};
}

int SeekSlider::pixelOf(int position) const {
    const Track line = track();
    return line.left + QStyle::sliderPositionFromValue(minimum(), maximum(), position, line.length);
}

int SeekSlider::positionAt(int pixel) const {
    const Track line = track();
    return QStyle::sliderValueFromPosition(minimum(), maximum(), pixel - line.left, line.length);
}

/// While the slider has the focus, Home and End are the slider's keys, not the camera's.
bool SeekSlider::event(QEvent *event) {
    if (event->type() == QEvent::ShortcutOverride && isEndKey(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    return QSlider::event(event);
}

void SeekSlider::paintEvent(QPaintEvent *event) {
    QSlider::paintEvent(event);
    QPainter painter(this);
    if (m_span) {
        const int left = pixelOf(std::clamp(m_span->begin, minimum(), maximum()));
        const int right = pixelOf(std::clamp(m_span->end, minimum(), maximum()));
        painter.fillRect(left, height() - 3, right - left + 1, 3, accentsFor(palette()).selected);
    }
    painter.setPen(palette().color(QPalette::Disabled, QPalette::WindowText));
    for (const int run : m_runs) painter.drawLine(pixelOf(run), height() - 4, pixelOf(run), height());
    if (m_isContinuing)
        for (const int x : {2, 5}) painter.drawLine(x + 2, 1, x, height() - 2);
    if (!m_difference) return;
    const double x = pixelOf(*m_difference) + 0.5;
    QPainterPath flag(QPointF(x, 6.0));
    flag.lineTo(x - 4.0, 0.0);
    flag.lineTo(x + 4.0, 0.0);
    flag.closeSubpath();
    const QColor alarm = accentsFor(palette()).alarm;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(flag, alarm);
    painter.fillRect(QRectF(x - 0.75, 5.0, 1.5, height() - 5.0), alarm);
}

void SeekSlider::mousePressEvent(QMouseEvent *event) {
    if (event->button() != Qt::LeftButton) return event->ignore();
    setSliderDown(true);
    setSliderPosition(positionAt(event->pos().x()));
}

void SeekSlider::mouseMoveEvent(QMouseEvent *event) {
    if (isSliderDown()) setSliderPosition(positionAt(event->pos().x()));
}

void SeekSlider::mouseReleaseEvent(QMouseEvent *) { setSliderDown(false); }

} // namespace inspector::ui
