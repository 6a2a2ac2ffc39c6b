// SPDX-License-Identifier: MIT
#include "isolation.h"

#include "surroundings.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace plugin_check {

namespace {

/// A plugin must not print, and must leave the process as it is: output to standard output or error during a part, and
/// process state that differs after it, are faults of their own.
Measure silently(const std::function<Measure()> &work) {
    const int said = memfd_create("said", 0);
    dup2(said, STDOUT_FILENO);
    dup2(said, STDERR_FILENO);
    const Surroundings before;
    Measure measure = work();
    const std::string changes = before.changes();
    if (!changes.empty()) measure = {true, measure.text + changes};
    std::fflush(nullptr);
    char text[60] = "";
    const ssize_t length = pread(said, text, sizeof text, 0);
    if (length <= 0) return measure;
    const std::string_view all(text, static_cast<size_t>(length));
    return {true, measure.text + "; prints '" + std::string(all.substr(0, all.find('\n'))) + "'"};
}

} // namespace

Measure Isolation::run(const std::function<Measure()> &work, int seconds) const {
    const auto before = static_cast<int>((std::chrono::steady_clock::now() - m_begin) / std::chrono::seconds(1));
    const std::string isOver = " when the card's " + std::to_string(m_seconds) + " s were over";
    if (before >= m_seconds) return {false, "not begun" + isOver, true};
    const int most = std::min(seconds, m_seconds - before);
    int ends[2];
    if (pipe(ends)) return {true, "no pipe"};
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        alarm(static_cast<unsigned>(most));
        const auto busy = static_cast<rlim_t>(most); // for a plugin that ends the alarm
        const rlimit cpu{busy, busy + 1};
        setrlimit(RLIMIT_CPU, &cpu);
        const Measure measure = silently(work);
        const std::string text = (measure.isWrong ? "1" : "0") + measure.text;
        size_t written = 0;
        while (written < text.size()) {
            const ssize_t count = write(ends[1], text.data() + written, text.size() - written);
            if (count <= 0) break;
            written += static_cast<size_t>(count);
        }
        _exit(0);
    }
    close(ends[1]);
    std::string text;
    char buffer[4096];
    for (ssize_t count; (count = read(ends[0], buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<size_t>(count));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        const bool isLate = signal == SIGALRM || signal == SIGXCPU;
        if (isLate && most < seconds) return {false, "not done" + isOver, true};
        if (isLate) return {true, "not done after " + std::to_string(most) + " s"};
        return {true, std::string("crashes: ") + strsignal(signal)};
    }
    if (text.empty()) return {true, "ends without a word, or closes the pipe for it"};
    return {text[0] == '1', text.substr(1)};
}

} // namespace plugin_check
