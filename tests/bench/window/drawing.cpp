// SPDX-License-Identifier: MIT
// The cost of the inspector's window: from the program's start to the first picture, while idle, and per picture while
// the ball rolls on a still board and on one that turns all the time. Needs a screen.
#include "core/session/session.h"
#include "gl/view/maze_view.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

using namespace inspector;

namespace {

constexpr int kMeasured = 5000; // ms
constexpr int kLook = 10;       // ms
constexpr int kSettled = 1500;  // ms, before it

double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// s, to 0.01, since this process began: proc(5), stat, the 22nd field.
double ageSeconds() {
    QFile file(QStringLiteral("/proc/self/stat"));
    if (!file.open(QIODevice::ReadOnly)) return 0.0;
    const QByteArray text = file.readAll();
    const double began = text.mid(text.lastIndexOf(')') + 2).split(' ').value(19).toDouble();
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec) - began / double(sysconf(_SC_CLK_TCK));
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct Cost {
    double cpu;   // s, for a second
    double rate;  // pictures in a second
    double drawn; // ms, median of what the view says of its pictures
    double each;  // ms of CPU time for a picture, all threads
};

Cost measure(gl::MazeView &view) {
    std::vector<double> drawn;
    const uint64_t first = view.pictures();
    uint64_t seen = first;
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        const uint64_t now = view.pictures();
        if (now != std::exchange(seen, now)) drawn.push_back(view.lastFrameMilliseconds());
    });
    look.start(kLook);
    QTimer::singleShot(kMeasured, &loop, &QEventLoop::quit);
    const double before = cpuSeconds();
    QElapsedTimer timer;
    timer.start();
    loop.exec(); // sleeps meanwhile, unlike processEvents() with a time
    const double cpu = cpuSeconds() - before;
    const double seconds = 1e-3 * double(timer.elapsed());
    const auto pictures = double(view.pictures() - first);
    return {cpu / seconds, pictures / seconds, median(drawn), pictures > 0 ? 1e3 * cpu / pictures : 0.0};
}

void showPictures(const char *quality, const char *board, const Cost &cost) {
    std::printf("| %s | %s | %.1f | %.1f | %.0f |\n", quality, board, cost.drawn, cost.each, cost.rate);
    std::fflush(stdout);
}

void rollOnStillBoard(Session &session) {
    session.setAutopilot(false);
    session.simulation().restart();
    session.parameters().set({{"tilt_x", 2.0}, {"tilt_y", 3.0}});
    session.simulation().run();
}

void rollByAutopilot(Session &session) {
    session.simulation().restart();
    session.setAutopilot(true);
    session.simulation().run();
}

} // namespace

int main(int argc, char **argv) {
    const auto application = ui::makeApplication(argc, argv);
    const QTemporaryDir folder;
    QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
    Options options;
    options.registry = makeRegistry(nullptr);
    options.levels = levelsIn(BENCH_LEVELS);
    options.level = options.levels.at(9);
    QString error;
    const std::unique_ptr<Session> session = Session::open(options, settings, &error);
    if (!session) return std::fprintf(stderr, "%s\n", qPrintable(error)), 1;
    ui::MainWindow window(*session);
    gl::MazeView &view = window.view();
    window.show();
    while (view.lastFrameMilliseconds() <= 0.0) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    std::printf("Start to picture: %.2f s, of CPU time %.2f s, by %s\n", ageSeconds(), cpuSeconds(),
                qPrintable(view.rendererName()));
    QTest::qWait(kSettled);
    std::printf("Paused: %.1f %% of one core\n\n", 1e2 * measure(view).cpu);
    std::printf("| quality | board | drawing, ms | CPU a picture, ms | pictures a second |\n|---|---|---|---|---|\n");
    const std::pair<gl::Quality, const char *> qualities[] = {
        {gl::Quality::Low, "Low"}, {gl::Quality::Medium, "Medium"}, {gl::Quality::High, "High"}};
    for (const auto &[quality, name] : qualities) {
        view.setQuality(quality);
        rollOnStillBoard(*session);
        QTest::qWait(kSettled);
        showPictures(name, "still", measure(view));
        rollByAutopilot(*session);
        QTest::qWait(kSettled);
        showPictures(name, "turning", measure(view));
    }
    return 0;
}
