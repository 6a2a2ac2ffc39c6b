// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace inspector::ui {

class AlarmText;

/// A line of text that may be refused: it is then shown as it was typed, in the colour of an alarm. Esc takes back what
/// was typed, to the last text that wasn't refused.
class TextBox : public QLineEdit {
    Q_OBJECT

public:
    explicit TextBox(const QString &text = {}, QWidget *parent = nullptr);

    void setRefused(bool isRefused);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    AlarmText *m_alarm;
    QString m_before; ///< what Esc returns to
    bool m_isRefused = false;
};

} // namespace inspector::ui
