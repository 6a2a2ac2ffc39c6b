// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "ui/bounces/bounce_marks.h"

#include <QWidget>

#include <optional>
#include <vector>

class QCheckBox;
class QLabel;
class QScrollArea;
class QTableView;

namespace inspector::ui {

class BounceFilter;
class BounceTableModel;
class ElidedLabel;

/// The events of this run, one row each, and the details of the selected one: its figures and the law that applies to
/// it.
class BounceDock : public QWidget {
    Q_OBJECT

public:
    /// session must outlive the dock.
    explicit BounceDock(Session &session, QWidget *parent = nullptr);

    /// Shows new events; called about 30 times a second.
    void refresh();

    std::optional<LoggedEvent> selected() const;
    void select(uint64_t number); ///< an entry of the log, even one hidden by filters
    void selectAt(double time);   ///< the bounce at exactly this time
    void clearSelection();

    /// The last bounces that aren't slow, and the selected event.
    const BounceMarks &marks() const { return m_marks; }
    /// The times of all bounces that aren't slow, s.
    std::vector<double> bounceTimes() const;

    QSize sizeHint() const override { return {900, 260}; }

signals:
    /// A section of the model page was requested, by number.
    void sectionWanted(const QString &section);
    void changed(); ///< events or selection changed

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QCheckBox *addFilter(const QString &text, const char *name, const QString &tip);
    void makeTable();
    void fitTable();
    void fitWhat();
    void applyFilter();
    void showSelected();
    void showDetail(const std::optional<LoggedEvent> &event);
    void showCount();
    void selectAwaited();
    void copy() const;
    void findMarks();

    Session &m_session;
    BounceTableModel *m_events;
    BounceFilter *m_filter;
    QCheckBox *m_slow;
    QCheckBox *m_others;
    ElidedLabel *m_count;
    QTableView *m_table;
    QScrollArea *m_area; ///< scrolls the next member
    QLabel *m_detail;
    BounceMarks m_marks;
    std::optional<LoggedEvent> m_awaited; ///< selected in the previous run
};

} // namespace inspector::ui
