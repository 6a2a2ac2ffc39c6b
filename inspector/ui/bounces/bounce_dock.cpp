// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bounces/bounce_dock.h"

#include "core/events/bounce.h"
#include "core/events/event_table.h"
#include "ui/bounces/bounce_table_model.h"
#include "ui/parts/elided_label.h"
#include "ui/parts/empty_text.h"
#include "ui/parts/settings_keys.h"
#include "ui/parts/turning_splitter.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QTableView>

#include <algorithm>

namespace inspector::ui {

namespace {

constexpr size_t kMarks = 20;
constexpr int kNarrow = 37; ///< lines of text

/// Turns references to sections of the model page into links.
QString withLinks(QString escaped) {
    static const QRegularExpression named(QStringLiteral("model\\.md (\\d+\\.\\d+)( [A-Z]\\d)?"));
    return escaped.replace(named, QStringLiteral("<a href='\\1'>model.md \\1\\2</a>"));
}

/// A layout with labels to the left of the texts.
QString columns(const std::vector<LawLine> &lines) {
    QString rows;
    for (const LawLine &line : lines)
        rows +=
            QStringLiteral("<tr><td style='padding-right: 12px; white-space: nowrap'><b>%1</b></td><td>%2</td></tr>")
                .arg(line.label.toHtmlEscaped(), withLinks(line.text.toHtmlEscaped()));
    return QStringLiteral("<table cellspacing='1'>%1</table>").arg(rows);
}

/// A layout with labels above the texts, for a dock that is too narrow for columns.
QString paragraphs(const std::vector<LawLine> &lines) {
    QString text;
    for (const LawLine &line : lines)
        text += QStringLiteral("<p style='margin: 0 0 4px 0'><b>%1</b>&ensp;%2</p>")
                    .arg(line.label.toHtmlEscaped(), withLinks(line.text.toHtmlEscaped()));
    return text;
}

} // namespace

/// A filter that hides the kinds of rows that are switched off.
class BounceFilter : public QSortFilterProxyModel {
public:
    BounceFilter(const BounceTableModel &events, QObject *parent)
        : QSortFilterProxyModel(parent)
        , m_events(events) {}

    void setShown(bool slow, bool others) {
        m_slow = slow;
        m_others = others;
        invalidateFilter();
    }
    bool shows(const LoggedEvent &event) const {
        if (!event.isBounce()) return m_others;
        return m_slow || !event.isSlow();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex &) const override { return shows(m_events.events()[size_t(row)]); }

private:
    const BounceTableModel &m_events;
    bool m_slow = true;
    bool m_others = true;
};

BounceDock::BounceDock(Session &session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_events(new BounceTableModel(session.simulation().events(), session.registry(), this))
    , m_filter(new BounceFilter(*m_events, this))
    , m_slow(addFilter(tr("Slow impacts"), "bounces_slow",
                       tr("Impacts below %1 m/s; those in a row on one box are one line").arg(kCountedImpact)))
    , m_others(addFilter(tr("Other events"), "bounces_others", tr("Take-off, stop, rolling again, contact, release")))
    , m_count(new ElidedLabel)
    , m_table(new QTableView)
    , m_area(new QScrollArea)
    , m_detail(new QLabel) {
    setObjectName(QStringLiteral("bounces"));
    m_count->setObjectName(QStringLiteral("bounces_count"));
    m_detail->setObjectName(QStringLiteral("bounces_detail"));
    m_detail->setTextFormat(Qt::RichText);
    m_detail->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse |
                                      Qt::LinksAccessibleByKeyboard);
    m_detail->setToolTip(tr("A link opens that section of the model's page"));
    connect(m_detail, &QLabel::linkActivated, this, &BounceDock::sectionWanted);
    m_detail->setWordWrap(true);
    m_detail->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_detail->setContentsMargins(8, 2, 4, 2);
    makeTable();

    m_area->setWidget(m_detail);
    m_area->setWidgetResizable(true);
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setFocusPolicy(Qt::TabFocus);
    m_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // the text wraps
    m_area->setAccessibleName(tr("The bounce and its law"));
    m_area->setMinimumWidth(fontMetrics().averageCharWidth() * 24);
    m_area->installEventFilter(this);
    auto *halves = new TurningSplitter(kNarrow, {400, 600}, {600, 400}); // per mille
    halves->addWidget(m_table);
    halves->addWidget(m_area);
    auto *top = new QHBoxLayout;
    top->addWidget(m_slow);
    top->addWidget(m_others);
    top->addWidget(m_count, 1);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 6);
    layout->addLayout(top);
    layout->addWidget(halves, 1);
    setFocusProxy(m_table);
    applyFilter();
    showSelected();
    showCount();
}

/// A check box that shows or hides a kind of rows, remembered in the settings.
QCheckBox *BounceDock::addFilter(const QString &text, const char *name, const QString &tip) {
    auto *box = new QCheckBox(text);
    box->setObjectName(QLatin1String(name));
    box->setToolTip(tip);
    box->setFocusPolicy(Qt::TabFocus);
    const QString key = settings_keys::kBounces + QLatin1String(name);
    box->setChecked(m_session.settings().value(key, true).toBool());
    connect(box, &QCheckBox::toggled, this, [this, key](bool isOn) {
        m_session.settings().setValue(key, isOn);
        applyFilter();
    });
    return box;
}

void BounceDock::makeTable() {
    m_table->setObjectName(QStringLiteral("bounces_table"));
    m_table->setAccessibleName(tr("Bounces"));
    m_filter->setSourceModel(m_events);
    m_table->setModel(m_filter);
    new EmptyText(*m_table, tr("None yet"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setAlternatingRowColors(true);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->installEventFilter(this);
    QHeaderView *header = m_table->horizontalHeader();
    header->setHighlightSections(false);
    header->setStretchLastSection(true);
    m_table->verticalHeader()->hide();
    fitTable();
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &BounceDock::showSelected);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &BounceDock::showSelected);
}

void BounceDock::fitTable() {
    // As wide as the longest expected text, so that columns keep their widths while rows arrive.
    const QStringList widest{QStringLiteral("000.0000"), {}, QStringLiteral("000")};
    for (int column = 0; column < m_events->columnCount(); ++column) {
        const QString title = m_events->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const QString text = widest.value(column, QStringLiteral("00.0000"));
        m_table->horizontalHeader()->resizeSection(
            column, std::max(fontMetrics().horizontalAdvance(title), fontMetrics().horizontalAdvance(text)) + 16);
    }
    fitWhat();
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
}

void BounceDock::changeEvent(QEvent *event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitTable();
}

/// Gives way to the figures where the dock is narrow; a tool tip has the whole text.
void BounceDock::fitWhat() {
    QHeaderView *header = m_table->horizontalHeader();
    const int figures = header->length() - header->sectionSize(BounceTableModel::kWhat) -
                        header->sectionSize(m_events->columnCount() - 1); // without the stepper
    const int widest = fontMetrics().horizontalAdvance(tr("Leaning: 0.00 s, 000 impacts")) + 16;
    const int least = fontMetrics().horizontalAdvance(tr("Impact")) + 16;
    header->resizeSection(BounceTableModel::kWhat, std::clamp(m_table->viewport()->width() - figures, least, widest));
}

/// Keeps the newest row visible, unless the user has scrolled away.
void BounceDock::refresh() {
    const QScrollBar *bar = m_table->verticalScrollBar();
    const bool follows = bar->value() == bar->maximum() && !m_table->selectionModel()->hasSelection();
    const std::optional<LoggedEvent> before = selected();
    if (!m_events->refresh()) return;
    if (before && !selected()) m_awaited = before;
    selectAwaited();
    if (follows) m_table->scrollToBottom();
    showCount();
    showSelected(); // an entry of slow impacts may have grown
}

/// When a run is repeated, for instance by seeking in a recording, it has the same events.
void BounceDock::selectAwaited() {
    if (!m_awaited) return;
    const phys_event &awaited = m_awaited->event;
    for (const LoggedEvent &event : m_events->events())
        if (event.event.time == awaited.time && event.event.kind == awaited.kind && event.event.box == awaited.box)
            return select(event.number);
}

void BounceDock::applyFilter() { m_filter->setShown(m_slow->isChecked(), m_others->isChecked()); }

void BounceDock::showCount() {
    const EventLog &log = m_session.simulation().events();
    QStringList parts{tr("%n events", nullptr, int(m_events->events().size()))};
    if (log.dropped() > 0) parts += tr("the last %1 are kept").arg(log.capacity());
    if (log.lost() > 0)
        parts += tr("%1 events lost: more than %2 in one step").arg(log.lost()).arg(Engine::kEventCapacity);
    m_count->setText(parts.join(QStringLiteral("; ")));
}

std::optional<LoggedEvent> BounceDock::selected() const {
    const QModelIndex current = m_table->currentIndex();
    if (!current.isValid() || !m_table->selectionModel()->isRowSelected(current.row(), {})) return std::nullopt;
    return m_events->events()[size_t(m_filter->mapToSource(current).row())];
}

void BounceDock::select(uint64_t number) {
    const int row = m_events->rowOf(number);
    if (row < 0) return;
    const LoggedEvent &event = m_events->events()[size_t(row)];
    if (!m_filter->shows(event)) (event.isBounce() ? m_slow : m_others)->setChecked(true);
    const QModelIndex index = m_filter->mapFromSource(m_events->index(row, 0));
    // By the model: the table's own functions toggle rows while Ctrl is held, as in a jump from bounce to bounce.
    m_table->selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    m_table->scrollTo(index);
}

void BounceDock::selectAt(double time) {
    for (const LoggedEvent &event : m_events->events())
        if (event.isBounce() && !event.isSlow() && event.event.time == time) return select(event.number);
}

void BounceDock::clearSelection() {
    m_awaited.reset();
    m_table->clearSelection();
    m_table->setCurrentIndex({});
}

void BounceDock::showSelected() {
    const std::optional<LoggedEvent> event = selected();
    if (event) m_awaited.reset();
    showDetail(event);
    findMarks();
    emit changed();
}

void BounceDock::showDetail(const std::optional<LoggedEvent> &event) {
    const bool isNarrow = m_area->width() < fontMetrics().averageCharWidth() * 60;
    const std::vector<LawLine> lines =
        event ? eventLines(*event, m_session.scene().get(), m_session.registry()) : std::vector<LawLine>();
    const QString text =
        event ? (isNarrow ? paragraphs(lines) : columns(lines))
              : tr("Click a bounce in the list or in the view: when, where, how fast, and the law that it obeys.");
    if (text == m_detail->text()) return;
    m_detail->setText(text);
    m_detail->setFocusPolicy(text.contains(QLatin1String("<a ")) ? Qt::StrongFocus : Qt::ClickFocus);
}

void BounceDock::findMarks() {
    m_marks = {{}, selected()};
    const std::deque<LoggedEvent> &events = m_events->events();
    for (auto event = events.rbegin(); event != events.rend() && m_marks.recent.size() < kMarks; ++event)
        if (event->isBounce() && !event->isSlow()) m_marks.recent.push_back(*event);
    std::reverse(m_marks.recent.begin(), m_marks.recent.end());
}

std::vector<double> BounceDock::bounceTimes() const {
    std::vector<double> times;
    for (const LoggedEvent &event : m_events->events())
        if (event.isBounce() && !event.isSlow()) times.push_back(event.event.time);
    return times;
}

/// While the table has the focus it handles Ctrl+C, and Esc if something is selected.
bool BounceDock::eventFilter(QObject *object, QEvent *event) {
    if (object == m_area && event->type() == QEvent::Resize) showDetail(selected());
    if (object == m_table && event->type() == QEvent::Resize) fitWhat();
    const bool isOffer = event->type() == QEvent::ShortcutOverride;
    if (object != m_table || (!isOffer && event->type() != QEvent::KeyPress)) return false;
    auto *key = static_cast<QKeyEvent *>(event);
    const bool hasSelection = m_table->selectionModel()->hasSelection();
    const bool isCopy = key->matches(QKeySequence::Copy);
    if (!hasSelection || !(isCopy || key->key() == Qt::Key_Escape)) return false;
    if (!isOffer) isCopy ? copy() : clearSelection();
    event->accept();
    return true;
}

/// Copies the selected rows both as tab-separated text and as CSV.
void BounceDock::copy() const {
    QModelIndexList rows = m_table->selectionModel()->selectedRows();
    std::sort(rows.begin(), rows.end());
    std::vector<LoggedEvent> events;
    for (const QModelIndex &row : rows) events.push_back(m_events->events()[size_t(m_filter->mapToSource(row).row())]);
    auto *copied = new QMimeData;
    copied->setText(QString::fromUtf8(eventCsv(events, m_session.registry(), '\t')));
    copied->setData(QStringLiteral("text/csv"), eventCsv(events, m_session.registry(), ','));
    QGuiApplication::clipboard()->setMimeData(copied);
}

} // namespace inspector::ui
