// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/ending.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <initializer_list>

namespace inspector {

namespace {

volatile std::sig_atomic_t signalSeen = 0;
int pipeEnds[2] = {-1, -1};

void note(int signal) {
    const int before = errno;
    signalSeen = signal;
    const char byte = 0;
    if (::write(pipeEnds[1], &byte, 1) < 0) { // the pipe is full, so it is readable anyway
    }
    errno = before;
}

} // namespace

void noteEndingSignals() {
    // Turn these signals into write errors, which the writer reports: a closed pipe, or the file size limit.
    for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_IGN);
    if (pipeEnds[0] >= 0 || ::pipe2(pipeEnds, O_CLOEXEC | O_NONBLOCK) != 0) return;
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
        struct sigaction action {};
        action.sa_handler = note;
        action.sa_flags = int(SA_RESETHAND | SA_RESTART);
        ::sigaction(number, &action, nullptr);
    }
}

int endingSignal() { return signalSeen; }

int endingDescriptor() { return pipeEnds[0]; }

} // namespace inspector
