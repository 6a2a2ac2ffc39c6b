// SPDX-License-Identifier: GPL-3.0-or-later
// The program with a window: the functions that main() calls.
#pragma once

#include <QString>

#include <memory>

class QApplication;

namespace inspector {
class Session;
struct Options;
} // namespace inspector

namespace inspector::ui {

/// Makes the application, set up for the OpenGL that this program needs. Without a display it ends the program with
/// status 2 and one line, where Qt would abort. argc, argv must outlive it.
std::unique_ptr<QApplication> makeApplication(int &argc, char **argv);

/// Empty if a window can be drawn on this display; otherwise one line. In the latter case Qt would crash when showing a
/// window.
QString displayProblem(const Options &options);

/// Shows the window and runs the event loop until it ends; returns the exit status. With --autopilot the game starts by
/// itself. With --grab or --duration the window closes by itself: after --duration if given, otherwise when the level
/// is won (--autopilot) or after a few pictures.
int runWindow(Session &session, const Options &options);

} // namespace inspector::ui
