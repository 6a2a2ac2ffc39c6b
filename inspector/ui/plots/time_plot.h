// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/program/csv_writer.h"
#include "core/simulation/sample_ring.h"
#include "ui/parts/theme.h"
#include "ui/plots/time_view.h"

#include <memory>
#include <optional>
#include <vector>

#include <qcustomplot.h>

namespace inspector::ui {

class BounceTicks;
class ReadOutText;

// What is drawn behind a run beside its own samples.
struct RunContext {
    const std::vector<Sample> *oldFuture = nullptr; // what had come before another way was taken; or nullptr
    std::optional<double> moment;                   // that is looked at in the past, s
};

// Channels of the ring over time, fed with what is visible and no more; which ones, and how their values are shown, is
// said by the kinds of plot below it. While it follows, the newest sample stays at the right border and the values fill
// the height. Wheel: zoom of time; drag: pan; over the value axis (or with Ctrl) both act on values; double click:
// follow again. What is under the cursor is said above the curves.
class TimePlot : public QCustomPlot {
    Q_OBJECT

public:
    // Shows what is new; called about 30 times a second, never per sample.
    void refresh();

    TimeView &time() { return *m_time; }
    bool isFollowing() const { return m_time->isFollowing(); }
    void setFollowing(bool isOn);
    bool isPaused() const { return m_time->pausedAt().has_value(); }
    void setPaused(bool isOn);
    // Forgets what was up to now.
    void clear();

    // Ticks at the times of bounces, s, rising; the selected one, maybe none of them, is a line all the way up.
    void showBounces(std::vector<double> times, std::optional<double> selected);
    void setContext(const RunContext &context);

    // Writes what the name's ending says: .csv (all samples since clear()), .png or .pdf (the picture). False and one
    // line in `error` (or nullptr) if that fails.
    bool save(const QString &path, QString *error);

    // The sample under the cursor, while there is one.
    std::optional<Sample> readOut() const { return m_readOut; }
    QString readOutText() const; // as it is said above the curves

signals:
    void bounceClicked(double time); // of its tick, s

protected:
    struct Curve {
        Channel channel;
        QColor Accents::*colour;
        Qt::PenStyle style;
        QCPGraph *graph;
        QCPGraph *old;      // of the old future
        QCPItemTracer *dot; // on the sample under the cursor
    };

    // samples: outlives the plot. time: shared with others, or its own.
    TimePlot(const SampleRing &samples, std::shared_ptr<TimeView> time, QWidget *parent);
    void addCurve(Channel channel, QColor Accents::*colour, Qt::PenStyle style = Qt::SolidLine);
    void clearCurves();
    QCPGraph *addKey(QColor Accents::*colour); // an entry of the legend without a curve
    const std::vector<Curve> &curves() const { return m_curves; }
    bool fitsAtOnce() const { return m_fitsAtOnce; }
    void fitAgain();

    // A value in the unit of the value axis; NaN where there is none.
    virtual double plotted(double value) const { return value; }
    // Where on the value axis, as it is just now, a plotted value is drawn.
    virtual double drawn(double plotted) const { return plotted; }
    // Moves the value axis to what the curves show just now. Not called once a person has moved it.
    virtual void fitValues() = 0;
    // Loads what is drawn besides the curves, between these times, s.
    virtual void loadBesides(const QCPRange &) {}
    void drawAnew() { m_isStale = true; } // with the next refresh()
    // Those of its table.
    virtual Columns columns() const { return Columns::Ball; }
    // What is said of the sample under the cursor, after its time, in one line.
    virtual QString textOf(const Sample &sample) const = 0;

    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void layOutLegend();
    void takeColours();
    std::optional<double> newestTime() const;
    QCPRange shownTimes() const; // maybe none: then its end comes first
    void load(const Curve &curve);
    void loadOldFuture(const Curve &curve);
    void updateReadOut();
    std::optional<Sample> sampleAt(double time) const;
    Qt::Orientations orientationAt(QPointF position, Qt::KeyboardModifiers modifiers) const;

    const SampleRing &m_samples;
    std::shared_ptr<TimeView> m_time;
    struct Key {
        QCPGraph *graph;
        QColor Accents::*colour;
    };

    std::vector<Curve> m_curves;
    std::vector<Key> m_keys;
    RunContext m_context;
    BounceTicks *m_ticks;
    QCPItemStraightLine *m_cursorLine;
    QCPItemStraightLine *m_momentLine;
    ReadOutText *m_text;
    QPointF m_pressedAt;
    std::optional<Sample> m_readOut;
    bool m_fitsValues = true;
    bool m_fitsAtOnce = false; // instead of little by little
    uint64_t m_shown = 0;      // samples at the last picture
    bool m_isStale = true;
};

} // namespace inspector::ui
