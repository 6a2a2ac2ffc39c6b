// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the simulated state to drawn frames and meshes.
#pragma once

#include "core/session/session.h"
#include "gl/frame.h"
#include "mesh/mesh.h"

namespace inspector::ui {

/// Board and ball at this moment, interpolated between two steps, with the ball's trail.
gl::Frame currentFrame(Session &session);

/// Adds a pale line ahead of the ball, and the next bounce.
void addWayAhead(gl::Frame &frame, const WayAhead &way);

/// The open level's mesh: its .obj, or one made from the scene's boxes and exits if there is none, or, with one line in
/// `error`, if it can't be read.
gl::Mesh mazeMesh(Session &session, QString *error);
/// The ball's mesh next to the levels, or a built-in patterned one.
gl::Mesh ballMesh(QString *error);

} // namespace inspector::ui
