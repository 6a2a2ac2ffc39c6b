// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QSplitter>

#include <utility>

namespace inspector::ui {

/// Places its parts beside each other where it is wide enough for them, otherwise above each other.
class TurningSplitter : public QSplitter {
public:
    /// narrow: below this width, lines of text, they are above each other. wide, tall: shares of the parts then.
    TurningSplitter(int narrow, QList<int> wide, QList<int> tall)
        : m_narrow(narrow)
        , m_wide(std::move(wide))
        , m_tall(std::move(tall)) {
        setChildrenCollapsible(false);
    }

protected:
    void resizeEvent(QResizeEvent *event) override {
        const Qt::Orientation wanted = width() < m_narrow * fontMetrics().height() ? Qt::Vertical : Qt::Horizontal;
        const bool isTurned = !std::exchange(m_isLaidOut, true) || wanted != orientation();
        setOrientation(wanted);
        if (isTurned) setSizes(wanted == Qt::Vertical ? m_tall : m_wide);
        QSplitter::resizeEvent(event);
    }

private:
    int m_narrow;
    QList<int> m_wide, m_tall;
    bool m_isLaidOut = false;
};

} // namespace inspector::ui
