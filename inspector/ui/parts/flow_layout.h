// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>

#include <initializer_list>
#include <vector>

namespace inspector::ui {

/// Places widgets beside each other, in as many rows as the width requires. In each row the remaining width is shared
/// by the widgets that can grow. Widgets whose size hint is ignored need only their minimum, hidden ones nothing.
class FlowLayout : public QLayout {
public:
    explicit FlowLayout(QWidget *parent = nullptr);
    ~FlowLayout() override;

    void addItem(QLayoutItem *item) override;
    int count() const override { return int(m_items.size()); }
    QLayoutItem *itemAt(int index) const override;
    QLayoutItem *takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override; ///< in one row
    QSize minimumSize() const override;
    void setGeometry(const QRect &place) override;

private:
    using Row = std::vector<QLayoutItem *>;
    std::vector<Row> rowsIn(int width) const;
    void placeRow(const Row &row, const QRect &place) const;

    std::vector<QLayoutItem *> m_items;
};

/// A widget with these widgets in a FlowLayout.
QWidget *flowOf(std::initializer_list<QWidget *> widgets);

} // namespace inspector::ui
