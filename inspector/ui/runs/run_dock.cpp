// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_dock.h"

#include "core/session/run_values.h"
#include "core/setup/numbers.h"
#include "core/setup/tables.h"
#include "ui/game/clock_text.h"
#include "ui/game/game_strip.h"
#include "ui/parts/empty_text.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QSignalBlocker>

#include <algorithm>

namespace inspector::ui {

namespace {

bool isEnter(const QKeyEvent &event) { return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter; }

constexpr int kEndRole = Qt::UserRole;       ///< in the first column: the run's last place
constexpr int kBeginRole = Qt::UserRole + 1; ///< the same: where it begins, which identifies it

uint64_t beginOf(const QTreeWidgetItem &item) { return item.data(0, kBeginRole).toULongLong(); }
uint64_t endOf(const QTreeWidgetItem &item) { return item.data(0, kEndRole).toULongLong(); }

/// Lists each of them once, in the order of their first use.
QString listed(QStringList texts) {
    texts.removeDuplicates();
    return texts.join(QStringLiteral(", "));
}

QString resultOf(const KeptRun &run, bool isLive) {
    switch (run.side) {
    case BoardSide::Beside:
        return RunDock::tr("out of the maze");
    case BoardSide::Below:
        return RunDock::tr("through a hole");
    case BoardSide::Within:
        break;
    }
    return isLive ? RunDock::tr("the present one") : RunDock::tr("ended inside");
}

/// Tells the versions of a maze apart that was edited: numbered in the order of their first use.
QString mazeTitle(const Session &session, const KeptRun &run) {
    std::vector<uint64_t> versions;
    const auto add = [&versions](uint64_t maze) {
        if (std::ranges::count(versions, maze) == 0) versions.push_back(maze);
    };
    for (const KeptRun &other : session.history().runs())
        if (other.level.path == run.level.path) add(other.maze);
    if (session.levels().maze().path == run.level.path) add(session.levels().maze().hash);
    QString title = levelTitle(session, run.level);
    if (versions.size() < 2) return title;
    return RunDock::tr("%1, version %2").arg(title).arg(std::ranges::find(versions, run.maze) - versions.begin() + 1);
}

QString valueText(const phys_param_row &row, double value) {
    if (row.flags & PHYS_ROW_SWITCH) return value != 0.0 ? RunDock::tr("on") : RunDock::tr("off");
    const QStringList choices = choicesOf(row);
    if (!choices.isEmpty()) return choices.value(int(value - row.min));
    return QStringLiteral("%1 %2").arg(value).arg(printedUnit(QString::fromUtf8(row.unit))).trimmed();
}

/// Restitution, walls 0.7; Gravity 9.81 m/s² → 1.62 m/s²
QString parametersOf(const KeptRun &run, const Registry &registry) {
    QStringList texts;
    for (const auto &[row, first, last] : changedValues(run, registry)) {
        QString text = QString::fromUtf8(row->label) + QLatin1Char(' ') + valueText(*row, first);
        if (last != first) text += QStringLiteral(" → ") + valueText(*row, last);
        texts += text;
    }
    return texts.isEmpty() ? RunDock::tr("initial") : texts.join(QStringLiteral("; "));
}

/// A long run is repeated for a while before it is seen beside the others.
QString withProgress(const QString &result, const RunBeside &beside, const KeptRun &run) {
    const std::optional<double> share = beside.progress();
    if (!share || beside.run()->begin != run.begin) return result;
    return RunDock::tr("%1; repeated to %2 %").arg(result).arg(int(100.0 * *share));
}

QStringList textsOf(const Session &session, const KeptRun &run, bool isLive) {
    QStringList steppers;
    QStringList steps;
    for (const auto &[stepper, dt] : run.pace) {
        steppers += stepperName(session.registry(), stepper);
        steps += durationText(dt);
    }
    return {mazeTitle(session, run),
            listed(steppers),
            listed(steps),
            clockText(run.time),
            withProgress(resultOf(run, isLive), session.history().beside(), run),
            parametersOf(run, session.registry())};
}

/// In bold; a screen reader says it.
void markShown(QTreeWidgetItem &item, bool isShown) {
    if (item.font(0).bold() == isShown) return;
    QFont font = item.treeWidget()->font();
    font.setBold(isShown);
    for (int column = 0; column < item.columnCount(); ++column) item.setFont(column, font);
    item.setData(0, Qt::AccessibleDescriptionRole, isShown ? RunDock::tr("The run shown") : QString());
}

} // namespace

RunDock::RunDock(Session &session, QWidget *parent)
    : QTreeWidget(parent)
    , m_session(session) {
    setObjectName(QStringLiteral("runs"));
    setFrameShape(QFrame::NoFrame);
    setRootIsDecorated(false);
    setAlternatingRowColors(true);
    setUniformRowHeights(true);
    setHeaderLabels({tr("Level"), tr("Stepper"), tr("Time step"), tr("Time"), tr("Result"), tr("Parameters")});
    setToolTip(tr("Double click or Enter: see the run again. Tick one to see it pale beside the others."));
    new EmptyText(*this,
                  tr("No run yet. Every start, restart and change of the past begins one, and all are kept here."));
    header()->setSectionsMovable(false);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    connect(this, &QTreeWidget::itemDoubleClicked, this, [this](const QTreeWidgetItem *item) { goTo(item); });
    connect(this, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem *item, int column) {
        if (column == 0) layBeside(beginOf(*item), item->checkState(0) == Qt::Checked);
    });
}

void RunDock::refresh() {
    if (!isVisible()) return;
    const QSignalBlocker blocker(this); // what changes here isn't the user's
    const std::vector<KeptRun> &runs = m_session.history().runs();
    const uint64_t live = m_session.simulation().latest().history.run; // where it begins
    const RunPlace shown = m_session.runPlace();
    // A run keeps its item, and so the selection: the oldest go at the end, new ones come first.
    const auto oldest = [this] { return topLevelItem(topLevelItemCount() - 1); };
    while (oldest() && (runs.empty() || beginOf(*oldest()) < runs.front().begin))
        delete takeTopLevelItem(topLevelItemCount() - 1);
    while (topLevelItemCount() < int(runs.size())) insertTopLevelItem(0, new QTreeWidgetItem);
    for (size_t i = 0; i < runs.size(); ++i) {
        const KeptRun &run = runs[runs.size() - 1 - i];
        QTreeWidgetItem *item = topLevelItem(int(i));
        const QStringList texts = textsOf(m_session, run, run.begin == live);
        for (int column = 0; column < texts.size(); ++column)
            if (item->text(column) != texts[column]) item->setText(column, texts[column]);
        const bool isShown = !m_session.isReplaying() && run.begin < shown.end && shown.begin < run.end;
        markShown(*item, isShown);
        const std::optional<KeptRun> &beside = m_session.history().beside().run();
        const bool isBeside = beside && beside->begin == run.begin;
        item->setCheckState(0, isBeside ? Qt::Checked : Qt::Unchecked);
        item->setData(0, kEndRole, qulonglong(run.end));
        item->setData(0, kBeginRole, qulonglong(run.begin));
    }
}

void RunDock::goTo(const QTreeWidgetItem *item) { m_session.lookAt(endOf(*item)); }

void RunDock::layBeside(uint64_t begin, bool isOn) {
    m_session.layBeside(isOn ? std::optional(begin) : std::nullopt);
    refresh();
}

void RunDock::contextMenuEvent(QContextMenuEvent *event) {
    const bool isByKey = event->reason() == QContextMenuEvent::Keyboard;
    const QTreeWidgetItem *item = isByKey ? currentItem() : itemAt(event->pos());
    if (!item) return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("See this run again"), this, [this, end = endOf(*item)] { m_session.lookAt(end); });
    QAction *beside = menu->addAction(tr("Show it pale beside the others"));
    beside->setCheckable(true);
    beside->setChecked(item->checkState(0) == Qt::Checked);
    connect(beside, &QAction::toggled, this, [this, begin = beginOf(*item)](bool isOn) { layBeside(begin, isOn); });
    menu->popup(isByKey ? viewport()->mapToGlobal(visualItemRect(item).bottomLeft()) : event->globalPos());
}

/// Enter is the window's otherwise.
bool RunDock::event(QEvent *event) {
    if (event->type() != QEvent::ShortcutOverride) return QTreeWidget::event(event);
    if (currentItem() && isEnter(*static_cast<QKeyEvent *>(event))) event->accept();
    return event->isAccepted();
}

void RunDock::keyPressEvent(QKeyEvent *event) {
    if (currentItem() && isEnter(*event)) return goTo(currentItem());
    QTreeWidget::keyPressEvent(event);
}

} // namespace inspector::ui
