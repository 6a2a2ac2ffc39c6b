// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/sample_ring.h"
#include "ui/plots/phase_plot.h"
#include "ui/plots/quantity_plot.h"

#include <QSplitter>

#include <memory>
#include <vector>

class QMenu;
class QSettings;

namespace inspector::ui {

/// Any number of stacked plots with a common time axis. Their quantities are chosen in context menus or by dropping
/// them onto a plot, and are remembered.
class PlotStack : public QSplitter {
    Q_OBJECT

public:
    /// Both must outlive the stack.
    PlotStack(const SampleRing &samples, QSettings &settings, QWidget *parent = nullptr);

    TimeView &time() { return *m_time; }
    QuantityPlot &first() { return *m_plots.front(); } ///< there is always at least one

    /// Shows new samples; called about 30 times a second.
    void refresh(const RunContext &context);
    void showBounces(const std::vector<double> &times, std::optional<double> selected);
    void setFollowing(bool isOn);
    void setPaused(bool isOn);
    void clear();
    /// Resets to the initial plot: the velocity.
    void reset();

    QuantityPlot *addPlot(const PlotContent &content);
    PhasePlot *addPhasePlot(Channel x, Channel y);
    void removePlot(QWidget *plot); ///< except for the last time plot
    bool isSeen() const;            ///< not behind another dock
    /// Fills one plot's context menu.
    void fillMenu(QMenu &menu, QWidget *plot);

    /// Like TimePlot::save(), with all plots in one picture or document; the lowest is made high enough for its label.
    bool save(const QString &path, QString *error);

signals:
    void bounceClicked(double time); ///< s
    void added(QWidget *plot);       ///< by the user

private:
    /// Doesn't store the change in the settings.
    QuantityPlot *makePlot(const PlotContent &content);
    PhasePlot *makePhasePlot(Channel x, Channel y);
    void shareHeight(QList<int> heights);
    void tellPlaces();
    QList<QCustomPlot *> shown() const;
    void drawAll();
    void offerMenu(QWidget *plot);
    void restore();
    void remember();

    const SampleRing &m_samples;
    QSettings &m_settings;
    std::shared_ptr<TimeView> m_time;
    std::vector<QuantityPlot *> m_plots; ///< from top to bottom
    std::vector<PhasePlot *> m_phasePlots;
    std::vector<double> m_bounces;
    std::optional<double> m_selected;
};

} // namespace inspector::ui
