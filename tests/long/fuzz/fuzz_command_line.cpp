// SPDX-License-Identifier: MIT
// Any bytes as a command line, one word per line: options within their ranges, or lines that say what is wrong. Runs in
// an empty folder which no word can leave.
#include "core/program/command_line.h"
#include "core/setup/files.h"
#include "core/simulation/simulation.h"
#include "input.h"

#include <QCoreApplication>
#include <QDir>
#include <QTemporaryDir>

using namespace inspector;

namespace {

void check(const CommandLine &line) {
    for (const QString &text : line.error.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        fuzz::demand(text.startsWith(QLatin1String("physics-inspector: ")));
        fuzz::demand(!text.contains(QChar(0x1b)) && !text.contains(QLatin1Char('\r')));
    }
    if (line.exitStatus) return fuzz::demand(*line.exitStatus == 0 || (*line.exitStatus == 2 && !line.error.isEmpty()));
    const Options &options = line.options;
    fuzz::demand(options.dt >= Engine::kSmallestDt && options.dt <= Engine::kLargestDt);
    fuzz::demand(options.speed >= Simulation::kSlowest && options.speed <= Simulation::kFastest);
    fuzz::demand(!options.duration || (*options.duration >= 0.0 && *options.duration <= 1e9));
    fuzz::demand(options.csvEvery >= 1 && !options.trade.stepSizes.empty() && !options.stepper.isEmpty());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static char name[] = "fuzz_command_line";
    static char *arguments[] = {name, nullptr};
    static int count = 1;
    static const QCoreApplication application(count, arguments);
    static const QTemporaryDir folder;
    static const bool isThere = QDir::setCurrent(folder.path()) && qputenv("PHYSICS_LEVELS", "nowhere");
    fuzz::demand(isThere);
    QByteArray bytes(reinterpret_cast<const char *>(data), qsizetype(size));
    bytes.replace('/', '_').replace('\0', ' ');
    QStringList words{QStringLiteral("physics-inspector")};
    for (const QByteArray &word : bytes.split('\n')) words += decodePath(word);
    check(parseCommandLine(words));
    fuzz::demand(QDir(folder.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    return 0;
}
