// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>

#include <optional>
#include <vector>

namespace inspector::ui {

/// A slider over the positions of a recording. A press seeks. Left and Right move by a step, PageUp and PageDown by a
/// second, Home and End to the ends. Marks show where runs begin, where the first difference is, and that there were
/// steps before the left end.
class SeekSlider : public QSlider {
    Q_OBJECT

public:
    explicit SeekSlider(QWidget *parent = nullptr);

    void setRuns(std::vector<int> positions);
    void setDifference(std::optional<int> position);
    void setContinuing(bool isContinuing); ///< steps before the left end aren't shown
    /// The positions at which the track has measured points.
    struct Span {
        int begin, end;
        bool operator==(const Span &) const = default;
    };
    void setSpan(std::optional<Span> span);
    const std::optional<Span> &span() const { return m_span; }
    /// The x coordinate of a position, logical pixels.
    int pixelOf(int position) const;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    struct Track {
        int left, length; ///< for the centre of the handle
    };
    Track track() const;
    int positionAt(int pixel) const;

    std::vector<int> m_runs;
    bool m_isContinuing = false;
    std::optional<int> m_difference;
    std::optional<Span> m_span;
};

} // namespace inspector::ui
