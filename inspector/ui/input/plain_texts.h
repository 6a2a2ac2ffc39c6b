// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace inspector::ui {

/// Shows the texts of labels, message boxes and tool tips as they are: names of files, levels and plugins may contain
/// what Qt would take for markup. A label of markup says so by its format.
class PlainTexts : public QObject {
    Q_OBJECT

public:
    explicit PlainTexts(QWidget &window);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
};

} // namespace inspector::ui
