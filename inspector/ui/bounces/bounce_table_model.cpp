// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bounces/bounce_table_model.h"

#include "core/events/event_table.h"
#include "core/setup/numbers.h"

#include <algorithm>
#include <vector>

namespace inspector::ui {

namespace {

/// Old rows are removed in blocks, because a table that loses a row at each refresh is unreadable.
constexpr uint64_t kDroppedAtOnce = 128;

const std::vector<const EventColumn *> &shownColumns() {
    static const std::vector<const EventColumn *> columns = [] {
        std::vector<const EventColumn *> shown;
        for (const EventColumn &column : eventColumns())
            if (column.isShown) shown.push_back(&column);
        return shown;
    }();
    return columns;
}

/// Columns: time, event, the other figures, stepper.
int stepperColumn() { return int(shownColumns().size()) + 1; }
const EventColumn &figureAt(int column) {
    return *shownColumns()[size_t(column < BounceTableModel::kWhat ? column : column - 1)];
}

} // namespace

BounceTableModel::BounceTableModel(const EventLog &log, const Registry &registry, QObject *parent)
    : QAbstractTableModel(parent)
    , m_log(log)
    , m_registry(registry)
    , m_generation(log.generation()) {}

bool BounceTableModel::refresh() {
    const uint64_t revision = m_log.revision();
    const bool isNewRun = startAnew();
    if (revision == m_revision && !isNewRun) return false;
    dropOldest();
    // An entry being written is fetched the next time.
    if (growNewest() && appendNew()) m_revision = revision;
    return true;
}

bool BounceTableModel::startAnew() {
    const uint64_t generation = m_log.generation();
    if (generation == m_generation) return false;
    beginResetModel();
    m_generation = generation;
    m_events.clear();
    m_next = m_log.first();
    endResetModel();
    return true;
}

bool BounceTableModel::dropOldest() {
    if (m_events.size() <= m_log.capacity()) return false;
    const size_t count = m_events.size() - m_log.capacity() + size_t(kDroppedAtOnce);
    beginRemoveRows({}, 0, int(count) - 1);
    m_events.erase(m_events.begin(), m_events.begin() + long(count));
    endRemoveRows();
    return true;
}

bool BounceTableModel::growNewest() {
    const size_t reach = std::min(m_events.size(), size_t(EventLog::kReach));
    for (size_t row = m_events.size() - reach; row < m_events.size(); ++row) {
        LoggedEvent now;
        if (!m_log.read(m_events[row].number, now)) {
            if (m_events[row].number < m_log.first()) continue; // overwritten in the log, but not yet removed here
            return false;
        }
        if (now.count == m_events[row].count) continue;
        m_events[row] = now;
        emit dataChanged(index(int(row), 0), index(int(row), columnCount() - 1));
    }
    return true;
}

bool BounceTableModel::appendNew() {
    std::vector<LoggedEvent> found;
    m_next = std::max(m_next, m_log.first());
    const uint64_t last = m_log.last();
    for (; m_next < last; ++m_next) {
        LoggedEvent event;
        if (m_log.read(m_next, event)) {
            found.push_back(event);
        } else if (m_next >= m_log.first()) {
            break;
        }
    }
    if (found.empty()) return m_next == last;
    beginInsertRows({}, rowCount(), rowCount() + int(found.size()) - 1);
    m_events.insert(m_events.end(), found.begin(), found.end());
    endInsertRows();
    return m_next == last;
}

int BounceTableModel::rowOf(uint64_t number) const {
    const auto isBefore = [](const LoggedEvent &event, uint64_t wanted) { return event.number < wanted; };
    const auto found = std::lower_bound(m_events.begin(), m_events.end(), number, isBefore);
    return found != m_events.end() && found->number == number ? int(found - m_events.begin()) : -1;
}

int BounceTableModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_events.size()); }

int BounceTableModel::columnCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : stepperColumn() + 1;
}

QVariant BounceTableModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid()) return {};
    const LoggedEvent &event = m_events[size_t(index.row())];
    const bool isText = index.column() == kWhat || index.column() == stepperColumn();
    if (role == Qt::TextAlignmentRole) return int((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    const bool isTip = role == Qt::ToolTipRole && index.column() == kWhat; // the column may be too narrow
    if (role != Qt::DisplayRole && !isTip) return {};
    if (index.column() == kWhat) return eventText(event);
    if (index.column() == stepperColumn()) return stepperName(m_registry, stepperId(m_registry, event.step.stepper));
    return figureText(figureAt(index.column()), event);
}

QVariant BounceTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) return {};
    if (section == kWhat) return role == Qt::DisplayRole ? tr("What") : QVariant();
    if (section == stepperColumn()) return role == Qt::DisplayRole ? tr("Stepper") : QVariant();
    const EventColumn &column = figureAt(section);
    if (role == Qt::ToolTipRole) return QString::fromUtf8(column.help);
    const QString unit = QString::fromUtf8(column.unit);
    const QString label = QString::fromUtf8(column.label);
    return unit.isEmpty() ? label : QStringLiteral("%1 [%2]").arg(label, printedUnit(unit));
}

} // namespace inspector::ui
