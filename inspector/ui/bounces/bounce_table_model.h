// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/events/event_log.h"

#include <QAbstractTableModel>

#include <deque>

namespace inspector::ui {

/// The entries of a run's log as rows, oldest first. They are copies, so that a row doesn't change while it is
/// selected.
class BounceTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// log must outlive the model.
    BounceTableModel(const EventLog &log, const Registry &registry, QObject *parent = nullptr);

    /// Fetches new entries of the log; false if there are none.
    bool refresh();

    static constexpr int kWhat = 1; ///< column of what happened

    const std::deque<LoggedEvent> &events() const { return m_events; }
    /// Row of the entry with this number; -1 if it isn't there.
    int rowOf(uint64_t number) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    bool startAnew();
    bool dropOldest();
    bool growNewest();
    bool appendNew();

    const EventLog &m_log;
    const Registry &m_registry; ///< may be replaced

    std::deque<LoggedEvent> m_events;
    uint64_t m_next = 0; ///< number of the first entry not fetched yet
    uint64_t m_generation = 0;
    uint64_t m_revision = 0; ///< revision of the log as fetched
};

} // namespace inspector::ui
