// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>

#include <optional>
#include <vector>

namespace inspector::ui {

// A slider over the positions of a recording. A press goes to where it is; Left and Right are a step, PageUp and
// PageDown a second, Home and End beginning and end. Marks show where runs begin and where the first difference is.
class SeekSlider : public QSlider {
    Q_OBJECT

public:
    explicit SeekSlider(QWidget *parent = nullptr);

    void setRuns(std::vector<int> positions);
    void setDifference(std::optional<int> position);
    // Where there is a measured ball: from one position to another.
    struct Span {
        int begin, end;
        bool operator==(const Span &) const = default;
    };
    void setSpan(std::optional<Span> span);
    const std::optional<Span> &span() const { return m_span; }
    // Where this position is, logical pixels from the left.
    int pixelOf(int position) const;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    struct Track {
        int left, length; // of the handle's middle
    };
    Track track() const;
    int positionAt(int pixel) const;

    std::vector<int> m_runs;
    std::optional<int> m_difference;
    std::optional<Span> m_span;
};

} // namespace inspector::ui
