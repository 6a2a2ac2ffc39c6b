// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/flow_layout.h"

#include <QWidget>

#include <algorithm>

namespace inspector::ui {

namespace {

int heightOf(const std::vector<QLayoutItem *> &row) {
    int height = 0;
    for (const QLayoutItem *item : row) height = std::max(height, item->sizeHint().height());
    return height;
}

/// Whether the item is a text that is elided where it has no room.
bool isIgnored(QLayoutItem &item) {
    return item.widget() && item.widget()->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
}

bool canGrow(QLayoutItem &item) { return isIgnored(item) || (item.expandingDirections() & Qt::Horizontal); }

int widthOf(QLayoutItem &item) { return isIgnored(item) ? item.minimumSize().width() : item.sizeHint().width(); }

} // namespace

FlowLayout::FlowLayout(QWidget *parent)
    : QLayout(parent) {
    setContentsMargins(0, 0, 0, 0);
    setSpacing(6);
}

FlowLayout::~FlowLayout() {
    for (QLayoutItem *item : m_items) delete item;
}

void FlowLayout::addItem(QLayoutItem *item) { m_items.push_back(item); }

QLayoutItem *FlowLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? m_items[size_t(index)] : nullptr;
}

QLayoutItem *FlowLayout::takeAt(int index) {
    QLayoutItem *item = itemAt(index);
    if (item) m_items.erase(m_items.begin() + index);
    return item;
}

std::vector<FlowLayout::Row> FlowLayout::rowsIn(int width) const {
    std::vector<Row> rows;
    int used = 0;
    for (QLayoutItem *item : m_items) {
        if (item->isEmpty()) continue; // hidden
        const int own = widthOf(*item);
        if (rows.empty() || used + spacing() + own > width) {
            rows.push_back({item});
            used = own;
        } else {
            rows.back().push_back(item);
            used += spacing() + own;
        }
    }
    return rows;
}

int FlowLayout::heightForWidth(int width) const {
    int height = 0;
    for (const Row &row : rowsIn(width)) height += (height > 0 ? spacing() : 0) + heightOf(row);
    return height;
}

QSize FlowLayout::sizeHint() const {
    const std::vector<Row> rows = rowsIn(QWIDGETSIZE_MAX);
    int width = 0;
    for (const Row &row : rows)
        for (QLayoutItem *item : row) width += (width > 0 ? spacing() : 0) + widthOf(*item);
    return {width, heightForWidth(QWIDGETSIZE_MAX)};
}

QSize FlowLayout::minimumSize() const {
    QSize least;
    for (const QLayoutItem *item : m_items)
        if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
    return least;
}

void FlowLayout::setGeometry(const QRect &place) {
    QLayout::setGeometry(place);
    int top = place.top();
    for (const Row &row : rowsIn(place.width())) {
        const int height = heightOf(row);
        placeRow(row, {place.left(), top, place.width(), height});
        top += height + spacing();
    }
}

void FlowLayout::placeRow(const Row &row, const QRect &place) const {
    int rest = place.width() - spacing() * (int(row.size()) - 1);
    int growing = 0;
    for (QLayoutItem *item : row) {
        rest -= widthOf(*item);
        growing += canGrow(*item) ? 1 : 0;
    }
    int left = place.left();
    for (QLayoutItem *item : row) {
        int width = widthOf(*item);
        if (growing > 0 && rest > 0 && canGrow(*item)) {
            const int share = rest / growing--;
            width += share;
            rest -= share;
        }
        width = std::min(width, place.width());
        const int height = std::min(place.height(), item->sizeHint().height());
        item->setGeometry({left, place.top() + (place.height() - height) / 2, width, height});
        left += width + spacing();
    }
}

QWidget *flowOf(std::initializer_list<QWidget *> widgets) {
    auto *layout = new FlowLayout;
    auto *flow = new QWidget;
    flow->setLayout(layout);
    for (QWidget *widget : widgets) layout->addWidget(widget);
    return flow;
}

} // namespace inspector::ui
