// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/track/track_fit.h"

#include <qcustomplot.h>

namespace inspector::ui {

/// The residuals of a fit over time: measured minus computed, mm, with the tracker's noise as a band and bounces as
/// marks.
class ResidualPlot : public QCustomPlot {
    Q_OBJECT

public:
    explicit ResidualPlot(QWidget *parent = nullptr);

    void show(const ModelFit &fit, double noise); ///< m
    void clear();

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QCPGraph *m_x;
    QCPGraph *m_y;
    QCPGraph *m_bounces;
    QCPItemRect *m_noise; ///< +-2 standard deviations
};

} // namespace inspector::ui
