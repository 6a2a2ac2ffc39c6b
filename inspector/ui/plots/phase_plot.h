// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/sample_ring.h"
#include "ui/plots/time_view.h"

#include <memory>
#include <optional>

#include <qcustomplot.h>

namespace inspector::ui {

/// One quantity over another, in the time range of the other plots: a path on the board or a phase portrait.
class PhasePlot : public QCustomPlot {
    Q_OBJECT

public:
    /// samples must outlive the plot.
    PhasePlot(const SampleRing &samples, Channel x, Channel y, std::shared_ptr<TimeView> time,
              QWidget *parent = nullptr);

    Channel x() const { return m_x; }
    Channel y() const { return m_y; }
    /// Shows new samples; called about 30 times a second.
    void refresh();
    const QCPCurve &curve() const { return *m_curve; }

protected:
    void changeEvent(QEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void takeColours();
    void fit();
    std::optional<double> timeAt(const QPointF &place) const;
    void updateReadOut();

    const SampleRing &m_samples;
    Channel m_x, m_y;
    std::shared_ptr<TimeView> m_time;
    QCPCurve *m_curve;
    QCPItemTracer *m_dot;
    QCPItemTracer *m_cursorDot; ///< on the curve, at the time of the cursor in any of the plots
    QCPTextElement *m_text;     ///< above the curve
    uint64_t m_shown = 0;
    bool m_isStale = true;
    bool m_fits = true;
};

} // namespace inspector::ui
