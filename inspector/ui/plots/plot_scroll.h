// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace inspector::ui {

class PlotStack;

/// Scrolls stacked plots for which there is no room, instead of enlarging the window.
class PlotScroll : public QScrollArea {
public:
    explicit PlotScroll(PlotStack &plots);
    /// That of a low plot.
    QSize minimumSizeHint() const override;

private:
    PlotStack &m_plots;
};

} // namespace inspector::ui
