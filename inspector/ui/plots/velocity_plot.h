// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/time_plot.h"

namespace inspector::ui {

// The ball's velocity over time: components and magnitude.
class VelocityPlot : public TimePlot {
    Q_OBJECT

public:
    // samples: outlives the plot.
    explicit VelocityPlot(const SampleRing &samples, QWidget *parent = nullptr);

protected:
    void fitValues() override;
    QString textOf(const Sample &sample) const override;
};

} // namespace inspector::ui
