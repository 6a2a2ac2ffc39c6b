// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QToolBar;

namespace inspector {
class SampleRing;
}

namespace inspector::ui {

class VelocityPlot;

// The plot with its buttons.
class PlotPanel : public QWidget {
    Q_OBJECT

public:
    // samples: outlives the panel.
    explicit PlotPanel(const SampleRing &samples, QWidget *parent = nullptr);

    VelocityPlot &plot() { return *m_plot; }
    QSize sizeHint() const override { return {700, 220}; }

signals:
    void saveWanted();

private:
    VelocityPlot *m_plot;
};

} // namespace inspector::ui
