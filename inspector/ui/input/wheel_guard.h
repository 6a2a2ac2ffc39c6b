// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace inspector::ui {

/// Prevents scrolling from changing the widget under the cursor: the wheel changes a slider, number or list only while
/// it has the focus; otherwise it scrolls the container.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    explicit WheelGuard(QWidget &window);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
};

} // namespace inspector::ui
