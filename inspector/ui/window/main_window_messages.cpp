// SPDX-License-Identifier: GPL-3.0-or-later
// What is said in the message bar and in the status line, and when it is settled.
#include "core/setup/lines.h"
#include "core/setup/settings_file.h"
#include "gl/view/maze_view.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parts/message_bar.h"
#include "ui/window/main_window.h"

#include <QStatusBar>

#include <utility>

namespace inspector::ui {

void MainWindow::sayBriefly(const QString &line) {
    constexpr int kSaidFor = 8000; // ms
    statusBar()->showMessage(line, kSaidFor);
    m_isJustSaid = true;
    QTimer::singleShot(0, this, [this] { m_isJustSaid = false; });
}

/// A successful command settles an earlier failure and what an earlier command said.
void MainWindow::obey(void (MainWindow::*command)()) {
    const uint64_t count = m_messages->count();
    (this->*command)();
    if (m_messages->count() != count) return;
    m_messages->settle(Cause::Command);
    settleSaid();
}

void MainWindow::settleCommand() {
    m_messages->settle(Cause::Command);
    m_messages->settle(Cause::Step);
    settleSaid();
}

/// What the command itself said stays.
void MainWindow::settleSaid() {
    if (!m_isJustSaid) statusBar()->clearMessage();
}

/// Changes made by a replay, the past or the keys aren't commands.
void MainWindow::settleByChange() {
    if (!m_session.isReplaying() && !m_session.isInPast() && !m_session.isTiltedByKeys()) settleCommand();
}

/// Connects each message with the event that settles it. Problems of the stepping thread are settled by its own
/// signals, which keep their order, or by the user; a snapshot may be older or newer than the message.
void MainWindow::connectMessages() {
    const auto say = [this](Cause cause) {
        return [this, cause](const QString &line) { m_messages->showLine(line, cause); };
    };
    const auto settle = [this](Cause cause) { return [this, cause] { m_messages->settle(cause); }; };
    connect(&m_session, &Session::failed, this, say(Cause::Command));
    for (const auto signal : {&Session::levelOpened, &Session::stepperChanged, &Session::paceChanged})
        connect(&m_session, signal, this, &MainWindow::settleByChange);
    for (const auto signal : {&Session::autopilotChanged, &Session::replayChanged})
        connect(&m_session, signal, this, &MainWindow::settleCommand);
    connect(&m_session.parameters(), &Parameters::changed, this, &MainWindow::settleByChange);
    connect(&m_session.simulation(), &Simulation::failed, this, say(Cause::Step));
    connect(&m_session.simulation(), &Simulation::runBegan, this, settle(Cause::Step));
    connect(&m_session.simulation(), &Simulation::runningChanged, this, [this](bool isRunning) {
        if (isRunning) m_messages->settle(Cause::Step);
    });

    connect(m_parameters, &ParameterPanel::refused, this, say(Cause::Command));
    connect(m_parameters, &ParameterPanel::saved, this, &MainWindow::sayItIsSaved);
    connect(&m_session.comparison().parameters(), &Parameters::changed, this, &MainWindow::settleCommand);
    connect(m_view, &gl::MazeView::problem, this, say(Cause::View));
    connect(m_view, &gl::MazeView::shadersRebuilt, this, settle(Cause::View));
    connect(&m_session.comparison(), &Comparison::refused, this, say(Cause::Comparison));
    connect(&m_session.comparison(), &Comparison::changed, this, [this] {
        if (m_session.comparison().refusal().isEmpty()) m_messages->settle(Cause::Comparison);
    });
    connect(&m_session, &Session::recordingFailed, this, say(Cause::Recording));
    connect(&m_session, &Session::recordingChanged, this, [this](bool isOn) {
        if (isOn) m_messages->settle(Cause::Recording);
    });
    connect(&m_session, &Session::trackChanged, this, [this] {
        if (m_session.track()) m_messages->settle(Cause::Command);
    });
    connect(&m_session, &Session::replayChanged, this, settle(Cause::Replay));
    connect(&m_session, &Session::replayDiffers, m_messages, [this](const QString &line) {
        if (m_messages->line() != line) m_messages->showLine(line, Cause::Replay);
    });
}

void MainWindow::sayWhyFlat(const QString &reason) {
    m_messages->showLine(tr("%1; the board is drawn from above instead").arg(reason), Cause::View);
}

/// Once. Qt writes a change as soon as events are handled, and keeps the status.
void MainWindow::sayIfSettingsAreLost() {
    const QSettings &settings = m_session.settings();
    if (settings.status() != QSettings::AccessError || std::exchange(m_hasSaidSettingsAreLost, true)) return;
    m_messages->showLine(tr("%1: settings can't be written; changes, best times and the layout are lost when this "
                            "window is closed")
                             .arg(quoted(shownFileOf(settings))),
                         Cause::Settings);
}

} // namespace inspector::ui
