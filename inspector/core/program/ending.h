// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a run from outside: Ctrl+C, the system's shutdown, the end of a session. What was written until then is kept.
#pragma once

namespace inspector {

// From now on SIGINT, SIGTERM and SIGHUP are noted instead of killing the program; a second one kills it. One that is
// ignored (nohup) stays so. A closed pipe or a limit of file sizes is an error of writing then, no signal.
void noteEndingSignals();

// The signal that came; 0: none. Any thread.
int endingSignal();

// Readable once a signal came; for an event loop. -1 before noteEndingSignals().
int endingDescriptor();

// The program's exit status after a signal, by the shell's custom.
inline int statusAfter(int signal) { return 128 + signal; }

} // namespace inspector
