// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSplitter>

namespace inspector::ui {

/// Places its parts beside each other where it is wide enough for them, otherwise above each other.
class TurningSplitter : public QSplitter {
public:
    /// narrow: below this width, logical pixels, they are above each other.
    explicit TurningSplitter(int narrow)
        : m_narrow(narrow) {
        setChildrenCollapsible(false);
    }

protected:
    void resizeEvent(QResizeEvent *event) override {
        setOrientation(width() < m_narrow ? Qt::Vertical : Qt::Horizontal);
        QSplitter::resizeEvent(event);
    }

private:
    int m_narrow;
};

} // namespace inspector::ui
