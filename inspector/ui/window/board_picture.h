// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the simulation's state to frames and meshes for drawing.
#pragma once

#include "core/session/session.h"
#include "gl/frame.h"
#include "mesh/mesh.h"

namespace inspector::ui {

/// Board and ball at this moment, interpolated between two steps, with the ball's trail.
gl::Frame currentFrame(Session &session);

/// Adds a pale line ahead of the ball, and the next bounce.
void addWayAhead(gl::Frame &frame, const WayAhead &way);

/// The mesh of the open level: its .obj; if there is none, a mesh made from the scene's boxes and exits. If the .obj
/// can't be read, the latter is returned with one line in `error`.
gl::Mesh mazeMesh(Session &session, QString *error);
/// The ball's mesh next to the levels, or a built-in patterned one.
gl::Mesh ballMesh(QString *error);

} // namespace inspector::ui
