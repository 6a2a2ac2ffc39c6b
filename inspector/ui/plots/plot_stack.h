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

// Any number of plots above each other, on one time axis. What they show is chosen by their menus (right click) or
// dropped onto them, and remembered.
class PlotStack : public QSplitter {
    Q_OBJECT

public:
    // Both outlive the stack.
    PlotStack(const SampleRing &samples, QSettings &settings, QWidget *parent = nullptr);

    TimeView &time() { return *m_time; }
    QuantityPlot &first() { return *m_plots.front(); } // there is always one
    const std::vector<QuantityPlot *> &plots() const { return m_plots; }
    const std::vector<PhasePlot *> &phasePlots() const { return m_phasePlots; }

    // Shows what is new; called about 30 times a second.
    void refresh(const RunContext &context);
    void showBounces(const std::vector<double> &times, std::optional<double> selected);
    void setFollowing(bool isOn);
    void setPaused(bool isOn);
    void clear();
    // As at first: the velocity.
    void reset();

    QuantityPlot *addPlot(const PlotContent &content);
    PhasePlot *addPhasePlot(Channel x, Channel y);
    void removePlot(QWidget *plot); // but the last over time
    // The menu of one of the plots.
    void fillMenu(QMenu &menu, QWidget *plot);

    // As TimePlot::save(), all of them in one picture.
    bool save(const QString &path, QString *error);

signals:
    void bounceClicked(double time); // s

private:
    // Without being remembered.
    QuantityPlot *makePlot(const PlotContent &content);
    PhasePlot *makePhasePlot(Channel x, Channel y);
    void offerMenu(QWidget *plot);
    void restore();
    void remember();

    const SampleRing &m_samples;
    QSettings &m_settings;
    std::shared_ptr<TimeView> m_time;
    std::vector<QuantityPlot *> m_plots; // from the top
    std::vector<PhasePlot *> m_phasePlots;
    std::vector<double> m_bounces;
    std::optional<double> m_selected;
};

} // namespace inspector::ui
