// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves the dock: files and the clipboard.
#include "core/program/outputs.h"
#include "core/setup/files.h"
#include "core/trade/trade_svg.h"
#include "core/trade/trade_table.h"
#include "ui/trade/trade_dock.h"
#include "ui/trade/trade_picture.h"
#include "ui/trade/trade_table_model.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QMimeData>
#include <QSortFilterProxyModel>
#include <QTableView>

#include <algorithm>

namespace inspector::ui {

bool TradeDock::save(const QString &path, QString *error) {
    if (m_worker.result().spans.empty()) {
        *error = tr("%1: nothing has been measured yet").arg(path);
        return false;
    }
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("csv")) return saveTable(path, error);
    if (suffix == QLatin1String("svg")) return replaceFile(path, tradeSvg(describedChart()), error);
    return writeTradePicture(describedChart(), path, error);
}

bool TradeDock::saveTable(const QString &path, QString *error) const {
    const TradePlan &plan = m_worker.plan();
    Options options;
    options.level = m_measuredOn;
    options.settings = m_measuredWith;
    options.settings.push_back({QStringLiteral("model"), double(plan.inputs.params.model)});
    return replaceFile(path, tradeCsv(m_worker.result().points), error) &&
           replaceFile(settingsFileOf(path), tradeSettings(options, plan), error);
}

/// Copies the selected rows, as they are sorted, both as tab-separated text and as CSV.
void TradeDock::copy() const {
    QModelIndexList rows = m_table->selectionModel()->selectedRows();
    std::sort(rows.begin(), rows.end());
    std::vector<TradePoint> points;
    for (const QModelIndex &row : rows) points.push_back(m_rows->points()[size_t(m_sorted->mapToSource(row).row())]);
    auto *copied = new QMimeData;
    copied->setText(QString::fromUtf8(tradeCsv(points, '\t')));
    copied->setData(QStringLiteral("text/csv"), tradeCsv(points));
    QGuiApplication::clipboard()->setMimeData(copied);
}

/// While the table has the focus it handles Ctrl+C.
bool TradeDock::eventFilter(QObject *object, QEvent *event) {
    const bool isOffer = event->type() == QEvent::ShortcutOverride;
    if (object != m_table || (!isOffer && event->type() != QEvent::KeyPress)) return false;
    const bool isCopy = static_cast<QKeyEvent *>(event)->matches(QKeySequence::Copy);
    if (!isCopy || !m_table->selectionModel()->hasSelection()) return false;
    if (!isOffer) copy();
    event->accept();
    return true;
}

} // namespace inspector::ui
