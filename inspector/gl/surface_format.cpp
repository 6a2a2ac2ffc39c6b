// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/surface_format.h"

#include <utility>

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace inspector::gl {

namespace {

constexpr int kMajor = 3;
constexpr int kMinor = 3;

} // namespace

QSurfaceFormat surfaceFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setVersion(kMajor, kMinor);
    format.setDepthBufferSize(24);
    format.setSwapInterval(1);
#ifndef NDEBUG
    format.setOption(QSurfaceFormat::DebugContext);
#endif
    return format;
}

QString contextProblem(const QOpenGLContext *context) {
    const QString needed = QStringLiteral("expected desktop OpenGL %1.%2 core").arg(kMajor).arg(kMinor);
    if (!context || !context->isValid()) return QStringLiteral("OpenGL: no context could be made; ") + needed;
    if (context->isOpenGLES()) return QStringLiteral("OpenGL: got OpenGL ES; ") + needed;
    // Drivers return the newest version that is compatible with the requested one.
    const auto [major, minor] = context->format().version();
    if (std::pair(major, minor) >= std::pair(kMajor, kMinor)) return {};
    return QStringLiteral("OpenGL: got version %1.%2; %3").arg(major).arg(minor).arg(needed);
}

namespace {

struct Display {
    QString problem; ///< one line, or empty
    QString renderer;
};

Display look() {
    // These platforms either provide no context, or crash as soon as a widget is drawn with it.
    const QString platform = QGuiApplication::platformName();
    for (const char *without : {"offscreen", "minimal", "minimalegl", "vnc", "linuxfb"})
        if (platform == QLatin1String(without))
            return {QStringLiteral("Qt's platform '%1' can't show OpenGL").arg(platform), {}};
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    context.create();
    const QString problem = contextProblem(&context);
    if (!problem.isEmpty()) return {problem, {}};
    if (context.makeCurrent(&surface)) return {{}, rendererName()};
    return {QStringLiteral("OpenGL: a context was made but can't be used"), {}};
}

/// Cached: probing takes some hundredths of a second.
const Display &display() {
    static const Display seen = look();
    return seen;
}

} // namespace

QString displayProblem() { return display().problem; }

bool isDrawnBySoftware() { return isSoftwareRenderer(display().renderer); }

QString rendererName() {
    const auto *name = QOpenGLContext::currentContext()->functions()->glGetString(GL_RENDERER);
    return QString::fromLatin1(reinterpret_cast<const char *>(name));
}

bool isSoftwareRenderer(const QString &name) {
    for (const char *part : {"llvmpipe", "softpipe", "swrast", "Software", "SwiftShader", "GDI Generic"})
        if (name.contains(QLatin1String(part))) return true;
    return false;
}

} // namespace inspector::gl
