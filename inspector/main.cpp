// SPDX-License-Identifier: GPL-3.0-or-later
// Decides between window and no window before any application object exists, and hands over.
#include "core/command_line.h"
#include "core/csv_writer.h"
#include "core/headless.h"
#include "core/session.h"

#include <QCoreApplication>
#include <QFile>
#include <QTextStream>

#ifdef INSPECTOR_HAS_WINDOW
#include "ui/application.h"

#include <QApplication>
#endif

namespace {

using namespace inspector;

// What the arguments ask for; prints what they ask to print, and why they can't be followed.
CommandLine readArguments(QTextStream &messages) {
    CommandLine line = parseCommandLine(QCoreApplication::arguments());
    QTextStream(stdout) << line.output;
    messages << line.error;
    return line;
}

int runWithoutWindow(int argc, char **argv) {
    const QCoreApplication application(argc, argv);
    QTextStream messages(stderr);
    const CommandLine line = readArguments(messages);
    if (line.exitStatus) return *line.exitStatus;
    QFile out;
    if (!out.open(stdout, QIODevice::WriteOnly)) return 1;
    return runHeadless(line.options, out, messages);
}

#ifdef INSPECTOR_HAS_WINDOW
int runWithWindow(int argc, char **argv) {
    ui::prepareApplication();
    const QApplication application(argc, argv);
    QTextStream messages(stderr);
    const CommandLine line = readArguments(messages);
    if (line.exitStatus) return *line.exitStatus;

    QSettings settings;
    QString error;
    const std::unique_ptr<Session> session = Session::open(line.options, settings, &error);
    if (!session) {
        messages << "physics-inspector: " << error << '\n';
        return 2;
    }
    const int status = ui::runWindow(*session, line.options);
    if (line.options.csv.isEmpty()) return status;
    if (writeTable(line.options.csv, session->simulation().samples(), line.options, &error)) return status;
    messages << "physics-inspector: --csv: " << error << '\n';
    return 1;
}
#else
int runWithWindow(int, char **) {
    QTextStream(stderr) << "physics-inspector: built without a window; use --headless\n";
    return 2;
}
#endif

} // namespace

int main(int argc, char **argv) {
    QCoreApplication::setApplicationName(QStringLiteral("physics-inspector"));
    QCoreApplication::setOrganizationName(QStringLiteral("libphysics"));
    return isWindowless(argc, argv) ? runWithoutWindow(argc, argv) : runWithWindow(argc, argv);
}
