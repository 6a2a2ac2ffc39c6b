// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/numbers.h"

#include <QLineEdit>

#include <functional>

class QLabel;

namespace inspector::ui {

class AlarmText;

/// A field for one number, in any form that core/setup/numbers.h reads. Enter, or leaving the field, commits the input.
/// Invalid input stays as typed, marked and with the reason below, and isn't committed; Esc discards it, and so does a
/// new value. If nothing was typed, Enter and Esc are the dialog's. Up, Down and the wheel change the number by a
/// notch, with Shift by a tenth of one.
class NumberBox : public QLineEdit {
    Q_OBJECT

public:
    /// How a field parses and formats.
    struct Kind {
        std::function<NumberReading(const QString &text)> read;
        std::function<QString(double value)> show;
        double notch = 0.0;                         ///< 0: no stepping
        QString widest;                             ///< the longest common text
        std::function<QString(double value)> exact; ///< text shown while it has the keyboard; empty: the usual one
        QString hint;                               ///< shown below while the user types; empty: nothing
        QString range;                              ///< told by the tool tip; empty: not at all
    };

    explicit NumberBox(QWidget *parent = nullptr);

    void setKind(Kind kind);
    double value() const { return m_value; }
    /// Shows the value, unless the user is typing; a new value replaces invalid input. A selection is kept while the
    /// text is the same.
    void setValue(double value);
    /// Shows the value instead of what was typed.
    void takeBack();
    /// Marks the committed input as invalid; reason: one line.
    void refuse(const QString &reason);
    void enter(); ///< commits what was typed, like Enter
    bool isRefused() const { return !m_reason.isEmpty(); }
    const QString &reason() const { return m_reason; }
    /// The value with all its digits.
    QString exactText() const { return m_kind.exact ? m_kind.exact(m_value) : m_kind.show(m_value); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// The user has committed another number. Receivers may refuse() it or set it.
    void entered(double value);

protected:
    void changeEvent(QEvent *event) override;
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void showFromStart(const QString &shown);
    QString valueText() const;
    QString fullTip() const;
    void apply();
    void stepBy(double notches);
    void accept();
    void showNote(const QString &text, const QColor &colour);

    AlarmText *m_alarm; ///< on while refused
    Kind m_kind;
    double m_value = 0.0;
    QString m_reason;
    struct {
        QString tip, description;
    } m_usual;                // replaced while a reason is shown
    QLabel *m_note = nullptr; ///< the reason or the hint, while the field has the focus; owned by the window
};

/// A number in this range, shown with at least as many decimals as a notch has.
NumberBox::Kind numberKind(const NumberRange &range, double notch);
/// An integer from min to max.
NumberBox::Kind wholeNumberKind(int min, int max);
/// A time in seconds, as is input without a unit.
NumberBox::Kind durationKind(double min, double max);

} // namespace inspector::ui
