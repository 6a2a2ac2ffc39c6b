// SPDX-License-Identifier: GPL-3.0-or-later
// The table of actions, and what most of them do.
#include "gl/view/maze_view.h"
#include "ui/bounces/bounce_dock.h"
#include "ui/game/game_strip.h"
#include "ui/help/help_dialogs.h"
#include "ui/input/keyboard_focus.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/settings_keys.h"
#include "ui/transport/time_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/ruler.h"

#include <QAction>
#include <QDockWidget>
#include <QUndoStack>

#include <optional>

namespace inspector::ui {

namespace {
constexpr double kCameraPixels = 20.0; ///< of a drag, per press of a key
}

;

std::vector<MainWindow::ActionRow> MainWindow::fileRows() {
    return {
        {"open", QT_TR_NOOP("Open maze file…"), "Ctrl+O", QT_TR_NOOP("A maze as a text file"),
         &MainWindow::openMazeFile},
        {"open_recording", QT_TR_NOOP("Open recording…"), "Ctrl+Shift+O", QT_TR_NOOP("Watch a recorded run"),
         &MainWindow::openRecording},
        {"open_track", QT_TR_NOOP("Open measured ball…"), "",
         QT_TR_NOOP("A table of a ball that was filmed, to be laid over the run"), &MainWindow::askForTrack},
        {"load_plugin", QT_TR_NOOP("Load plugin…"), "",
         QT_TR_NOOP("Steppers of a plugin file, to be chosen like the others"), &MainWindow::askForPlugin},
        {"close_recording", QT_TR_NOOP("Close recording"), "Ctrl+W",
         QT_TR_NOOP("Back to the start of the level from before"), &MainWindow::closeRecording, Glyph::Close},
        {"save_run", QT_TR_NOOP("Save run…"), "Ctrl+S",
         QT_TR_NOOP("What was just seen, as a recording, a table of all samples or a picture"), &MainWindow::saveRun},
        {"save_film", QT_TR_NOOP("Save film…"), "Ctrl+Shift+F",
         QT_TR_NOOP("The last seconds as a film, or as pictures in a folder"), &MainWindow::saveFilm},
        {"save_plot", QT_TR_NOOP("Save plot…"), "Ctrl+Shift+S", QT_TR_NOOP("As PNG, PDF or CSV: the one that is seen"),
         &MainWindow::savePlot},
        {"screenshot", QT_TR_NOOP("Save picture of the window…"), "Ctrl+P", "", &MainWindow::saveScreenshot},
        {"record", QT_TR_NOOP("Record…"), "",
         QT_TR_NOOP("Write the run into a file that repeats it, until chosen again"), &MainWindow::toggleRecording},
        {"quit", QT_TR_NOOP("Quit"), "Ctrl+Q", "", &MainWindow::quit},
    };
}

std::vector<MainWindow::ActionRow> MainWindow::viewRows() {
    return {
        {"reset_parameters", QT_TR_NOOP("Reset all parameters"), "Ctrl+R",
         QT_TR_NOOP("Every parameter back to its default"), &MainWindow::resetParameters},
        {"reset_layout", QT_TR_NOOP("Reset layout"), "", QT_TR_NOOP("All docks back to where they were at first"),
         &MainWindow::resetLayout},
        {"camera_reset", QT_TR_NOOP("Camera: everything"), "Home", QT_TR_NOOP("Show the whole board from the front"),
         &MainWindow::resetCamera},
        {"camera_top", QT_TR_NOOP("Camera: from above"), "T", "", &MainWindow::lookFromAbove},
        {"camera_follow", QT_TR_NOOP("Camera: follow the ball"), "F",
         QT_TR_NOOP("Keep the ball in the middle, from nearer by"), &MainWindow::toggleFollowing},
        {"bounces", QT_TR_NOOP("Show bounces"), "B", QT_TR_NOOP("A mark where the ball has bounced; click it"),
         &MainWindow::toggleBounces},
        {"way_ahead", QT_TR_NOOP("Show the way ahead"), "W",
         QT_TR_NOOP("Where the ball goes in the next 2 s if nothing changes, by the exact stepper"),
         &MainWindow::toggleWayAhead},
        {"others_ahead", QT_TR_NOOP("Show what isn't known ahead"), "U",
         QT_TR_NOOP("While paused: where else the ball may go, as little as tilt, friction, restitution and start are "
                    "known; the Trade dock says within what"),
         &MainWindow::toggleOthersAhead},
        {"next_part", QT_TR_NOOP("Keyboard to the next part"), "F6",
         QT_TR_NOOP("From the board to the docks that are open, and back"), &MainWindow::goToNextPart},
        {"previous_part", QT_TR_NOOP("Keyboard to the part before"), "Shift+F6", "", &MainWindow::goToPartBefore},
    };
}

std::vector<MainWindow::ActionRow> MainWindow::cameraRows() {
    return {
        {"camera_left", QT_TR_NOOP("Camera: turn the board left"), "Alt+Left", "", &MainWindow::turnLeft},
        {"camera_right", QT_TR_NOOP("Camera: turn the board right"), "Alt+Right", "", &MainWindow::turnRight},
        {"camera_higher", QT_TR_NOOP("Camera: higher"), "Alt+Up", "", &MainWindow::lookFromHigher},
        {"camera_lower", QT_TR_NOOP("Camera: lower"), "Alt+Down", "", &MainWindow::lookFromLower},
        {"camera_nearer", QT_TR_NOOP("Camera: nearer"), "Alt++; Alt+=", "", &MainWindow::lookFromNearer},
        {"camera_farther", QT_TR_NOOP("Camera: farther"), "Alt+-", "", &MainWindow::lookFromFarther},
    };
}

std::vector<MainWindow::ActionRow> MainWindow::runRows() {
    return {
        {"play", QT_TR_NOOP("Start, or next level"), "Return; Enter", "", &MainWindow::confirm},
        {"run", QT_TR_NOOP("Run"), "Space", QT_TR_NOOP("Run or pause"), &MainWindow::toggleRunning, Glyph::Run},
        {"pause", QT_TR_NOOP("Pause"), "Esc", "", &MainWindow::pause},
        {"step", QT_TR_NOOP("Single step"), ".", QT_TR_NOOP("Make one step of dt and pause"), &MainWindow::stepOnce,
         Glyph::Step},
        {"step_back", QT_TR_NOOP("Step back"), ",", QT_TR_NOOP("Look at the step before"), &MainWindow::stepBack,
         Glyph::StepBack},
        {"bounce_back", QT_TR_NOOP("Previous bounce"), "Ctrl+Left", QT_TR_NOOP("Look at the bounce before"),
         &MainWindow::bounceBack, Glyph::BounceBack},
        {"bounce_on", QT_TR_NOOP("Next bounce"), "Ctrl+Right", QT_TR_NOOP("Look at the next bounce"),
         &MainWindow::bounceOn, Glyph::BounceOn},
        {"restart", QT_TR_NOOP("Restart"), "R", QT_TR_NOOP("The ball back to the start; the run is kept"),
         &MainWindow::restart, Glyph::Restart},
        {"to_start", QT_TR_NOOP("To the beginning"), "Ctrl+Home", QT_TR_NOOP("Look at the beginning of the run"),
         &MainWindow::goToStart, Glyph::Begin},
        {"end", QT_TR_NOOP("To the end"), "Ctrl+End", QT_TR_NOOP("Back to the present, or to the end of a recording"),
         &MainWindow::goToEnd, Glyph::End},
        {"go_on", QT_TR_NOOP("Go on from here"), "G", QT_TR_NOOP("Play on from the moment shown"),
         &MainWindow::goOnFromHere},
        {"autopilot", QT_TR_NOOP("Autopilot"), "A", QT_TR_NOOP("Let the program tilt the board"),
         &MainWindow::toggleAutopilot, Glyph::Autopilot},
    };
}

std::vector<MainWindow::ActionRow> MainWindow::ghostRows() {
    return {
        {"compare", QT_TR_NOOP("Compare"), "C",
         QT_TR_NOOP("Let a second ball, moved by another stepper, start where the ball is"),
         &MainWindow::toggleComparison},
        {"meet_again", QT_TR_NOOP("Meet again"), "M", QT_TR_NOOP("Put the ghost back onto the ball"),
         &MainWindow::meetAgain},
        {"ghost_parameters", QT_TR_NOOP("Ghost's own parameters"), "Shift+C",
         QT_TR_NOOP("Let the ghost have other parameters than the ball: sliders of its own"),
         &MainWindow::toggleGhostParameters},
        {"copy_to_ghost", QT_TR_NOOP("Copy to ghost"), "Shift+X", QT_TR_NOOP("Give the ghost the ball's parameters"),
         &MainWindow::copyToGhost},
        {"swap_with_ghost", QT_TR_NOOP("Swap with ghost"), "X",
         QT_TR_NOOP("Exchange the ball's parameters and the ghost's"), &MainWindow::swapWithGhost},
    };
}

std::vector<MainWindow::ActionRow> MainWindow::helpRows() {
    return {
        {"keys", QT_TR_NOOP("Keys"), "F1", "", &MainWindow::showKeys},
        {"page_inspector", QT_TR_NOOP("Guide to this window"), "Shift+F1", QT_TR_NOOP("What all of it does"),
         &MainWindow::showGuide},
        {"page_model", QT_TR_NOOP("The model: equations"), "", QT_TR_NOOP("What is computed, with derivations"),
         &MainWindow::showModelPage},
        {"page_accuracy", QT_TR_NOOP("How accurate it is"), "", QT_TR_NOOP("How far to trust the numbers"),
         &MainWindow::showAccuracyPage},
        {"about", QT_TR_NOOP("About"), "", "", &MainWindow::showAbout},
    };
}

const std::vector<MainWindow::ActionRow> &MainWindow::actionRows() {
    static const std::vector<ActionRow> rows = [] {
        std::vector<ActionRow> all;
        for (const auto &part : {fileRows(), viewRows(), cameraRows(), runRows(), ghostRows(), helpRows()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return rows;
}

void MainWindow::makeActions() {
    for (const ActionRow &row : actionRows()) {
        auto *made = new QAction(tr(row.text), this);
        made->setObjectName(QLatin1String(row.name));
        made->setShortcuts(QKeySequence::listFromString(QLatin1String(row.keys)));
        if (row.glyph) made->setIcon(glyphIcon(*row.glyph));
        const QString tip = tr(*row.tip ? row.tip : row.text);
        made->setToolTip(*row.keys ? tr("%1 (%2)").arg(tip, made->shortcut().toString(QKeySequence::NativeText)) : tip);
        connect(made, &QAction::triggered, this, [this, run = row.run] { obey(run); });
        addAction(made);
    }
    action("autopilot")->setCheckable(true);
    action("record")->setCheckable(true);
    action("compare")->setCheckable(true);
    action("ghost_parameters")->setCheckable(true);
    action("camera_follow")->setCheckable(true);
    action("way_ahead")->setCheckable(true);
    action("way_ahead")->setChecked(m_session.settings().value(settings_keys::kShowWayAhead, true).toBool());
    action("others_ahead")->setCheckable(true);
    action("copy_to_ghost")->setIconText(tr("Copy")); // for buttons
    action("swap_with_ghost")->setIconText(tr("Swap"));
    m_run = action("run");
    m_showsBounces = action("bounces");
    m_showsBounces->setCheckable(true);
    m_showsBounces->setChecked(m_session.settings().value(settings_keys::kShowBounces, true).toBool());
}

void MainWindow::closeRecording() { m_session.closeRecording(); }

/// Enables the actions of a replay or of the live ball.
void MainWindow::showReplay(bool isOn) {
    for (const char *name : {"close_recording", "go_on"}) action(name)->setEnabled(isOn);
    for (const char *name : {"play", "autopilot", "reset_parameters"}) action(name)->setEnabled(!isOn);
    findChild<QDockWidget *>(QStringLiteral("parameters_dock"))
        ->setWindowTitle(isOn ? tr("Parameters, as recorded") : tr("Parameters"));
    m_undo->clear(); // its commands refer to what is no longer there
    showComparison();
    m_time->reset();
    watchMaze();
    showTitle();
    m_view->setFocus();
    if (!isOn) return;
    const PlayableRecording &recording = m_session.replay()->recording();
    if (recording.recording().isWhole) return;
    m_messages->showLine(tr("%1: the recording was interrupted; it ends after %2 steps")
                             .arg(recording.recording().file)
                             .arg(recording.length()),
                         Cause::Replay);
}

void MainWindow::showPast(bool isIn) {
    action("go_on")->setEnabled(isIn);
    watchMaze();
}

/// The time bar begins at the moment taken over. This isn't said in the message bar, which would move the view while
/// the player acts.
void MainWindow::sayWhereTheRunIs() {
    const QKeySequence key = action("show_runs_dock")->shortcut();
    sayOfTheBall(tr("What came before this moment, and after it, is in Runs (%1)").arg(key.toString()));
}

void MainWindow::sayWhereTheRunBeforeIs() {
    sayOfTheBall(tr("The run before is in Runs (%1)").arg(action("show_runs_dock")->shortcut().toString()));
}

void MainWindow::sayTheBallIsBack() { sayOfTheBall(tr("The ball is back where it was")); }

/// Where the ball goes on from another state, so does the ghost.
void MainWindow::sayOfTheBall(const QString &line) {
    sayBriefly(m_session.comparison().isOn() ? tr("%1; the ghost starts at the ball again").arg(line) : line);
}

void MainWindow::quit() { close(); }
void MainWindow::resetParameters() { m_parameters->resetAll(); }
void MainWindow::resetCamera() { m_view->resetCamera(); }

void MainWindow::toggleBounces() {
    m_session.settings().setValue(settings_keys::kShowBounces, m_showsBounces->isChecked());
    m_view->update();
}

void MainWindow::toggleWayAhead() {
    const bool isOn = action("way_ahead")->isChecked();
    m_session.settings().setValue(settings_keys::kShowWayAhead, isOn);
    m_session.lookAhead().show(isOn);
}

void MainWindow::toggleOthersAhead() { m_session.lookAhead().showOthers(action("others_ahead")->isChecked()); }

void MainWindow::goToNextPart() { moveKeyboard(*this, *m_view, 1); }
void MainWindow::goToPartBefore() { moveKeyboard(*this, *m_view, -1); }

void MainWindow::confirm() { m_session.game().confirm(); }

/// Esc first dismisses a result; while paused it then clears the selection.
void MainWindow::pause() {
    if (m_ruler->dismiss()) return;
    if (m_strip->dismiss()) return;
    if (m_session.isInPast() && !m_session.simulation().latest().running) return m_session.returnToPresent();
    if (!m_session.simulation().latest().running) m_bounces->clearSelection();
    m_session.simulation().pause();
}

void MainWindow::stepOnce() { m_session.simulation().stepOnce(); }

void MainWindow::stepBack() {
    if (m_session.isReplaying()) return m_session.simulation().stepBack();
    const RunPlace run = m_session.runPlace();
    if (run.place > run.begin) m_session.lookAt(run.place - 1);
}

void MainWindow::goToStart() {
    if (Playback *replay = m_session.replay()) return replay->seek(0);
    const RunPlace run = m_session.runPlace();
    if (run.place > run.begin) m_session.lookAt(run.begin);
}

void MainWindow::goToEnd() {
    if (Playback *replay = m_session.replay()) return replay->seek(replay->recording().length());
    m_session.returnToPresent();
}

void MainWindow::bounceBack() { jumpToBounce(Direction::Back); }
void MainWindow::bounceOn() { jumpToBounce(Direction::On); }

void MainWindow::jumpToBounce(Direction direction) {
    const std::optional<double> found = m_session.lookAtNearest(m_bounces->bounceTimes(), direction);
    if (found) m_bounces->selectAt(*found);
}

void MainWindow::goOnFromHere() {
    if (!m_session.isInPast()) return m_session.goOnFromHere();
    m_session.awaitMoment(); // G right after a step back
    m_session.takeOver();
    m_session.simulation().run();
}

void MainWindow::toggleRunning() {
    Simulation &simulation = m_session.simulation();
    simulation.latest().running ? simulation.pause() : simulation.run();
}

void MainWindow::restart() { m_session.restart(); }

void MainWindow::toggleAutopilot() {
    m_session.setAutopilot(!m_session.hasAutopilot());
    action("autopilot")->setChecked(m_session.hasAutopilot()); // resets it after a refusal
}

void MainWindow::toggleComparison() { m_session.comparison().setOn(!m_session.comparison().isOn()); }
void MainWindow::meetAgain() { m_session.comparison().meetAgain(); }

void MainWindow::toggleGhostParameters() {
    m_session.comparison().setOwnParameters(action("ghost_parameters")->isChecked());
}

void MainWindow::copyToGhost() { m_parameters->copyToGhost(); }
void MainWindow::swapWithGhost() { m_parameters->swapWithGhost(); }

void MainWindow::turnLeft() { m_view->orbit({-kCameraPixels, 0.0}); }
void MainWindow::turnRight() { m_view->orbit({kCameraPixels, 0.0}); }
void MainWindow::lookFromHigher() { m_view->orbit({0.0, kCameraPixels}); }
void MainWindow::lookFromLower() { m_view->orbit({0.0, -kCameraPixels}); }
void MainWindow::lookFromNearer() { m_view->zoom(1.0, QRectF(m_view->rect()).center()); }
void MainWindow::lookFromFarther() { m_view->zoom(-1.0, QRectF(m_view->rect()).center()); }
void MainWindow::lookFromAbove() { m_view->lookFromAbove(); }
void MainWindow::toggleFollowing() { m_view->setFollowing(action("camera_follow")->isChecked()); }

void MainWindow::showKeys() { showKeysDialog(*this); }
void MainWindow::showAbout() { showAboutDialog(*this, m_view->rendererName()); }

} // namespace inspector::ui
