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

// A drag with Shift over the view measures the floor: the length, and the angle from the board's x axis. It stays until
// the next press.
class Ruler : public QObject {
    Q_OBJECT

public:
    // view: outlives the ruler.
    Ruler(gl::MazeView &view, QObject *parent);

    void addTo(gl::Strokes &strokes) const;
    // False if there was nothing to be seen.
    bool dismiss();

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    bool begin(const QPointF &place);
    void drawTo(const QPointF &place);
    std::optional<glm::dvec3> floorAt(const QPointF &place) const;

    gl::MazeView &m_view;
    QLabel *m_text; // over the view
    glm::dvec3 m_from{0.0};
    glm::dvec3 m_to{0.0};
    bool m_isDragged = false;
    bool m_isShown = false;
};

} // namespace inspector::ui
