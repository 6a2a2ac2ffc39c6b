// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_scroll.h"

#include "ui/plots/plot_stack.h"

#include <QScrollBar>
#include <QTimer>

namespace inspector::ui {

PlotScroll::PlotScroll(PlotStack &plots)
    : m_plots(plots) {
    setObjectName(QStringLiteral("plot_scroll"));
    setWidget(&plots);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const auto show = [this](QWidget *plot) {
        QTimer::singleShot(0, plot, [this, plot] { ensureWidgetVisible(plot); }); // once it is laid out
    };
    connect(&plots, &PlotStack::added, this, show);
}

QSize PlotScroll::minimumSizeHint() const {
    constexpr int kLines = 5; // of text
    return {m_plots.minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
            kLines * fontMetrics().height()};
}

} // namespace inspector::ui
