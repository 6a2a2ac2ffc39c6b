// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/program/csv_writer.h"
#include "core/simulation/sample_ring.h"
#include "ui/parts/theme.h"
#include "ui/plots/axis_labels.h"
#include "ui/plots/time_view.h"

#include <memory>
#include <optional>
#include <vector>

#include <qcustomplot.h>

namespace inspector::ui {

class BounceTicks;
class ReadOutText;

/// What is drawn in addition to a run's own samples, and which of these matter.
struct RunContext {
    std::shared_ptr<const std::vector<Sample>> beside; ///< another run, drawn pale; or nullptr
    std::optional<double> moment;                      ///< the moment shown in the past, s
    std::optional<double> left;                        ///< s, when the ball left the maze; it falls then
    bool operator==(const RunContext &) const = default;
};

/// Of a plot among those above each other on one time axis.
struct StackPlace {
    bool isHighest = true; ///< has the hint on how to use them
    bool isLowest = true;  ///< has the times, even if it is low
};

/// Channels of a sample ring over time; loads only what is visible. Subclasses define which channels are shown and how.
/// While the plot follows, the newest sample is at the right border and the values fill the height. The wheel zooms in
/// time and a drag pans; over the value axis (or with Ctrl) both act on values; a double click follows again. Values
/// under the cursor are shown above the curves. With the keyboard, + and - zoom, with Ctrl the values, PageUp and
/// PageDown move, and 0 follows again.
class TimePlot : public QCustomPlot {
    Q_OBJECT

public:
    /// Shows new samples; called about 30 times a second, not per sample.
    void refresh();

    TimeView &time() { return *m_time; }
    bool isFollowing() const { return m_time->isFollowing(); }
    void setFollowing(bool isOn);
    bool isPaused() const { return m_time->pausedAt().has_value(); }
    void setPaused(bool isOn);
    /// Hides everything up to the newest sample.
    void clear();

    /// Shows ticks at the times of bounces, s, ascending; the selected one, which need not be among them, spans the
    /// height.
    void showBounces(std::vector<double> times, std::optional<double> selected);
    void setContext(const RunContext &context);
    void setPlace(const StackPlace &place);

    /// Until dressForWindow() the plot has what a picture of that height, in screen pixels, has: labels if there is
    /// room for them, and no hint on how to use it.
    void dressForPicture(int height);
    void dressForWindow();
    /// Writes, by the name's suffix, .csv (all samples since clear()), .png or .pdf (the picture). Returns false, with
    /// one line in `error` (may be nullptr), on failure.
    bool save(const QString &path, QString *error);

signals:
    void bounceClicked(double time); ///< the tick's time, s

protected:
    struct Curve {
        Channel channel;
        QColor Accents::*colour;
        Qt::PenStyle style;
        QCPGraph *graph;
        QCPGraph *beside;   ///< that of the other run
        QCPItemTracer *dot; ///< on the sample under the cursor
    };

    /// samples must outlive the plot. time: shared with other plots, or null for its own.
    TimePlot(const SampleRing &samples, std::shared_ptr<TimeView> time, QWidget *parent);
    void addCurve(Channel channel, QColor Accents::*colour, Qt::PenStyle style = Qt::SolidLine);
    void clearCurves();
    std::vector<QCPGraph *> graphs() const;    ///< of the curves, and of the other run's
    QCPGraph *addKey(QColor Accents::*colour); ///< a legend entry without a curve
    const std::vector<Curve> &curves() const { return m_curves; }
    bool fitsAtOnce() const { return m_fitsAtOnce; }
    QCPRange fittedTimes() const; ///< those whose values the value axis has to show
    void fitAgain();

    /// Converts a value to the value axis's unit; NaN if there is none.
    virtual double plotted(double value) const { return value; }
    /// The coordinate on the current value axis at which a plotted value is drawn.
    virtual double drawn(double plotted) const { return plotted; }
    /// Fits the value axis to the visible curves. Not called after the user has moved the axis.
    virtual void fitValues() = 0;
    /// Loads what is drawn in addition to the curves, between these times, s.
    virtual void loadBesides(const QCPRange &) {}
    void drawAnew() { m_isStale = true; } ///< redraws with the next refresh()
    /// The columns of the plot's table.
    virtual Columns columns() const { return Columns::Ball; }
    /// The text for the sample under the cursor, after its time, in one line.
    virtual QString textOf(const Sample &sample) const = 0;

    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void fitLegend();
    void fitLabels(int height);
    void fitLeastHeight();
    void layOutLegend(); ///< in one line, with the read-out if there is room
    void zoomTime(double factor);
    void zoomValues(double factor);
    void endZoom();              ///< of the time
    void moveTime(double share); ///< by this share of the times shown
    void takeColours();
    std::optional<double> newestTime() const;
    QCPRange shownTimes() const; ///< may be empty: then the end precedes the beginning
    void load(const Curve &curve);
    void loadBeside(Curve &curve);
    void updateReadOut();
    int leftMargin() const;       ///< pixels
    int roomBesideLegend() const; ///< pixels
    void placeReadOut();
    QString hint() const;
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
    StackPlace m_place;
    AxisLabels m_labels{*this};
    BounceTicks *m_ticks;
    QCPItemStraightLine *m_cursorLine;
    QCPItemStraightLine *m_momentLine;
    ReadOutText *m_text;
    QCPLayoutGrid *m_legendLine = nullptr;
    int m_longestReadOut = 0; ///< logical pixels
    QPointF m_pressedAt;
    std::optional<Sample> m_readOut;
    bool m_fitsValues = true;
    bool m_fitsAtOnce = false; ///< instead of gradually
    uint64_t m_shown = 0;      ///< sample count at the last redraw
    bool m_isStale = true;
};

} // namespace inspector::ui
