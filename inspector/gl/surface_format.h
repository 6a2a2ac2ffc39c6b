// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>

QT_BEGIN_NAMESPACE
class QOpenGLContext;
QT_END_NAMESPACE

namespace inspector::gl {

/// Desktop OpenGL 3.3 core. Pass it to QSurfaceFormat::setDefaultFormat() before the application object exists. Debug
/// builds request a debug context.
QSurfaceFormat surfaceFormat();

/// Empty if `context` (may be null) is usable; otherwise one line that says what was got and what is needed.
QString contextProblem(const QOpenGLContext *context);

/// Empty if OpenGL can draw on the application's display; otherwise one line. Needs the application object.
QString displayProblem();

/// The current context's renderer, for instance "llvmpipe (LLVM 15.0.6, 256 bits)".
QString rendererName();
bool isSoftwareRenderer(const QString &name);
/// Whether the display's renderer is a software one; false if there is none. Needs the application object.
bool isDrawnBySoftware();

} // namespace inspector::gl
