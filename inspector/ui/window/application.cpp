// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/application.h"

#include "core/program/ending.h"
#include "core/session/session.h"
#include "core/setup/lines.h"
#include "gl/surface_format.h"
#include "gl/view/maze_view.h"
#include "ui/track/track_dock.h"
#include "ui/window/main_window.h"
#include "ui/window/unattended_run.h"

#include <QApplication>
#include <QScreen>
#include <QSocketNotifier>
#include <QSurfaceFormat>
#include <QTextStream>

#include <cstdlib>

namespace inspector::ui {

namespace {

const QString kWithout = QStringLiteral("; --headless needs none, and inspector/run plays without one");

/// Message handler while the application is constructed: replaces Qt's messages before it aborts.
void endWithoutDisplay(QtMsgType type, const QMessageLogContext &, const QString &) {
    if (type != QtFatalMsg) return;
    QTextStream messages(stderr);
    report(messages, QStringLiteral("no display can be opened") + kWithout);
    std::_Exit(2);
}

/// Qt would abort without a display, after printing several lines.
bool hasDisplay() {
    const auto isSet = [](const char *name) { return !qEnvironmentVariableIsEmpty(name); };
    return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY") || isSet("QT_QPA_PLATFORM");
}

/// Why the scale factor is unusable: a window enlarged that much would take gigabytes.
QString scaleProblem() {
    const QScreen *screen = QGuiApplication::primaryScreen();
    const double scale = screen ? screen->devicePixelRatio() * screen->logicalDotsPerInch() / 96.0 : 1.0;
    if (scale >= 0.1 && scale <= 10.0) return {};
    return QStringLiteral("the screen's scale is %1, by QT_SCALE_FACTOR and QT_FONT_DPI; expected 0.1 to 10")
        .arg(scale);
}

/// Ends the event loop on a termination signal.
void watchEndingSignals(QObject &owner) {
    if (endingDescriptor() < 0) return;
    auto *notifier = new QSocketNotifier(endingDescriptor(), QSocketNotifier::Read, &owner);
    QObject::connect(notifier, &QSocketNotifier::activated, &owner, [notifier] {
        notifier->setEnabled(false);
        QCoreApplication::quit();
    });
}

} // namespace

std::unique_ptr<QApplication> makeApplication(int &argc, char **argv) {
    QSurfaceFormat::setDefaultFormat(gl::surfaceFormat());
    const QtMessageHandler before = qInstallMessageHandler(endWithoutDisplay);
    if (!hasDisplay()) qFatal("no display");
    auto application = std::make_unique<QApplication>(argc, argv);
    qInstallMessageHandler(before);
    return application;
}

QString displayProblem(const Options &options) {
    const QString wrongScale = scaleProblem();
    if (!wrongScale.isEmpty()) return wrongScale;
    if (options.view != Options::View::Solid) return {};
    const QString problem = gl::displayProblem();
    return problem.isEmpty() ? problem : QStringLiteral("--view 3d: %1; --view 2d needs no OpenGL").arg(problem);
}

int runWindow(Session &session, const Options &options) {
    QString problem;
    if (options.view == Options::View::Auto) problem = gl::displayProblem();
    const bool isFlat = options.view == Options::View::Flat || !problem.isEmpty();
    MainWindow window(session, isFlat ? gl::Drawing::Flat : gl::Drawing::Solid);
    if (!problem.isEmpty()) window.sayWhyFlat(problem);
    watchEndingSignals(window);
    if (!options.shaders.isEmpty()) window.view().setShaderDirectory(options.shaders);
    if (!options.grab.isEmpty())
        window.view().setQuality(window.view().quality()); // fixed, so that it is the same on each machine
    window.show();
    if (!options.fit.track.isEmpty()) {
        window.track().setFrame(options.fit.frame);
        window.openTrack(options.fit.track, options.fit.unitWords);
    }
    UnattendedRun run(session, options);
    QObject::connect(&run, &UnattendedRun::finished, &window, [&window, &options](QString error) {
        if (!options.grab.isEmpty()) window.grabTo(options.grab, error.isEmpty() ? &error : nullptr);
        QTextStream messages(stderr);
        if (!error.isEmpty()) report(messages, error);
        QCoreApplication::exit(error.isEmpty() ? 0 : 1);
    });
    run.start();
    return QApplication::exec();
}

} // namespace inspector::ui
