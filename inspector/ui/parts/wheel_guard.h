// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace inspector::ui {

// Scrolling must not turn what happens to be under the cursor: in this window the wheel changes the value of a slider,
// number or list only while that has the keyboard; otherwise it scrolls what they lie in.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    explicit WheelGuard(QWidget &window);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
};

} // namespace inspector::ui
