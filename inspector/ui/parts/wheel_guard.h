// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace inspector::ui {

/// Scrolling must not change the widget that happens to be under the cursor: the wheel changes a slider, number or list
/// only while it has the focus; otherwise it scrolls their container.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    explicit WheelGuard(QWidget &window);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
};

} // namespace inspector::ui
