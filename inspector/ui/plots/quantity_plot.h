// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/time_plot.h"

#include <QStringList>

class QDragEnterEvent;
class QDropEvent;

namespace inspector::ui {

/// A plot's content and its settings text: "velocity_x,speed", "log:distance".
struct PlotContent {
    std::vector<Channel> channels;
    bool isLogarithmic = false;
    bool operator==(const PlotContent &) const = default;
};
QString textOf(const PlotContent &content);
PlotContent plotContentOf(const QString &text); ///< unknown names are ignored

/// Any quantities over time; a ghost's are dashed, in the colours of the ball's.
class QuantityPlot : public TimePlot {
    Q_OBJECT

public:
    /// samples must outlive the plot.
    QuantityPlot(const SampleRing &samples, const PlotContent &content, std::shared_ptr<TimeView> time = nullptr,
                 QWidget *parent = nullptr);

    const PlotContent &content() const { return m_content; }
    void setContent(const PlotContent &content);
    void add(Channel channel); ///< no effect if it is there already

signals:
    void contentChanged();

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void fitValues() override;
    void loadBesides(const QCPRange &times) override;
    double drawn(double plotted) const override;
    Columns columns() const override { return Columns::All; }
    QString textOf(const Sample &sample) const override;

private:
    void fitPowers();
    void fitSpan();

    PlotContent m_content;
};

} // namespace inspector::ui
