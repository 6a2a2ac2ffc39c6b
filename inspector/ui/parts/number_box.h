// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace inspector::ui {

// A spin box that shows as many digits as a notch has, and more where the value has more; it never rounds what was
// typed. A value counts when Enter is pressed or the box is left.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget *parent = nullptr);

    void setRow(double minimum, double maximum, double notch);

    QString textFromValue(double value) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    bool event(QEvent *event) override;

private:
    bool isBeingTyped() const;

    int m_digits = 0; // after the point, of a notch
};

} // namespace inspector::ui
