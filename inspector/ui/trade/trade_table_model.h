// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trade/trade.h"
#include "core/trade/trade_options.h"

#include <QAbstractTableModel>
#include <QColor>

#include <functional>

namespace inspector::ui {

/// The points of a result as rows, their figures as columns. kSortRole returns numbers.
class TradeTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int kSortRole = Qt::UserRole;
    enum NameColumn { Stepper, StepSize, Model, kNameColumns };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const TradePlan &plan, const TradeResult &result);
    /// The steppers' names have the colours of their curves beside them, so that the table is the chart's legend.
    void setColours(std::function<QColor(const QByteArray &stepper)> colourOf) { m_colourOf = std::move(colourOf); }
    /// The column of the figure with this id (core/trade/trade_table.h), which must exist.
    static int columnOf(const char *id);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    /// The points shown; the worker may have started over meanwhile.
    const std::vector<TradePoint> &points() const { return m_points; }

private:
    QVariant text(const TradePoint &point, int column) const;
    QVariant number(const TradePoint &point, int column) const;

    std::function<QColor(const QByteArray &)> m_colourOf;
    Registry m_registry; ///< has the steppers' names
    std::vector<TradePoint> m_points;
    double m_horizon = kTradeHorizon; ///< s, the measured plan's
};

} // namespace inspector::ui
