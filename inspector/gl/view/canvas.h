// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a view's picture, with or without OpenGL.
#pragma once

#include "gl/frame.h"
#include "gl/orbit_camera.h"
#include "mesh/mesh.h"

#include <QImage>
#include <QString>
#include <QWidget>

#include <optional>

namespace inspector::gl {

/// What a canvas needs from its view.
class CanvasHost {
public:
    virtual const Frame &nextFrame() = 0;                 ///< the frame to draw now
    virtual View view() const = 0;                        ///< the camera of that frame
    virtual const OrbitCamera &lookedThrough() const = 0; ///< logical pixels
    virtual glm::dmat4 boardPose() const = 0;             ///< the board's pose in that frame
    virtual void noteDrawn(double milliseconds) = 0;      ///< time until the picture was finished
    virtual void
    noteProblem(const QString &text) = 0; ///< one line or a shader log; drawing continues as far as possible
    virtual void noteRebuilt() = 0;       ///< the shaders were rebuilt
    virtual void noteUnusable(const QString &reason) = 0; ///< this kind of canvas can't draw here at all

protected:
    ~CanvasHost() = default;
};

class Canvas {
public:
    virtual ~Canvas() = default;

    virtual QWidget &widget() = 0;
    virtual void setMaze(const Mesh &mesh) = 0;
    virtual void setBall(const Mesh &mesh) = 0;
    /// The current picture, `scale` pixels per device pixel; null before the first.
    virtual QImage picture(const Frame &frame, int scale) = 0;
    /// The pixels on the screen.
    virtual QImage shown() = 0;
    virtual QString name() const = 0; ///< of the renderer; empty before the first picture

    /// Empty: chosen automatically from drawing times.
    virtual void setQuality(std::optional<Quality>) {}
    virtual Quality quality() const { return Quality::Low; }
    virtual void setShaderDirectory(const QString &) {}
};

} // namespace inspector::gl
