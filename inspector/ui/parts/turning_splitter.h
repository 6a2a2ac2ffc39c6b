// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSplitter>

namespace inspector::ui {

/// Its parts are beside each other where it is wide enough for them, and above each other elsewhere.
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
