// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trade/uncertainty_band.h"
#include "ui/plots/time_plot.h"

namespace inspector::ui {

/// The distance of the ball from the ghost over time, on a logarithmic axis: in mm on the left and in radii on the
/// right. Zeros are drawn one decade below everything else, at a tick labelled 0. The board's uncertainty band is
/// behind the curve: where the distance is below it, both balls couldn't be told apart on a real board.
class DistancePlot : public TimePlot {
    Q_OBJECT

public:
    /// samples must outlive the plot.
    explicit DistancePlot(const SampleRing &samples, QWidget *parent = nullptr);

    void setRadius(double radius); ///< of the ball, m
    /// Names for the legend; where they don't fit into one line, it has only "Ball" and "Ghost".
    void setNames(const QString &ball, const QString &ghost);
    void showBand(const std::shared_ptr<const Band> &band); ///< null: none

protected:
    double plotted(double value) const override;
    double drawn(double plotted) const override;
    void loadBesides(const QCPRange &times) override;
    void fitValues() override;
    Columns columns() const override { return Columns::BallAndGhost; }
    QString textOf(const Sample &sample) const override;

private:
    void showRadii();
    void nameKeys();

    double m_radius = 0.006; ///< m
    double m_zero = 0.0;     ///< mm, the position of zeros; 0 if there are none
    QCPGraph *m_ball;        ///< legend entries
    QCPGraph *m_ghost;
    QString m_ballName;
    QString m_ghostName;
    std::shared_ptr<const Band> m_band;
    QCPGraph *m_low; ///< of the band
    QCPGraph *m_high;
    QCPGraph *m_middle;
};

} // namespace inspector::ui
