// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace inspector::ui {

/// One line of text, elided to the available width. The tool tip shows the full text above any other tip.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget *parent = nullptr);

    /// Reserves the width of this text if there is room, so that changes of the text don't move its neighbours.
    void setWidest(const QString &text);

    void setLeast(int characters); ///< that are shown where there is little room

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    QString shown() const;

    int m_widest = 0; ///< px
    int m_least = 8;  ///< average characters
};

} // namespace inspector::ui
