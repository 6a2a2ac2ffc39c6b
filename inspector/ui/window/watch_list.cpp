// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/watch_list.h"

#include "core/setup/numbers.h"
#include "ui/parts/settings_keys.h"
#include "ui/plots/quantity_menu.h"
#include "ui/plots/quantity_plot.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QMimeData>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {
const QString kUsualWatched = QStringLiteral("position_x,position_y,speed,energy,substeps,step_time");
}

WatchList::WatchList(Session &session, QWidget *parent)
    : QTreeWidget(parent)
    , m_session(session)
    , m_channels(plotContentOf(session.settings().value(settings_keys::kWatched, kUsualWatched).toString()).channels) {
    setObjectName(QStringLiteral("watched"));
    setFrameShape(QFrame::NoFrame);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAlternatingRowColors(true);
    setFocusPolicy(Qt::TabFocus); // a click doesn't take the keyboard from the game
    setDragEnabled(true);
    setHeaderLabels({tr("Quantity"), tr("Value"), tr("Unit")});
    setToolTip(tr("Right click: choose quantities. Drag a name onto a plot to see it there."));
    header()->setSectionsMovable(false);
    rebuild();
}

void WatchList::rebuild() {
    clear();
    for (const Channel channel : m_channels) {
        const ChannelInfo &info = channelInfos()[size_t(channel)];
        auto *item = new QTreeWidgetItem(
            this, {QString::fromUtf8(info.label), QStringLiteral("–"), printedUnit(QString::fromUtf8(info.unit))});
        item->setData(0, Qt::UserRole, QByteArray(info.id));
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    }
    fitColumns();
}

/// The names are seen whole, and each value, which would be read as another one if it were cut.
void WatchList::fitColumns() {
    constexpr int kLeastName = 130; // pixels
    constexpr int kMargins = 8;     // of both sides
    setColumnWidth(0, std::max(kLeastName, sizeHintForColumn(0)));
    setColumnWidth(1, fontMetrics().horizontalAdvance(QStringLiteral("-0.00000e-00")) + kMargins);
}

void WatchList::changeEvent(QEvent *event) {
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitColumns();
}

void WatchList::refresh(const Snapshot &now) {
    if (!isVisible()) return;
    const SampleRing &samples = m_session.simulation().samples();
    Sample sample;
    const bool isThere = samples.read(samples.find(now.current.time), sample) && sample.step == now.current.step;
    if (!isThere) sample = sampleBeforeAStep(m_session.scene().get(), now.current, now.inputs);
    for (int i = 0; i < topLevelItemCount(); ++i) {
        const double value = sample[m_channels[size_t(i)]];
        const QString text = std::isnan(value) ? QStringLiteral("–") : QString::number(value, 'g', 6);
        if (topLevelItem(i)->text(1) != text) topLevelItem(i)->setText(1, text);
    }
}

void WatchList::toggle(Channel channel) {
    if (std::erase(m_channels, channel) == 0) m_channels.push_back(channel);
    m_session.settings().setValue(settings_keys::kWatched, textOf(PlotContent{m_channels, false}));
    rebuild();
    refresh(m_session.simulation().latest());
}

void WatchList::contextMenuEvent(QContextMenuEvent *event) {
    auto *menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("watch_menu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addQuantities(
        *menu,
        [this](Channel channel) {
            return std::find(m_channels.begin(), m_channels.end(), channel) != m_channels.end();
        },
        [this](Channel channel) { toggle(channel); });
    menu->popup(event->globalPos());
}

QMimeData *WatchList::mimeData(const QList<QTreeWidgetItem *> &items) const {
    auto *dragged = new QMimeData;
    if (!items.isEmpty())
        dragged->setData(QLatin1String(kQuantityMime), items.front()->data(0, Qt::UserRole).toByteArray());
    return dragged;
}

} // namespace inspector::ui
