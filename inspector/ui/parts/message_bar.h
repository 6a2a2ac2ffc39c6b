// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace inspector::ui {

// A line across the window that says what went wrong, until it is closed. Nothing waits for it.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget *parent = nullptr);

    // The same line again is counted instead of repeated.
    void showLine(const QString &line);
    QString line() const { return m_line; } // empty while hidden
    void dismiss();

signals:
    void changed(const QString &line);

protected:
    void changeEvent(QEvent *event) override;

private:
    void takeColours();

    QLabel *m_icon;
    QLabel *m_text;
    QString m_line;
    int m_count = 0;
};

} // namespace inspector::ui
