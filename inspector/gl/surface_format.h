// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>

QT_BEGIN_NAMESPACE
class QOpenGLContext;
QT_END_NAMESPACE

namespace inspector::gl {

// Desktop OpenGL 3.3 core by name. Give it to QSurfaceFormat::setDefaultFormat() before the application object exists.
// Debug builds ask for a debug context.
QSurfaceFormat surfaceFormat();

// Empty when `context` (may be null) can draw; otherwise one line that says what was got and what is needed.
QString contextProblem(const QOpenGLContext *context);

// Empty when OpenGL can draw on the application's display; otherwise one line. Needs the application object.
QString displayProblem();

// Of the current context, for instance "llvmpipe (LLVM 15.0.6, 256 bits)".
QString rendererName();
bool isSoftwareRenderer(const QString &name);
// Whether that of the application's display is one; false if there is none. Needs the application object.
bool isDrawnBySoftware();

} // namespace inspector::gl
