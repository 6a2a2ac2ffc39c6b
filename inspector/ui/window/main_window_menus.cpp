// SPDX-License-Identifier: GPL-3.0-or-later
// The menus: which actions they have, and a few choices.
#include "core/setup/stored_values.h"
#include "gl/view/maze_view.h"
#include "ui/parts/settings_keys.h"
#include "ui/parts/theme.h"
#include "ui/transport/transport_bar.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QUndoStack>

#include <algorithm>
#include <optional>

namespace inspector::ui {

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
    QMenu *moves = menu.addMenu(tr("Move the camera"));
    for (const ActionRow &row : cameraRows()) moves->addAction(action(row.name));
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

} // namespace inspector::ui
