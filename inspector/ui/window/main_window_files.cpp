// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are opened, dropped, recent or watched; plugins; documentation pages.
#include "core/schedule/recording_schedule.h"
#include "core/setup/lines.h"
#include "core/track/track_reader.h"
#include "ui/files/file_chooser.h"
#include "ui/help/document_dialog.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/settings_keys.h"
#include "ui/track/track_dock.h"
#include "ui/window/film.h"
#include "ui/window/main_window.h"
#include "ui/window/maze_watcher.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>

namespace inspector::ui {

namespace {

constexpr qsizetype kMostRecent = 9;

/// The local file being dragged if it is the only one; otherwise empty.
QString droppedFile(const QMimeData &data) {
    const QList<QUrl> urls = data.urls();
    return urls.size() == 1 ? urls.constFirst().toLocalFile() : QString();
}

/// Also where the source proposes to move the file: it would delete it then.
void acceptCopy(QDropEvent &event) {
    event.setDropAction(Qt::CopyAction);
    event.accept();
}

} // namespace

void MainWindow::openMazeFile() {
    chooseFile(*this, m_session.settings(),
               {tr("Open maze file"), tr("Mazes (*.txt);;All files (*)"), {}, FileUse::Read},
               [this](const QString &path) { openFile(path); });
}

void MainWindow::openRecording() {
    chooseFile(*this, m_session.settings(),
               {tr("Open recording"), tr("Recordings (*.rec);;All files (*)"), {}, FileUse::Read},
               [this](const QString &path) { openFile(path); });
}

void MainWindow::askForTrack() {
    chooseFile(*this, m_session.settings(),
               {tr("Open measured ball"), tr("Tables (*.csv *.tsv *.txt);;All files (*)"), {}, FileUse::Read},
               [this](const QString &path) { remember(path, openTrack(path, m_track->units())); });
}

/// Opens a maze, a recording or a measured ball; recent files are updated accordingly.
void MainWindow::openFile(const QString &path) {
    if (isRecordingFile(path)) return remember(path, m_session.openRecording(path));
    if (isTrackFile(path)) return remember(path, openTrack(path, m_track->units()));
    remember(path, m_session.openLevel(levelOfFile(path)));
}

void MainWindow::remember(const QString &path, bool isOpen) {
    QSettings &settings = m_session.settings();
    QStringList recent = settings.value(settings_keys::kRecent).toStringList();
    const QString full = QFileInfo(path).absoluteFilePath();
    recent.removeAll(full);
    if (isOpen) recent.prepend(full);
    settings.setValue(settings_keys::kRecent, recent.mid(0, kMostRecent));
}

/// Adds the command line's file to the recent ones, unless it is a level, as levels have a list of their own.
void MainWindow::rememberFirst() {
    if (const Playback *replay = m_session.replay()) return remember(replay->recording().recording().file, true);
    if (!m_session.levels().isOpenListed()) remember(m_session.level().path, true);
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event) {
    if (!droppedFile(*event->mimeData()).isEmpty()) acceptCopy(*event);
}

void MainWindow::dropEvent(QDropEvent *event) {
    acceptCopy(*event);
    openFile(droppedFile(*event->mimeData()));
}

/// Lists the newest first, with digits as mnemonics.
void MainWindow::addRecent(QMenu &menu) {
    auto *recent = new QMenu(tr("Open recent"), &menu);
    recent->setObjectName(QStringLiteral("recent_menu"));
    menu.insertMenu(action("close_recording"), recent);
    connect(recent, &QMenu::aboutToShow, this, [this, recent] {
        recent->clear();
        recent->setToolTipsVisible(true);
        int number = 0;
        for (const QString &path : m_session.settings().value(settings_keys::kRecent).toStringList()) {
            QString name = oneLine(QFileInfo(path).fileName()).replace(QLatin1Char('&'), QLatin1String("&&"));
            QAction *open = recent->addAction(QStringLiteral("&%1  %2").arg(++number).arg(name));
            open->setToolTip(oneLine(path));
            connect(open, &QAction::triggered, this, [this, path] { openFile(path); });
        }
        if (number == 0) return recent->addAction(tr("None yet"))->setEnabled(false);
        recent->addSeparator();
        connect(recent->addAction(tr("Forget them")), &QAction::triggered, this,
                [this] { m_session.settings().remove(settings_keys::kRecent); });
    });
}

void MainWindow::askForPlugin() {
    chooseFile(*this, m_session.settings(),
               {tr("Load plugin"), tr("Plugins (*.so *.dll *.dylib);;All files (*)"), {}, FileUse::Read},
               [this](const QString &path) { loadPlugin(path); });
}

void MainWindow::loadPlugin(const QString &path) {
    const uint32_t before = phys_registry_count(m_session.registry().get());
    if (!m_session.loadPlugin(path)) return;
    m_messages->settle(Cause::Command);
    QStringList names;
    phys_stepper_info info;
    for (uint32_t i = before; phys_registry_info(m_session.registry().get(), i, &info) == PHYS_OK; ++i)
        names += QString::fromUtf8(info.name);
    sayBriefly(tr("Can be chosen as steppers now: %1").arg(names.join(QLatin1String(", "))));
}

void MainWindow::saveFilm() {
    static const FileQuestion questions[] = {
        // in the order of FilmKind
        {tr("New folder for the film"), tr("Folder (*)"), tr("film"), FileUse::Write},
        {tr("Save film"), tr("Film (*.webm)"), tr("film.webm"), FileUse::Write},
        {tr("Save film"), tr("Moving picture (*.gif)"), tr("film.gif"), FileUse::Write},
    };
    askForFilm(*this, {}, [this](const FilmPlan &plan) {
        chooseFile(*this, m_session.settings(), questions[int(plan.kind)], [this, plan](const QString &path) {
            QString error;
            auto *film = new Film(m_session, *m_view, plan, pictureScale() + 1, *this);
            connect(film, &Film::finished, this, &MainWindow::showRemark);
            connect(film, &Film::saved, this, &MainWindow::sayItIsSaved);
            if (!film->begin(path, &error)) showRemark(error);
        });
    });
}

/// Doesn't watch while a recording or the past is shown, whose maze must not change.
void MainWindow::watchMaze() {
    m_mazeWatcher->watch(m_session.isReplaying() || m_session.isInPast() ? QString() : m_session.level().path);
}

void MainWindow::readMazeAgain(const QString &path) {
    if (path != m_session.level().path || m_session.isReplaying()) return;
    const bool isOpen = m_session.openLevel(levelOfFile(path)); // else it has reported why
    m_messages->showLine(isOpen ? tr("%1 was changed on disk and has been read again").arg(QFileInfo(path).fileName())
                                : tr("%1; the maze stays open as it was").arg(m_messages->line()),
                         Cause::Command);
}

void MainWindow::sayMazeIsGone(const QString &path) {
    m_messages->showLine(tr("%1 can't be read any more; the maze stays open as it was").arg(quoted(path)), Cause::Maze);
}

void MainWindow::sayMazeIsOlder(const QString &path) {
    m_messages->showLine(tr("This run's %1 is an older one than that on disk, which the next start opens")
                             .arg(QFileInfo(path).fileName()),
                         Cause::Maze);
}

void MainWindow::showGuide() { showPage(QStringLiteral("inspector/README.md"), QStringLiteral("Using the window")); }
void MainWindow::showModelPage() { showPage(QStringLiteral("libphysics/docs/model.md")); }
void MainWindow::showAccuracyPage() { showPage(QStringLiteral("libphysics/docs/accuracy.md")); }

void MainWindow::showPage(const QString &page, const QString &section) {
    if (!m_documents) m_documents = new DocumentDialog(this);
    m_messages->settle(Cause::Command);
    if (m_documents->showPage(page, section)) return;
    m_messages->showLine(tr("%1: this page isn't installed").arg(page), Cause::Command);
}

} // namespace inspector::ui
