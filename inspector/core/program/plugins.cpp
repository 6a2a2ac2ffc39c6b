// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/plugins.h"

#include "core/engine/engine.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <QCoreApplication>
#include <QProcess>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

namespace inspector {

namespace {

constexpr int kMostMilliseconds = 10'000;

/// Exit statuses of the probe that a plugin is unlikely to use itself.
enum ProbeStatus { kLoads = 81, kRefused = 82 };

/// Probes a file in another process. Returns why it can't be loaded; empty if it can.
QString probe(const QString &path) {
    QProcess process;
    process.setProcessChannelMode(QProcess::SeparateChannels);
    process.start(QCoreApplication::applicationFilePath(), {QString::fromLatin1(kProbeOption)});
    process.write(encodePath(path));
    process.closeWriteChannel();
    const QString file = quoted(path) + QStringLiteral(": ");
    if (!process.waitForFinished(kMostMilliseconds)) {
        if (process.error() == QProcess::FailedToStart) return file + QStringLiteral("no process to try it in");
        process.kill();
        process.waitForFinished();
        return file + QStringLiteral("loading it doesn't end within %1 s").arg(kMostMilliseconds / 1000);
    }
    const int status = process.exitCode();
    if (process.exitStatus() == QProcess::CrashExit) // the exit code is the signal
        return file + QStringLiteral("loading it ends a process by signal %1, %2").arg(status).arg(strsignal(status));
    if (status == kRefused) return oneLine(decodePath(process.readAllStandardOutput()));
    if (status != kLoads) return file + QStringLiteral("loading it ends a process with status %1").arg(status);
    return {};
}

/// A scene with a floor, and a wall that the ball touches.
constexpr char kMaze[] = "physics-maze 1\nunits m\nball 0.006\nstart 0 0 0.006\nbox -0.1 -0.1 -0.01 0.1 0.1 0\n"
                         "box 0.006 -0.1 0 0.01 0.1 0.02\n";

/// Makes a step with each of the plugin's steppers, because a table may be valid and yet contain bad pointers. The
/// results of the steps don't matter.
void tryStep(const Registry &registry) {
    phys_scene *made = nullptr;
    if (phys_scene_parse(kMaze, sizeof kMaze - 1, "trial", &made, nullptr) != PHYS_OK) return;
    const Scene scene(made, phys_scene_destroy);
    phys_stepper_info info;
    for (uint32_t i = phys_registry_count(nullptr); phys_registry_info(registry.get(), i, &info) == PHYS_OK; ++i) {
        const Stepper stepper = makeStepper(registry, info.id, scene, nullptr);
        if (!stepper) continue;
        phys_params params;
        phys_params_init(&params, sizeof params);
        phys_stepper_info_init_params(&info, &params);
        phys_state state;
        phys_scene_start(scene.get(), &state);
        phys_step(stepper.get(), &params, Engine::kDefaultDt, &state, &state, nullptr, nullptr);
    }
}

/// Results of phys_registry_scan().
struct Found {
    QStringList files;
    QStringList problems;
};

void note(void *context, const char *path, phys_status status, const char *text) {
    auto *found = static_cast<Found *>(context);
    if (status == PHYS_OK) {
        found->files += decodePath(path);
    } else {
        found->problems += oneLine(decodePath(text));
    }
}

} // namespace

bool loadProbedPlugin(const Registry &registry, const QString &path, QString *error) {
    const QString problem = probe(path);
    if (problem.isEmpty()) return loadPlugin(registry, path, error);
    if (error) *error = problem;
    return false;
}

/// A plugin's own output is discarded, and its crash leaves no core file.
int probePlugin() {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    const int answer = ::dup(STDOUT_FILENO);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, descriptor);
    QByteArray path;
    char buffer[4096];
    for (ssize_t count; (count = ::read(STDIN_FILENO, buffer, sizeof buffer)) > 0;) path.append(buffer, count);

    QString problem;
    const Registry registry = makeRegistry(&problem);
    if (registry && loadPlugin(registry, decodePath(path), &problem)) {
        tryStep(registry);
        return kLoads;
    }
    const QByteArray line = encodePath(problem);
    return ::write(answer, line.constData(), size_t(line.size())) == line.size() ? kRefused : EXIT_FAILURE;
}

Registry registryWith(const QStringList &plugins, PluginLoader load, QStringList *leftOut, QString *error) {
    Registry registry = makeRegistry(error);
    if (!registry) return {};
    for (const QString &path : plugins)
        if (!load(registry, path, error)) return {};
    Found found;
    phys_registry_scan(nullptr, nullptr, note, &found, nullptr);
    *leftOut = found.problems;
    QStringList tried = plugins;
    for (const QString &path : found.files) {
        const auto isFile = [&](const QString &plugin) { return isSameFile(plugin, path); };
        if (std::any_of(tried.begin(), tried.end(), isFile)) continue; // a folder may be named twice
        tried += path;
        QString problem;
        if (!load(registry, path, &problem)) *leftOut += problem;
    }
    return registry;
}

} // namespace inspector
