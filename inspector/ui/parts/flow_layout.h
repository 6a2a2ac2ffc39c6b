// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>

#include <vector>

namespace inspector::ui {

/// Widgets beside each other, in as many rows as the width makes necessary. In each row the widgets that can grow share
/// the room that is left; those whose size hint is ignored ask for their minimum only, hidden ones for nothing.
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

} // namespace inspector::ui
