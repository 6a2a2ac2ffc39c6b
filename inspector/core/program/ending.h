// SPDX-License-Identifier: GPL-3.0-or-later
// Termination from outside: Ctrl+C, shutdown, end of session. What was written before is kept.
#pragma once

namespace inspector {

/// From now on SIGINT, SIGTERM and SIGHUP are recorded instead of ending the program; a second one ends it. Signals
/// that are ignored (nohup) stay ignored. A closed pipe or the file size limit becomes a write error instead of a
/// signal.
void noteEndingSignals();

/// The signal received; 0: none. Any thread.
int endingSignal();

/// A descriptor that is readable after a signal, for an event loop. -1 before noteEndingSignals().
int endingDescriptor();

/// The exit status after a signal, as shells report it.
inline int statusAfter(int signal) { return 128 + signal; }

} // namespace inspector
