// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/number_box.h"

#include "core/setup/numbers.h"
#include "ui/parts/theme.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace inspector::ui {

namespace {

constexpr int kMostDigits = 9;
constexpr int kShownDigits = 6;     ///< significant
constexpr double kRounding = 1e-12; ///< share of a value: smaller differences are rounding, not edits
constexpr double kFine = 0.1;       ///< share of a notch, with Shift
constexpr double kPage = 10.0;
constexpr int kNoteWidth = 320; ///< logical pixels

/// Decimals that `number` needs, at most kMostDigits.
int digitsOf(double number) {
    const QByteArray text = QByteArray::number(number, 'f', kMostDigits);
    qsizetype end = text.size();
    while (text[end - 1] == '0') --end;
    return int(end - 1 - text.indexOf('.'));
}

/// Formats with a notch's decimals if they represent the number exactly, otherwise with that many significant digits.
QString numberText(double value, double notch, int digits) {
    const QString text = QString::number(value, 'f', digitsOf(notch));
    const bool isWhole = std::abs(text.toDouble() - value) <= kRounding * std::abs(value);
    return isWhole ? text : QString::number(value, 'g', digits);
}

QString rangeText(const QString &from, const QString &to) { return NumberBox::tr("From %1 to %2").arg(from, to); }

double notchesOf(const QKeyEvent &event) {
    const double size = event.modifiers() & Qt::ShiftModifier ? kFine : 1.0;
    switch (event.key()) {
    case Qt::Key_Up:
        return size;
    case Qt::Key_Down:
        return -size;
    case Qt::Key_PageUp:
        return kPage * size;
    case Qt::Key_PageDown:
        return -kPage * size;
    default:
        return 0.0;
    }
}

} // namespace

NumberBox::NumberBox(QWidget *parent)
    : QLineEdit(parent)
    , m_alarm(new AlarmText(*this, QPalette::Text)) {
    setAlignment(Qt::AlignRight);
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QLineEdit::textEdited, this, [this] {
        accept(); // validated again when entered
        if (!m_kind.hint.isEmpty()) showNote(m_kind.hint, palette().color(QPalette::ToolTipBase));
    });
}

void NumberBox::setKind(Kind kind) {
    m_kind = std::move(kind);
    updateGeometry();
}

void NumberBox::setValue(double value) {
    const bool isNew = value != std::exchange(m_value, value);
    if (isRefused() && isNew) return takeBack();
    if (isModified() || isRefused()) return;
    if (const QString shown = valueText(); shown != text()) showFromStart(shown);
}

QString NumberBox::valueText() const {
    return hasFocus() && m_kind.exact ? m_kind.exact(m_value) : m_kind.show(m_value);
}

/// Scrolls to the first digits: the last digits alone would be read as another number. A selected number stays so: what
/// is typed next takes its place.
void NumberBox::showFromStart(const QString &shown) {
    const bool isSelected = !text().isEmpty() && selectedText() == text();
    setText(shown);
    isSelected ? setSelection(int(shown.size()), -int(shown.size())) : home(false);
}

void NumberBox::apply() {
    if (!isModified()) return;
    if (m_note) m_note->hide();
    const NumberReading reading = m_kind.read(text());
    if (!reading.value) return refuse(reading.problem);
    setModified(false);
    const QString typed = text();
    if (*reading.value != m_value) emit entered(*reading.value);
    isRefused() ? setText(typed) : showFromStart(valueText());
    setModified(isRefused());
}

void NumberBox::refuse(const QString &reason) {
    if (m_reason.isEmpty()) m_usual = {toolTip(), accessibleDescription()};
    m_reason = reason;
    setModified(true);
    m_alarm->setOn(true);
    setToolTip(reason);
    setAccessibleDescription(reason);
    if (hasFocus()) showNote(reason, accentsFor(window()->palette()).warning);
}

/// Validates again, as the text may have become valid.
void NumberBox::accept() {
    if (m_note) m_note->hide();
    if (m_reason.isEmpty()) return;
    m_reason.clear();
    m_alarm->setOn(false);
    setToolTip(m_usual.tip);
    setAccessibleDescription(m_usual.description);
}

void NumberBox::enter() {
    apply();
    emit editingFinished();
}

void NumberBox::takeBack() {
    accept();
    showFromStart(valueText());
}

void NumberBox::stepBy(double notches) {
    if (m_kind.notch <= 0.0) return;
    apply();
    if (isRefused()) return;
    // Snaps to multiples of the finest notch, so that steps back and forth cancel.
    const double finest = kFine * m_kind.notch;
    const double stepped = std::round((m_value + notches * m_kind.notch) / finest) * finest;
    const QString text = QString::number(stepped, 'g', 12);
    const NumberReading reading = m_kind.read(text);
    if (!reading.value || *reading.value == m_value) return;
    emit entered(*reading.value);
    if (!isRefused()) showFromStart(valueText());
}

/// Below the field.
void NumberBox::showNote(const QString &text, const QColor &colour) {
    if (!m_note) {
        m_note = new QLabel(window());
        m_note->setObjectName(objectName() + QStringLiteral("_note"));
        m_note->setWordWrap(true);
        m_note->setTextFormat(Qt::PlainText);
        m_note->setMargin(5);
        m_note->setFrameShape(QFrame::StyledPanel);
        m_note->setAutoFillBackground(true);
        m_note->setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    QPalette plate = window()->palette();
    plate.setColor(QPalette::Window, colour);
    m_note->setPalette(plate);
    m_note->setText(text);
    const int width = std::min(kNoteWidth, window()->width());
    m_note->resize(width, m_note->heightForWidth(width));
    const QPoint below = mapTo(window(), rect().bottomRight()) + QPoint(0, 2);
    m_note->move(std::max(0, below.x() - width), std::min(below.y(), window()->height() - m_note->height()));
    m_note->show();
    m_note->raise();
}

QString NumberBox::fullTip() const {
    QStringList lines{toolTip(), isRefused() ? QString() : m_kind.range}; // a reason has the range
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

/// While the user is typing, the undo keys apply to the field's text; without any of it they are the window's.
bool NumberBox::event(QEvent *event) {
    if (event->type() == QEvent::ToolTip) {
        QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), fullTip(), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool isUndo = key->matches(QKeySequence::Undo);
        const bool hasText = isModified() && (isUndo ? isUndoAvailable() : isRedoAvailable());
        if (!hasText && (isUndo || key->matches(QKeySequence::Redo))) {
            event->ignore();
            return false;
        }
    }
    return QLineEdit::event(event);
}

void NumberBox::keyPressEvent(QKeyEvent *event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter || event->key() == Qt::Key_Escape) {
        event->setAccepted(isModified()); // otherwise the key is the dialog's
        isEnter ? enter() : takeBack();
        return;
    }
    if (const double notches = notchesOf(*event); notches != 0.0 && m_kind.notch > 0.0) return stepBy(notches);
    QLineEdit::keyPressEvent(event);
}

void NumberBox::wheelEvent(QWheelEvent *event) {
    if (!hasFocus() || m_kind.notch <= 0.0) return event->ignore();
    const QPoint turned = event->angleDelta();
    stepBy((turned.y() != 0 ? turned.y() : turned.x()) / 120.0 *
           (event->modifiers() & Qt::ShiftModifier ? kFine : 1.0));
    event->accept();
}

/// The note has the colours of the theme before.
void NumberBox::changeEvent(QEvent *event) {
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_note) m_note->hide();
}

/// Called before the text is selected.
void NumberBox::focusInEvent(QFocusEvent *event) {
    setValue(m_value);
    QLineEdit::focusInEvent(event);
}

void NumberBox::focusOutEvent(QFocusEvent *event) {
    apply();
    if (m_note) m_note->hide();
    QLineEdit::focusOutEvent(event);
    if (hasSelectedText()) return; // a menu's selection is kept
    setValue(m_value);
    home(false);
}

void NumberBox::hideEvent(QHideEvent *event) {
    if (m_note) m_note->hide();
    QLineEdit::hideEvent(event);
}

/// Wide enough for common values, not for the largest possible.
QSize NumberBox::sizeHint() const {
    QStyleOptionFrame option;
    initStyleOption(&option);
    const int height = QLineEdit::sizeHint().height();
    return {fontMetrics().horizontalAdvance(m_kind.widest) + 2 * option.lineWidth + 14, height};
}

NumberBox::Kind numberKind(const NumberRange &range, double notch) {
    const QString unit = range.unit.isEmpty() ? QString() : QLatin1Char(' ') + printedUnit(range.unit);
    const auto text = [unit, notch](int digits) {
        return [unit, notch, digits](double value) { return numberText(value, notch, digits) + unit; };
    };
    return {[range](const QString &typed) { return readNumber(typed, range); },
            text(kShownDigits),
            notch,
            QStringLiteral("-00.0000") + unit,
            text(QLocale::FloatingPointShortest),
            {},
            rangeText(QString::number(range.min), QString::number(range.max) + unit)};
}

NumberBox::Kind wholeNumberKind(int min, int max) {
    const NumberRange range{double(min), double(max)};
    return {[range](const QString &text) { return readWholeNumber(text, range); },
            [](double value) { return QString::number(value, 'f', 0); },
            1.0,
            QString::number(max),
            {},
            {},
            rangeText(QString::number(min), QString::number(max))};
}

NumberBox::Kind durationKind(double min, double max) {
    return {[min, max](const QString &text) { return readDuration(text, min, max); },
            durationText,
            0.0,
            QStringLiteral("0.0166667 ms"),
            {},
            NumberBox::tr("In s, or with a unit: 5 ms"),
            rangeText(durationText(min), durationText(max))};
}

} // namespace inspector::ui
