// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace inspector::ui {

// One line as wide as there is room; what doesn't fit is in the tip, above what that says otherwise.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget *parent = nullptr);

    // As wide as this text wherever there is room, and narrower where not: what is shown moves nothing beside it.
    void setWidest(const QString &text);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    QString shown() const;

    int m_widest = 0; // px
};

} // namespace inspector::ui
