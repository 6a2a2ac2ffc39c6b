// SPDX-License-Identifier: GPL-3.0-or-later
// Menus and their commands: one table of actions, and a few menus of choices.
#include "core/setup/lines.h"
#include "core/setup/stored_values.h"
#include "gl/view/maze_view.h"
#include "ui/bounces/bounce_dock.h"
#include "ui/comparison/comparison_dock.h"
#include "ui/comparison/distance_plot.h"
#include "ui/files/file_chooser.h"
#include "ui/game/game_strip.h"
#include "ui/input/keyboard_focus.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/path_icon.h"
#include "ui/parts/settings_keys.h"
#include "ui/parts/theme.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/track/track_dock.h"
#include "ui/trade/trade_dock.h"
#include "ui/transport/time_bar.h"
#include "ui/transport/transport_bar.h"
#include "ui/window/help_dialogs.h"
#include "ui/window/main_window.h"
#include "ui/window/ruler.h"
#include "ui/window/save_run.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QUndoStack>

#include <algorithm>
#include <optional>

namespace inspector::ui {

struct MainWindow::ActionRow {
    const char *name;
    const char *text;
    const char *keys; ///< as in QKeySequence, "; " between several
    const char *tip;
    void (MainWindow::*run)();
    std::optional<Glyph> glyph = {};
};

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
        for (const auto &part : {fileRows(), viewRows(), runRows(), ghostRows(), helpRows()})
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
    m_showsBounces = action("bounces");
    m_showsBounces->setCheckable(true);
    m_showsBounces->setChecked(m_session.settings().value(settings_keys::kShowBounces, true).toBool());
}

void MainWindow::makeMenus() {
    struct MenuRow {
        const char *title;
        std::vector<const char *> actions; // "" is a separator
    };
    const MenuRow rows[] = {
        {QT_TR_NOOP("&File"),
         {"open", "open_recording", "open_track", "close_recording", "", "load_plugin", "", "save_run", "save_film",
          "save_plot", "screenshot", "record", "", "quit"}},
        {QT_TR_NOOP("&Edit"), {"", "reset_parameters"}},
        {QT_TR_NOOP("&View"),
         {"", "camera_reset", "camera_top", "camera_follow", "", "bounces", "way_ahead", "others_ahead", "",
          "next_part", "previous_part"}},
        {QT_TR_NOOP("&Game"),
         {"play",
          "",
          "run",
          "restart",
          "",
          "step",
          "step_back",
          "bounce_back",
          "bounce_on",
          "to_start",
          "end",
          "go_on",
          "",
          "autopilot",
          "",
          "compare",
          "meet_again",
          "ghost_parameters",
          "copy_to_ghost",
          "swap_with_ghost"}},
        {QT_TR_NOOP("&Help"), {"keys", "page_inspector", "page_model", "page_accuracy", "", "about"}},
    };
    std::vector<QMenu *> menus;
    for (const MenuRow &row : rows) {
        QMenu *menu = menuBar()->addMenu(tr(row.title));
        menus.push_back(menu);
        for (const char *name : row.actions) {
            if (*name) menu->addAction(action(name));
            if (!*name) menu->addSeparator();
        }
    }
    addRecent(*menus[0]);
    addUndoActions(*menus[1]);
    addViewChoices(*menus[2]);
}

void MainWindow::addUndoActions(QMenu &menu) {
    QAction *undo = m_undo->createUndoAction(this);
    QAction *redo = m_undo->createRedoAction(this);
    undo->setShortcuts(QKeySequence::Undo);
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    menu.insertActions(menu.actions().constFirst(), {undo, redo});
    addActions({undo, redo}); // so that they are listed with the others
}

void MainWindow::addViewChoices(QMenu &menu) {
    QAction *const first = menu.actions().constFirst();
    for (const QDockWidget *dock : findChildren<QDockWidget *>())
        menu.insertAction(first, findChild<QAction *>(QStringLiteral("show_") + dock->objectName()));
    menu.insertAction(first, m_transport->toggleViewAction());
    menu.insertAction(first, action("reset_layout"));

    menu.addSeparator();
    addCameraMoves(*menu.addMenu(tr("Move the camera")));
    addChoice(*menu.addMenu(tr("Quality")), "quality", {tr("What comes in time"), tr("Low"), tr("Medium"), tr("High")},
              &MainWindow::quality, &MainWindow::chooseQuality);
    addChoice(*menu.addMenu(tr("Size of saved pictures")), "picture_scale",
              {tr("As the view"), tr("2 times"), tr("3 times"), tr("4 times")}, &MainWindow::pictureScale,
              &MainWindow::choosePictureScale);
    addChoice(*menu.addMenu(tr("Text size")), "text_size",
              {tr("As the system"), tr("Larger"), tr("Large"), tr("Double")}, &MainWindow::textSize,
              &MainWindow::chooseTextSize);
    addChoice(*menu.addMenu(tr("Theme")), "theme", {tr("As the system"), tr("Light"), tr("Dark")}, &MainWindow::theme,
              &MainWindow::chooseTheme);
}

/// What drags and the wheel do, by keys.
void MainWindow::addCameraMoves(QMenu &menu) {
    constexpr double kPixels = 20.0;
    struct MoveRow {
        const char *name, *text, *keys;
        QPointF drag;
        double zoom;
    };
    const MoveRow rows[] = {
        {"camera_left", QT_TR_NOOP("Camera: turn the board left"), "Alt+Left", {-kPixels, 0.0}, 0.0},
        {"camera_right", QT_TR_NOOP("Camera: turn the board right"), "Alt+Right", {kPixels, 0.0}, 0.0},
        {"camera_higher", QT_TR_NOOP("Camera: higher"), "Alt+Up", {0.0, kPixels}, 0.0},
        {"camera_lower", QT_TR_NOOP("Camera: lower"), "Alt+Down", {0.0, -kPixels}, 0.0},
        {"camera_nearer", QT_TR_NOOP("Camera: nearer"), "Alt++; Alt+=", {}, 1.0},
        {"camera_farther", QT_TR_NOOP("Camera: farther"), "Alt+-", {}, -1.0},
    };
    for (const MoveRow &row : rows) {
        QAction *move = menu.addAction(tr(row.text));
        move->setObjectName(QLatin1String(row.name));
        move->setShortcuts(QKeySequence::listFromString(QLatin1String(row.keys)));
        connect(move, &QAction::triggered, this, [this, drag = row.drag, zoom = row.zoom] {
            m_view->orbit(drag);
            m_view->zoom(zoom, QRectF(m_view->rect()).center());
        });
        addAction(move);
    }
}

void MainWindow::addChoice(QMenu &menu, const char *name, const QStringList &texts, int (MainWindow::*chosen)() const,
                           void (MainWindow::*choose)(int)) {
    auto *group = new QActionGroup(&menu);
    for (int i = 0; i < texts.size(); ++i) {
        QAction *choice = group->addAction(texts[i]);
        choice->setObjectName(QStringLiteral("%1_%2").arg(QLatin1String(name)).arg(i));
        choice->setCheckable(true);
        connect(choice, &QAction::triggered, this, [this, choose, i] { (this->*choose)(i); });
        menu.addAction(choice);
    }
    connect(&menu, &QMenu::aboutToShow, this,
            [this, group, chosen] { group->actions()[(this->*chosen)()]->setChecked(true); });
}

/// The quality menu's choice; 0: automatic.
int MainWindow::quality() const {
    const auto set = storedChoice(m_session.settings(), settings_keys::kQuality, gl::kQualityCount);
    return set ? *set + 1 : 0;
}

int MainWindow::pictureScale() const {
    return std::clamp(m_session.settings().value(settings_keys::kPictureScale, 1).toInt(), 1, 4) - 1;
}

void MainWindow::choosePictureScale(int number) {
    m_session.settings().setValue(settings_keys::kPictureScale, number + 1);
}

int MainWindow::textSize() const {
    return storedChoice(m_session.settings(), settings_keys::kTextSize, int(kTextScales.size())).value_or(0);
}

void MainWindow::chooseTextSize(int number) {
    m_session.settings().setValue(settings_keys::kTextSize, number);
    applyTextScale(kTextScales[size_t(number)]);
}

int MainWindow::theme() const {
    return storedChoice(m_session.settings(), settings_keys::kTheme, kThemeCount).value_or(int(Theme::System));
}

void MainWindow::chooseQuality(int number) {
    if (number == 0)
        m_session.settings().remove(settings_keys::kQuality);
    else
        m_session.settings().setValue(settings_keys::kQuality, number - 1);
    useQuality();
}

void MainWindow::useQuality() {
    const int chosen = quality();
    m_view->setQuality(chosen == 0 ? std::nullopt : std::optional(gl::Quality(chosen - 1)));
}

void MainWindow::chooseTheme(int number) {
    m_session.settings().setValue(settings_keys::kTheme, number);
    applyTheme(Theme(number));
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

void MainWindow::saveRun() {
    const QString again = m_session.isReplaying() ? QString() : tr("Recording that repeats it (*.rec);;");
    const QString filter = again + tr("Table of all samples (*.csv);;Picture of the view (*.png)");
    chooseFile(*this, m_session.settings(), {tr("Save run"), filter, tr("run"), FileUse::Write},
               [this](const QString &path) {
                   QString error;
                   if (ui::saveRun(m_session, *m_view, path, &error)) error = remarkOnSaved(m_session, path);
                   showSaved(path, error);
               });
}

/// The one that is seen: their docks lie behind each other.
void MainWindow::savePlot() {
    const auto isSeen = [](const QWidget *widget) { return !widget->visibleRegion().isEmpty(); };
    if (isSeen(&m_plots->first())) return saveCurves(); // the stack itself is covered by its plots
    if (isSeen(m_comparison)) return saveDistance();
    if (isSeen(m_trade)) return saveTrade();
    if (isSeen(m_track)) return saveFit();
    saveCurves();
}

void MainWindow::saveDistance() {
    askWhereToSavePlot(tr("distance"), m_comparison->plot().time(),
                       [this](const QString &path, QString *error) { return m_comparison->plot().save(path, error); });
}

void MainWindow::saveTrade() {
    const QString filter = tr("Table of all settings (*.csv);;Picture (*.png);;Document (*.pdf);;Drawing (*.svg)");
    chooseFile(*this, m_session.settings(), {tr("Save trade"), filter, tr("trade"), FileUse::Write},
               [this](const QString &path) {
                   QString error;
                   m_trade->save(path, &error);
                   showSaved(path, error);
               });
}

void MainWindow::saveFit() {
    const QString filter = tr("Table of the residuals (*.csv);;Picture (*.png);;Document (*.pdf)");
    chooseFile(*this, m_session.settings(), {tr("Save fit"), filter, tr("fit"), FileUse::Write},
               [this](const QString &path) {
                   QString error;
                   m_track->save(path, &error);
                   showSaved(path, error);
               });
}

void MainWindow::saveCurves() {
    askWhereToSavePlot(tr("plot"), m_plots->time(),
                       [this](const QString &path, QString *error) { return m_plots->save(path, error); });
}

void MainWindow::askWhereToSavePlot(const QString &name, const TimeView &time,
                                    const std::function<bool(const QString &path, QString *error)> &save) {
    const QString filter = tr("Picture (*.png);;Document (*.pdf);;Table of all samples (*.csv)");
    chooseFile(*this, m_session.settings(), {tr("Save plot"), filter, name, FileUse::Write},
               [this, save, &time](const QString &path) {
                   QString error;
                   const bool isTable = path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
                   if (save(path, &error) &&
                       (!isTable || saveSettingsBeside(m_session, path, time.clearedAt(), &error)))
                       error = remarkOnSaved(m_session, path);
                   showSaved(path, error);
               });
}

void MainWindow::saveScreenshot() {
    chooseFile(*this, m_session.settings(),
               {tr("Save picture of the window"), tr("Picture (*.png)"), tr("inspector.png"), FileUse::Write},
               [this](const QString &path) {
                   QString error;
                   grabTo(path, &error);
                   showSaved(path, error);
               });
}

/// line: why it failed, a remark, or empty.
void MainWindow::showSaved(const QString &path, const QString &line) {
    showRemark(line);
    if (line.isEmpty()) sayItIsSaved(path);
}

/// line: or empty.
void MainWindow::showRemark(const QString &line) {
    m_messages->settle(Cause::Command);
    if (!line.isEmpty()) m_messages->showLine(line, Cause::Command);
}

void MainWindow::sayItIsSaved(const QString &path) { sayBriefly(tr("Saved: %1").arg(oneLine(path))); }

void MainWindow::toggleRecording() {
    if (m_session.isRecording()) {
        m_session.stopRecording();
        return sayBriefly(tr("The recording has ended; its file is complete"));
    }
    action("record")->setChecked(false); // stays off until a file is chosen
    chooseFile(*this, m_session.settings(),
               {tr("Record the run"), tr("Recording (*.rec)"), tr("run.rec"), FileUse::Write},
               [this](const QString &path) { m_session.startRecording(path); });
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

void MainWindow::lookFromAbove() { m_view->lookFromAbove(); }
void MainWindow::toggleFollowing() { m_view->setFollowing(action("camera_follow")->isChecked()); }

void MainWindow::showKeys() { showKeysDialog(*this); }
void MainWindow::showAbout() { showAboutDialog(*this, m_view->rendererName()); }

} // namespace inspector::ui
