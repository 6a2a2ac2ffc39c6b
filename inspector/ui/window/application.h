// SPDX-License-Identifier: GPL-3.0-or-later
// The program with a window, from the outside: what main() calls.
#pragma once

#include <QString>

#include <memory>

class QApplication;

namespace inspector {
class Session;
struct Options;
} // namespace inspector

namespace inspector::ui {

// The application, whose views ask for the OpenGL that this program draws with. Where no display can be opened it ends
// the program with status 2 and one line: Qt would abort. argc, argv: outlive it.
std::unique_ptr<QApplication> makeApplication(int &argc, char **argv);

// Empty if a window can be drawn on this display; else one line. Qt would crash in the window.
QString displayProblem(const Options &options);

// Shows the window and runs the event loop until it ends; the program's exit status. With --autopilot the game starts
// by itself. With --grab or --duration the window closes by itself: after --duration if given, else when the level is
// won (--autopilot) or after a few pictures.
int runWindow(Session &session, const Options &options);

} // namespace inspector::ui
