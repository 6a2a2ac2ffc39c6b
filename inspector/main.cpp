// SPDX-License-Identifier: GPL-3.0-or-later
// Decides between window and no window before any application object exists, and hands over.
#include "core/program/command_line.h"
#include "core/program/csv_writer.h"
#include "core/program/headless.h"
#include "core/program/trade_command.h"
#include "core/session/session.h"
#include "ui/trade/trade_chart.h"
#include "ui/window/application.h"

#include <QApplication>
#include <QFile>
#include <QTextStream>

#include <unistd.h>

#include <algorithm>
#include <array>

namespace {

using namespace inspector;

// What the arguments ask for; prints what they ask to print, and why they can't be followed.
CommandLine readArguments(QTextStream &messages) {
    CommandLine line = parseCommandLine(QCoreApplication::arguments());
    QTextStream(stdout) << line.output;
    messages << line.error;
    return line;
}

int runTradeOnTerminal(const Options &options) {
    QTextStream out(stdout);
    QTextStream messages(stderr);
    QTextStream *progress = isatty(STDERR_FILENO) ? &messages : nullptr;
    return runTrade(options, {out, messages, progress}, ui::writeTradePicture);
}

// Curves as text are written by the core alone.
bool needsToDraw(const Options &options) {
    const QString &plot = options.trade.plot;
    return !plot.isEmpty() && !plot.endsWith(QLatin1String(".svg"));
}

// Pictures need an application that can draw, but no screen.
int runTradeOffscreen(int argc, char **argv, const Options &options) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    return runTradeOnTerminal(options);
}

int runWithoutWindow(int argc, char **argv) {
    auto application = std::make_unique<QCoreApplication>(argc, argv);
    QTextStream messages(stderr);
    const CommandLine line = readArguments(messages);
    if (line.exitStatus) return *line.exitStatus;
    if (!line.options.headless) {
        messages << "physics-inspector: no display; --headless needs none, and inspector/run plays without one\n";
        return 2;
    }
    const bool isTrade = line.options.action == Options::Action::Trade;
    if (isTrade && !needsToDraw(line.options)) return runTradeOnTerminal(line.options);
    if (isTrade) {
        application.reset(); // there can be only one
        return runTradeOffscreen(argc, argv, line.options);
    }
    QFile out;
    if (!out.open(stdout, QIODevice::WriteOnly)) return 1;
    return runHeadless(line.options, out, messages);
}

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
    QObject::connect(session.get(), &Session::recordingFailed, &application, [&messages](const QString &reason) {
        messages << "physics-inspector: " << reason << '\n';
        messages.flush();
    });
    const int status = ui::runWindow(*session, line.options);
    if (line.options.csv.isEmpty()) return status;
    if (writeTable(line.options.csv, session->simulation().samples(), line.options, &error)) return status;
    messages << "physics-inspector: --csv: " << error << '\n';
    return 1;
}

// Qt would abort the program without one, after several lines.
bool hasDisplay() {
    constexpr std::array<const char *, 3> kVariables{"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"};
    return std::any_of(kVariables.begin(), kVariables.end(),
                       [](const char *name) { return !qEnvironmentVariableIsEmpty(name); });
}

} // namespace

int main(int argc, char **argv) {
    QCoreApplication::setApplicationName(QStringLiteral("physics-inspector"));
    QCoreApplication::setOrganizationName(QStringLiteral("libphysics"));
    return isWindowless(argc, argv) || !hasDisplay() ? runWithoutWindow(argc, argv) : runWithWindow(argc, argv);
}
