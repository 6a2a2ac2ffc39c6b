// SPDX-License-Identifier: GPL-3.0-or-later
// Decides between window and no window before any application object exists, and hands over.
#include "core/command_line.h"
#include "core/headless.h"

#include <QCoreApplication>
#include <QFile>
#include <QTextStream>

#ifdef INSPECTOR_HAS_WINDOW
#include "ui/run_window.h"
#endif

namespace {

using namespace inspector;

int runWithoutWindow(int argc, char **argv) {
    const QCoreApplication application(argc, argv);
    QTextStream messages(stderr);
    const CommandLine line = parseCommandLine(QCoreApplication::arguments());
    QFile out;
    if (!out.open(stdout, QIODevice::WriteOnly)) return 1;
    out.write(line.output.toUtf8());
    messages << line.error;
    if (line.exitStatus) return *line.exitStatus;
    return runHeadless(line.options, out, messages);
}

} // namespace

int main(int argc, char **argv) {
    QCoreApplication::setApplicationName(QStringLiteral("physics-inspector"));
    QCoreApplication::setOrganizationName(QStringLiteral("libphysics"));
#ifdef INSPECTOR_HAS_WINDOW
    if (!isWindowless(argc, argv)) return runWindow(argc, argv);
#else
    if (!isWindowless(argc, argv)) {
        QTextStream(stderr) << "physics-inspector: built without a window; use --headless\n";
        return 2;
    }
#endif
    return runWithoutWindow(argc, argv);
}
