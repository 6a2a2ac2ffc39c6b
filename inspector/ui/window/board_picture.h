// SPDX-License-Identifier: GPL-3.0-or-later
// From what is simulated to what is drawn.
#pragma once

#include "core/session/session.h"
#include "gl/frame.h"
#include "mesh/mesh.h"

namespace inspector::ui {

// The board and ball at this moment, between two steps, with the way the ball came.
gl::Frame currentFrame(Session &session);

// A pale line ahead of the ball, and where it hits next.
void addWayAhead(gl::Frame &frame, const WayAhead &way);

// The open level's mesh: its .obj, or made from the scene's boxes and the places where the ball gets out, where there
// is none. Made so as well, with one line in `error`, if the file can't be read.
gl::Mesh mazeMesh(Session &session, QString *error);
// The ball's mesh beside the levels, or a patterned one of our own.
gl::Mesh ballMesh(QString *error);

} // namespace inspector::ui
