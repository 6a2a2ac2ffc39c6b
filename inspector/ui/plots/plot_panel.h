// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QToolBar;

namespace inspector::ui {

class TimePlot;

// A plot with its buttons.
class PlotPanel : public QWidget {
    Q_OBJECT

public:
    // The panel owns the plot. The buttons' names begin with `prefix`.
    PlotPanel(TimePlot *plot, const QString &prefix, QWidget *parent = nullptr);

    TimePlot &plot() { return *m_plot; }
    QSize sizeHint() const override { return {700, 220}; }

signals:
    void saveWanted();

private:
    TimePlot *m_plot;
};

} // namespace inspector::ui
