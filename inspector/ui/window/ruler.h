// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>

#include <glm/vec3.hpp>

#include <optional>

class QLabel;

namespace inspector::gl {
class MazeView;
class Strokes;
} // namespace inspector::gl

namespace inspector::ui {

/// Measures the floor by a drag with Shift over the view: the length, and the angle from the board's x axis. The result
/// stays visible until the next press.
class Ruler : public QObject {
    Q_OBJECT

public:
    /// view must outlive the ruler.
    Ruler(gl::MazeView &view, QObject *parent);

    void addTo(gl::Strokes &strokes) const;
    /// Removes it; false if it wasn't visible.
    bool dismiss();

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    bool begin(const QPointF &place);
    void drawTo(const QPointF &place);
    std::optional<glm::dvec3> floorAt(const QPointF &place) const;

    gl::MazeView &m_view;
    QLabel *m_text; ///< label over the view
    glm::dvec3 m_from{0.0};
    glm::dvec3 m_to{0.0};
    bool m_isDragged = false;
    bool m_isShown = false;
};

} // namespace inspector::ui
