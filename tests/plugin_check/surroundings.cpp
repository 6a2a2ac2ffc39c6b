// SPDX-License-Identifier: MIT
#include "surroundings.h"

#include <cfenv>
#include <cfloat>
#include <climits>
#include <clocale>
#include <cstring>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

namespace plugin_check {

namespace {

std::string environment() {
    std::string all;
    for (char **entry = environ; entry && *entry; ++entry) all += std::string(*entry) + '\n';
    return all;
}

std::string folder() {
    char path[PATH_MAX] = "";
    return getcwd(path, sizeof path) ? path : "";
}

mode_t fileMask() {
    const mode_t mask = umask(0);
    umask(mask);
    return mask;
}

bool hasAlarm() {
    itimerval timer{};
    getitimer(ITIMER_REAL, &timer);
    return timer.it_value.tv_sec > 0 || timer.it_value.tv_usec > 0;
}

bool isSame(const struct sigaction &a, const struct sigaction &b) {
    return a.sa_handler == b.sa_handler && a.sa_flags == b.sa_flags;
}

} // namespace

Surroundings::Surroundings()
    : m_folder(folder())
    , m_locale(std::setlocale(LC_ALL, nullptr))
    , m_environment(environment())
    , m_mask(fileMask())
    , m_hasAlarm(hasAlarm()) {
    for (size_t i = 0; i < m_files.size(); ++i) {
        struct stat file {};
        m_files[i] = fstat(static_cast<int>(i), &file) == 0 ? File{file.st_dev, file.st_ino} : File{0, 0};
    }
    for (int i = 1; i < kSignals; ++i) sigaction(i, nullptr, &m_signals[static_cast<size_t>(i)]);
    pthread_sigmask(SIG_BLOCK, nullptr, &m_blocked);
}

std::string Surroundings::changes() const {
    const Surroundings now;
    std::string text;
    const auto note = [&](const std::string &change) { text += "; " + change; };
    for (size_t i = 0; i < m_files.size(); ++i) {
        if (now.m_files[i] == m_files[i]) continue;
        const bool wasOpen = m_files[i] != File{0, 0};
        const bool isOpen = now.m_files[i] != File{0, 0};
        const char *change = !isOpen ? "closes" : wasOpen ? "redirects" : "leaves open";
        note(std::string(change) + " file descriptor " + std::to_string(i));
        break; // the first one is enough
    }
    for (int i = 1; i < kSignals; ++i) {
        const auto number = static_cast<size_t>(i);
        if (!isSame(now.m_signals[number], m_signals[number])) note("takes the signal " + std::string(strsignal(i)));
        if (sigismember(&now.m_blocked, i) != sigismember(&m_blocked, i))
            note("blocks or unblocks the signal " + std::string(strsignal(i)));
    }
    if (now.m_folder != m_folder) note("changes the working directory to " + now.m_folder);
    if (now.m_locale != m_locale) note("changes the locale to " + now.m_locale);
    if (now.m_environment != m_environment) note("changes environment variables");
    if (now.m_mask != m_mask) note("changes the mask of new files' rights");
    if (now.m_hasAlarm != m_hasAlarm) note("changes the process's alarm");
    return text;
}

Arithmetic Arithmetic::now() {
    volatile double smallest = DBL_MIN;
    return {std::fegetround(), fegetexcept(), smallest / 2 != 0};
}

} // namespace plugin_check
