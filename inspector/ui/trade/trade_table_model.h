// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trade/trade.h"

#include <QAbstractTableModel>

namespace inspector::ui {

// The points of a result as rows, their figures as columns. Under kSortRole a column gives numbers.
class TradeTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int kSortRole = Qt::UserRole;
    enum NameColumn { Stepper, StepSize, Model, kNameColumns };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const TradeResult &result);
    // Of the figure with this id (core/trade_table.h), which is there.
    static int columnOf(const char *id);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    // Of the rows shown; the worker may have begun anew meanwhile.
    const std::vector<TradePoint> &points() const { return m_points; }

private:
    QVariant text(const TradePoint &point, int column) const;
    QVariant number(const TradePoint &point, int column) const;

    std::vector<TradePoint> m_points;
};

} // namespace inspector::ui
