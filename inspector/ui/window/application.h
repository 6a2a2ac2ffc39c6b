// SPDX-License-Identifier: GPL-3.0-or-later
// The program with a window, from the outside: what main() calls.
#pragma once

namespace inspector {
class Session;
struct Options;
} // namespace inspector

namespace inspector::ui {

// Before the QApplication exists: the OpenGL that every view of this program asks for.
void prepareApplication();

// Shows the window and runs the event loop until it ends; the program's exit status. With --autopilot the game starts
// by itself. With --grab or --duration the window closes by itself: after --duration if given, else when the level is
// won (--autopilot) or after a few pictures.
int runWindow(Session &session, const Options &options);

} // namespace inspector::ui
