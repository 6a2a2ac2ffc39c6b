// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/track/fit_table.h"

#include "core/setup/numbers.h"
#include "core/track/fit_report.h"
#include "ui/parts/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStyle>

#include <algorithm>

namespace inspector::ui {

namespace {

constexpr int kReason = Qt::UserRole; ///< why the input is refused; empty if it isn't

/// Whether the quantity's initial value is typed here: the parameters have no offset of the tilt, and nothing about
/// tracks.
bool isTyped(const FitQuantity &quantity) {
    return quantity.id.startsWith(QLatin1String("tilt")) || quantity.id.startsWith(QLatin1String("frame")) ||
           quantity.id == QLatin1String("delay");
}

} // namespace

FitTable::FitTable(QWidget *parent)
    : QTableWidget(parent)
    , m_quantities(fitQuantities()) {
    setObjectName(QStringLiteral("track_quantities"));
    setAccessibleName(tr("What the fit looks for"));
    setColumnCount(kColumnCount);
    setRowCount(int(m_quantities.size()));
    setHorizontalHeaderLabels({tr("Look for"), tr("From"), tr("Found ± 95 %"), tr("Unit")});
    setSelectionMode(QAbstractItemView::NoSelection);
    setTabKeyNavigation(false); // Tab moves on to the next widget
    for (int row = 0; row < rowCount(); ++row) {
        const FitQuantity &quantity = m_quantities[size_t(row)];
        auto *name = new QTableWidgetItem(quantity.label);
        name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
        name->setCheckState(Qt::Unchecked);
        name->setToolTip(quantity.isRigidOnly ? tr("%1; has no effect in the rolling model").arg(quantity.id)
                                              : quantity.id);
        setItem(row, Name, name);
        auto *begin = new QTableWidgetItem;
        begin->setFlags(isTyped(quantity) ? Qt::ItemIsEnabled | Qt::ItemIsEditable : Qt::NoItemFlags);
        setItem(row, Begin, begin);
        showReason(*begin, {});
        for (const Column column : {Found, Unit}) {
            auto *item = new QTableWidgetItem(column == Unit ? printedUnit(quantity.unit) : QString());
            item->setFlags(Qt::ItemIsEnabled);
            setItem(row, column, item);
        }
    }
    want(usualFitQuantities());
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents); // a reason may need two lines
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(Found, QHeaderView::Fixed);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setTextElideMode(Qt::ElideRight);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter); // a centred title is cut on both sides
    connect(horizontalHeader(), &QHeaderView::sectionResized, this, &FitTable::fitFound);
    connect(this, &QTableWidget::itemChanged, this, &FitTable::read);
}

std::vector<FitQuantity> FitTable::wanted() const {
    std::vector<FitQuantity> result;
    for (int row = 0; row < rowCount(); ++row)
        if (item(row, Name)->checkState() == Qt::Checked) result.push_back(m_quantities[size_t(row)]);
    return result;
}

QString FitTable::words() const {
    QStringList ids;
    for (const FitQuantity &quantity : wanted()) ids += quantity.id;
    return ids.join(QLatin1Char(','));
}

void FitTable::want(const QString &words) {
    QString error;
    const std::optional<std::vector<FitQuantity>> chosen = parseFitQuantities(words, &error);
    if (!chosen) return;
    const QSignalBlocker silent(this);
    for (int row = 0; row < rowCount(); ++row) {
        const auto isIt = [&](const FitQuantity &one) { return one.id == m_quantities[size_t(row)].id; };
        const bool isChosen = std::any_of(chosen->begin(), chosen->end(), isIt);
        item(row, Name)->setCheckState(isChosen ? Qt::Checked : Qt::Unchecked);
    }
}

BoardParameters FitTable::begin(const Inputs &inputs) const {
    BoardParameters board = m_typed;
    board.params = inputs.params;
    board.gravity = inputs.gravity;
    return board;
}

void FitTable::showBegin(const Inputs &inputs) {
    BoardParameters board = begin(inputs);
    const QSignalBlocker silent(this);
    for (int row = 0; row < rowCount(); ++row) {
        const FitQuantity &quantity = m_quantities[size_t(row)];
        if (!reasonOf(row).isEmpty()) continue;
        item(row, Begin)->setText(QString::number(quantity.of(board) / quantity.perUnit, 'g', 6));
    }
}

/// Refused input stays as it was typed, in red; the previous value stays in use.
void FitTable::read(QTableWidgetItem *item) {
    if (item->column() == Name) emit wantedChanged();
    if (item->column() != Begin) return;
    const FitQuantity &quantity = m_quantities[size_t(item->row())];
    const NumberRange range{quantity.lower / quantity.perUnit, quantity.upper / quantity.perUnit, quantity.unit};
    double &number = quantity.of(m_typed);
    const NumberReading reading = readNumber(item->text(), range);
    QSignalBlocker silent(this);
    showReason(*item, reading.problem);
    if (!reading.value) return;
    number = *reading.value * quantity.perUnit;
    item->setText(QString::number(number / quantity.perUnit, 'g', 6));
    silent.unblock();
    emit typed();
}

/// reason: empty if the value is accepted.
void FitTable::showReason(QTableWidgetItem &begin, const QString &reason) {
    const bool isOfTheParameters = !(begin.flags() & Qt::ItemIsEditable);
    const QString usual = isOfTheParameters
                              ? tr("As the parameters have it")
                              : tr("Where the fit begins, or what it takes for true if it isn't looked for");
    begin.setData(kReason, reason);
    begin.setToolTip(reason.isEmpty() ? usual : reason);
    begin.setForeground(reason.isEmpty() ? QBrush() : QBrush(accentsFor(palette()).alarm));
}

QString FitTable::othersOf(const FitPlan &plan) const {
    BoardParameters assumed = plan.begin;
    BoardParameters now = m_typed;
    QStringList others;
    for (const FitQuantity &quantity : m_quantities) {
        const bool isFitted = std::ranges::count(plan.quantities, quantity.id, &FitQuantity::id) > 0;
        if (isFitted || !isTyped(quantity) || quantity.of(assumed) == quantity.of(now)) continue;
        const double value = quantity.of(assumed) / quantity.perUnit;
        others += QStringLiteral("%1 of %2 %3")
                      .arg(quantity.label)
                      .arg(value, 0, 'g', 6)
                      .arg(printedUnit(quantity.unit))
                      .trimmed();
    }
    return others.join(QStringLiteral(", "));
}

/// Empty if the value is accepted.
QString FitTable::reasonOf(int row) const { return item(row, Begin)->data(kReason).toString(); }

/// The theme may have changed.
void FitTable::changeEvent(QEvent *event) {
    QTableWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange) return;
    const QSignalBlocker silent(this);
    for (int row = 0; row < rowCount(); ++row) showReason(*item(row, Begin), reasonOf(row));
}

QString FitTable::refusal() const {
    for (int row = 0; row < rowCount(); ++row) {
        const QString reason = reasonOf(row);
        if (!reason.isEmpty()) return m_quantities[size_t(row)].id + QStringLiteral(": ") + reason;
    }
    return {};
}

void FitTable::showFound(const ModelFit &fit) {
    forgetFound();
    const QSignalBlocker silent(this);
    for (int row = 0; row < rowCount(); ++row)
        for (const FittedValue &value : fit.values)
            if (value.quantity.id == m_quantities[size_t(row)].id) {
                const QString text = numbersText(value);
                item(row, Found)->setText(text);
                item(row, Found)->setToolTip(text);
                if (value.isDetermined())
                    m_numbersWidth = std::max(m_numbersWidth, fontMetrics().horizontalAdvance(text));
            }
    fitFound();
}

/// What was found has the room that the other columns leave. Numbers have a line of their own however narrow the table
/// is; the words of a reason may take several.
void FitTable::fitFound() {
    int others = 0;
    for (const Column column : {Name, Begin, Unit}) others += columnWidth(column);
    const int margin = 2 * (style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, this) + 2);
    const int least = std::max(m_numbersWidth + margin, horizontalHeader()->sectionSizeHint(Found));
    setColumnWidth(Found, std::max(least, viewport()->width() - others));
}

void FitTable::resizeEvent(QResizeEvent *event) {
    QTableWidget::resizeEvent(event);
    fitFound();
}

void FitTable::forgetFound() {
    const QSignalBlocker silent(this);
    m_numbersWidth = 0;
    for (int row = 0; row < rowCount(); ++row) {
        item(row, Found)->setText({});
        item(row, Found)->setToolTip({});
    }
}

} // namespace inspector::ui
