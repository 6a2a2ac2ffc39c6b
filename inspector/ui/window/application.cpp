// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/application.h"

#include "core/session/session.h"
#include "gl/maze_view.h"
#include "gl/surface_format.h"
#include "ui/window/main_window.h"
#include "ui/window/unattended_run.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QTextStream>

namespace inspector::ui {

void prepareApplication() { QSurfaceFormat::setDefaultFormat(gl::surfaceFormat()); }

int runWindow(Session &session, const Options &options) {
    MainWindow window(session);
    if (!options.shaders.isEmpty()) window.view().setShaderDirectory(options.shaders);
    window.show();
    UnattendedRun run(session, options);
    QObject::connect(&run, &UnattendedRun::finished, &window, [&window, &options](QString error) {
        if (!options.grab.isEmpty()) window.grabTo(options.grab, error.isEmpty() ? &error : nullptr);
        if (!error.isEmpty()) QTextStream(stderr) << "physics-inspector: " << error << '\n';
        QCoreApplication::exit(error.isEmpty() ? 0 : 1);
    });
    run.start();
    return QApplication::exec();
}

} // namespace inspector::ui
