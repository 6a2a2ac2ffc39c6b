// SPDX-License-Identifier: GPL-3.0-or-later
// What fills a view with its picture: by OpenGL, or without it.
#pragma once

#include "gl/frame.h"
#include "gl/orbit_camera.h"
#include "mesh/mesh.h"

#include <QImage>
#include <QString>
#include <QWidget>

#include <optional>

namespace inspector::gl {

// What a canvas asks of the view that it is in.
class CanvasHost {
public:
    virtual const Frame &nextFrame() = 0;                 // the one to draw now
    virtual View view() const = 0;                        // how it is looked at
    virtual const OrbitCamera &lookedThrough() const = 0; // logical pixels
    virtual glm::dmat4 boardPose() const = 0;             // of that frame
    virtual void noteDrawn(double milliseconds) = 0;      // until the picture was finished
    virtual void noteProblem(const QString &text) = 0;    // one line or a shader log; it goes on with what it has
    virtual void noteRebuilt() = 0;                       // shaders
    virtual void noteUnusable(const QString &reason) = 0; // it can't draw here at all

protected:
    ~CanvasHost() = default;
};

class Canvas {
public:
    virtual ~Canvas() = default;

    virtual QWidget &widget() = 0;
    virtual void setMaze(const Mesh &mesh) = 0;
    virtual void setBall(const Mesh &mesh) = 0;
    // The picture as it is now, `scale` pixels for each of the device; null before the first.
    virtual QImage picture(const Frame &frame, int scale) = 0;
    // What is on the screen.
    virtual QImage shown() = 0;
    virtual QString name() const = 0; // of what draws; empty before the first picture

    // Nothing: chosen by how long pictures take.
    virtual void setQuality(std::optional<Quality>) {}
    virtual Quality quality() const { return Quality::Low; }
    virtual void setShaderDirectory(const QString &) {}
};

} // namespace inspector::gl
