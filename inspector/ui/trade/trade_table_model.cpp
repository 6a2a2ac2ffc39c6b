// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trade/trade_table_model.h"

#include "core/setup/numbers.h"
#include "core/setup/tables.h"
#include "core/trade/trade_table.h"
#include "ui/trade/trade_chart.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace inspector::ui {

namespace {

const TradeColumn &columnAt(int column) { return tradeColumns()[size_t(column - TradeTableModel::kNameColumns)]; }

int noteColumn() { return TradeTableModel::kNameColumns + int(tradeColumns().size()); }

} // namespace

void TradeTableModel::show(const TradePlan &plan, const TradeResult &result) {
    m_registry = plan.registry;
    if (plan.scene) m_horizon = plan.horizon; // something has been measured
    emit headerDataChanged(Qt::Horizontal, kNameColumns, noteColumn());
    if (result.points.size() == m_points.size()) {
        m_points = result.points;
        if (!m_points.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        return;
    }
    beginResetModel();
    m_points = result.points;
    endResetModel();
}

int TradeTableModel::columnOf(const char *id) {
    const std::vector<TradeColumn> &columns = tradeColumns();
    const auto isIt = [id](const TradeColumn &column) { return std::string_view(column.id) == id; };
    return kNameColumns + int(std::find_if(columns.begin(), columns.end(), isIt) - columns.begin());
}

int TradeTableModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_points.size()); }

int TradeTableModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : noteColumn() + 1; }

QVariant TradeTableModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid()) return {};
    const TradePoint &point = m_points[size_t(index.row())];
    const bool isFigure = index.column() >= StepSize && index.column() != Model && index.column() != noteColumn();
    switch (role) {
    case Qt::DisplayRole:
        return text(point, index.column());
    case Qt::DecorationRole:
        return index.column() == Stepper && m_colourOf ? QVariant(m_colourOf(point.stepper)) : QVariant();
    case Qt::ToolTipRole:
        return tradePointText(point, stepperName(m_registry, point.stepper));
    case Qt::TextAlignmentRole:
        return isFigure ? int(Qt::AlignRight | Qt::AlignVCenter) : int(Qt::AlignLeft | Qt::AlignVCenter);
    case kSortRole:
        return number(point, index.column());
    default:
        return {};
    }
}

QVariant TradeTableModel::text(const TradePoint &point, int column) const {
    if (column == Stepper) return stepperName(m_registry, point.stepper);
    if (column == StepSize) return stepSizeText(point.dt);
    if (column == Model) return modelName(point.model);
    if (column == noteColumn()) return point.note;
    return figureText(columnAt(column), point);
}

QVariant TradeTableModel::number(const TradePoint &point, int column) const {
    if (column == StepSize) return point.dt;
    if (column < kNameColumns || column == noteColumn()) return text(point, column);
    return columnAt(column).value(point).value_or(std::numeric_limits<double>::infinity());
}

QVariant TradeTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (section == noteColumn()) return role == Qt::DisplayRole ? tr("Note") : QVariant();
    if (section < kNameColumns) {
        const QString names[] = {tr("Stepper"), tr("Step size"), tr("Model")};
        return role == Qt::DisplayRole ? names[section] : QVariant();
    }
    const TradeColumn &column = columnAt(section);
    if (role == Qt::ToolTipRole) return QString::fromUtf8(column.help);
    if (role != Qt::DisplayRole) return {};
    const QString below = spanAndUnit(column, printedUnit(QString::fromUtf8(column.unit)), m_horizon);
    return below.isEmpty() ? QString::fromUtf8(column.label)
                           : QString::fromUtf8(column.label) + QLatin1Char('\n') + below;
}

} // namespace inspector::ui
