// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the command line, decides whether a window is needed, and delegates. Only one application object exists at a
// time: the command line, and everything without a window, uses one that needs no display.
#include "core/program/command_line.h"
#include "core/program/csv_writer.h"
#include "core/program/ending.h"
#include "core/program/headless.h"
#include "core/program/outputs.h"
#include "core/program/plugins.h"
#include "core/program/trade_command.h"
#include "core/session/session.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "core/setup/settings_file.h"
#include "ui/trade/trade_picture.h"
#include "ui/window/application.h"
#include "ui/window/save_run.h"

#include <QApplication>
#include <QTextStream>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

namespace {

using namespace inspector;

/// If a standard descriptor were closed, the next opened file would receive its output.
void keepStandardDescriptors() {
    int descriptor = ::open("/dev/null", O_RDONLY); // read-only, so that writing fails
    while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = ::dup(descriptor);
    if (descriptor >= 0) ::close(descriptor);
}

/// Why too few files can be open, one line; else empty. GLib aborts the program where it can't open another one.
QString fileLimitProblem() {
    constexpr rlim_t kFewest = 24; // a window's first picture needs 16
    rlimit limit{};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= kFewest) return {};
    return QStringLiteral("only %1 files can be open (ulimit -n); expected at least %2")
        .arg(limit.rlim_cur)
        .arg(kFewest);
}

/// Qt's own options are disabled, as it would take --plugin for one of them.
QStringList wordsOf(int argc, char **argv) {
    QStringList words;
    std::transform(argv, argv + argc, std::back_inserter(words), [](const char *word) { return decodePath(word); });
    if (words.isEmpty()) words += QStringLiteral("physics-inspector");
    return words;
}

/// The exit status: `status`, unless standard output lost data. A closed pipe isn't an error.
int finished(OutputFile &out, int status, QTextStream &messages) {
    if (out.finish()) return status;
    if (!out.isUnread()) report(messages, out.problem());
    return std::max(status, 1);
}

/// The stream for progress: only if it is a terminal.
QTextStream *terminalOf(QTextStream &messages) { return isatty(STDERR_FILENO) ? &messages : nullptr; }

int runTradeOnTerminal(const Options &options, QTextStream &messages) {
    const std::unique_ptr<OutputFile> file = standardOutput();
    int status = 0;
    {
        QTextStream out(file.get());
        status = runTrade(options, {out, messages, terminalOf(messages)}, ui::writeTradePicture);
    }
    return finished(*file, status, messages);
}

/// The core writes SVG itself; other pictures need an application that can draw, but no screen.
bool needsToDraw(const Options &options) {
    const QString &plot = options.trade.plot;
    return !plot.isEmpty() && !plot.endsWith(QLatin1String(".svg"));
}

int runWithoutWindow(const Options &options, QTextStream &messages) {
    if (options.action == Options::Action::Trade) return runTradeOnTerminal(options, messages);
    const std::unique_ptr<OutputFile> out = standardOutput();
    return finished(*out, runHeadless(options, *out, messages, terminalOf(messages)), messages);
}

/// problem: why they can't be, if that was told already.
bool areWritten(QSettings &settings, const QString &problem, QTextStream &messages) {
    settings.sync();
    if (settings.status() != QSettings::AccessError) return true;
    if (problem.isEmpty())
        report(messages, quoted(settings.fileName()) + QStringLiteral(": settings can't be read or written"));
    return false;
}

int runWithWindow(const Options &options, QTextStream &messages) {
    QString error = ui::displayProblem(options);
    QString settingsProblem;
    QSettings settings(userSettingsFile(&settingsProblem), settingsFormat());
    if (!settingsProblem.isEmpty()) report(messages, settingsProblem);
    const std::unique_ptr<Session> session = error.isEmpty() ? Session::open(options, settings, &error) : nullptr;
    if (!session) {
        report(messages, error);
        return 2;
    }
    bool isRecorded = true;
    QObject::connect(session.get(), &Session::recordingFailed, session.get(), [&](const QString &reason) {
        isRecorded = false;
        report(messages, reason);
    });
    const int status = ui::runWindow(*session, options);
    const bool isWritten = options.csv.isEmpty() || ui::writeTableOfRun(*session, options, &error);
    if (!isWritten) report(messages, QStringLiteral("--csv: ") + error);
    const bool isRemembered = areWritten(settings, settingsProblem, messages);
    const SampleRing &samples = session->simulation().samples();
    if (!options.csv.isEmpty() && samples.hasLostSamples())
        report(messages, QStringLiteral("--csv: ") + spanOf(samples));
    if (endingSignal()) return statusAfter(endingSignal());
    const bool isAllKept = isWritten && isRemembered && (isRecorded || options.record.isEmpty());
    return isAllKept ? status : std::max(status, 1);
}

} // namespace

int main(int argc, char **argv) {
    keepStandardDescriptors();
    if (argc == 2 && std::strcmp(argv[1], kProbeOption) == 0) return probePlugin();
    noteEndingSignals();
    QCoreApplication::setApplicationName(QStringLiteral("physics-inspector"));
    QCoreApplication::setOrganizationName(QStringLiteral("libphysics"));
    const QStringList words = wordsOf(argc, argv);
    QTextStream messages(stderr);
    if (const QString problem = fileLimitProblem(); !problem.isEmpty()) {
        report(messages, problem);
        return 2;
    }
    int count = std::min(argc, 1); // Qt gets only the program's name

    auto withoutDisplay = std::make_unique<QCoreApplication>(count, argv);
    const CommandLine line = parseCommandLine(words, loadProbedPlugin);
    messages << line.error << Qt::flush;
    if (line.exitStatus) {
        const std::unique_ptr<OutputFile> out = standardOutput();
        out->write(line.output.toUtf8());
        return finished(*out, *line.exitStatus, messages);
    }
    if (line.options.headless && !needsToDraw(line.options)) return runWithoutWindow(line.options, messages);

    withoutDisplay.reset();
    if (line.options.headless) qputenv("QT_QPA_PLATFORM", "offscreen");
    const auto application = ui::makeApplication(count, argv);
    return line.options.headless ? runWithoutWindow(line.options, messages) : runWithWindow(line.options, messages);
}
