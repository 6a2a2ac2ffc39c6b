// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/numbers.h"

#include <QLineEdit>

#include <functional>

class QLabel;

namespace inspector::ui {

// A field for one number, read as people write numbers (core/setup/numbers.h). It counts when Enter is pressed or the
// field is left. What can't be read, or isn't allowed, stays as it was typed, marked and with the reason below, and
// nothing is entered; Esc takes it back. Up, Down and the wheel change the number by a notch, with Shift by a tenth.
class NumberBox : public QLineEdit {
    Q_OBJECT

public:
    // What a field reads and shows.
    struct Kind {
        std::function<NumberReading(const QString &text)> read;
        std::function<QString(double value)> show;
        double notch = 0.0; // 0: no stepping
        QString widest;     // the longest usual text
    };

    explicit NumberBox(QWidget *parent = nullptr);

    void setKind(Kind kind);
    double value() const { return m_value; }
    // Shows it, unless another text is being typed just now.
    void setValue(double value);
    // What was entered isn't allowed; one line that says why.
    void refuse(const QString &reason);
    bool isRefused() const { return !m_reason.isEmpty(); }
    const QString &reason() const { return m_reason; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    // A person has entered another number. Whoever hears it may refuse() it or set it.
    void entered(double value);

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void apply();
    void takeBack();
    void stepBy(double notches);
    void accept();
    void showReason();

    Kind m_kind;
    double m_value = 0.0;
    QString m_reason;
    struct {
        QString tip, description;
    } m_usual;                // while there is a reason in their place
    QLabel *m_note = nullptr; // the reason, while the field has the keyboard; owned by the window
};

// A number in this range, with at least as many decimals as a notch has.
NumberBox::Kind numberKind(const NumberRange &range, double notch);
// A whole number from min to max.
NumberBox::Kind wholeNumberKind(int min, int max);
// A time in seconds; a number without a unit is in ms.
NumberBox::Kind durationKind(double min, double max);

} // namespace inspector::ui
