// SPDX-License-Identifier: MIT
// Files in the window: recent ones, a maze that an editor changes, plugins, documentation pages.
#include "support/files.h"
#include "ui/parts/message_bar.h"
#include "window_fixture.h"

#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolTip>
#include <QTreeWidget>

#include <algorithm>

using namespace window_test;

class TestWindowFiles : public WindowSuite {
    Q_OBJECT

private slots:
    void droppedMazeIsARecentOne();
    void droppedFileIsNotMoved();
    void recentFileThatIsGoneIsForgotten();
    void nameOfTwoLinesIsShownInOne();
    void markupInANameIsText();
    void labelsDoNotGuessWhatIsMarkup();
    void nameIsOpenedAsItIsTyped_data();
    void nameIsOpenedAsItIsTyped();
    void changedMazeIsReadAgain();
    void runOfAnOlderMazeSaysSoAndEndsWithIt();
    void runsOfTheVersionsOfAMazeAreToldApart();
    void savedRunOfAnOlderMazeSaysSo();
    void noteOfAChangedMazeIsForgottenAtARestart();
    void replacedMazeIsReadAgain();
    void mazeThatIsDeletedIsSaid();
    void savedFileIsSaid_data();
    void savedFileIsSaid();
    void mazeThatBecameWrongLeavesTheOpenOne();
    void mazeWrittenWithTheSameBytesGoesOn();
    void pluginsStepperCanBeChosen();
    void pluginsStepperIsShownInFull();
    void fileThatIsNoPluginIsRefusedInOneLine();
    void guideOpensByKeyAndIsSearched();
    void lettersTypedIntoAPageAreSought();
    void headingsAreTitlesOfOneSize();
    void linkBetweenPagesIsFollowed();
    void keysAreScrolledByPages();
    void sectionOfABounceOpensThere();
    void fileOfTheCommandLineIsARecentOne();
    void ownMazeHasABestTime();
    void freeRunSaysOnceThatTheBallIsOut();
    void mazeWithoutWayOutSaysSo();
    void folderWhereNothingCanBeSavedIsForgotten_data();
    void folderWhereNothingCanBeSavedIsForgotten();

private:
    QString maze(const QString &name, const QByteArray &more = {});
    void write(const QString &path, const QByteArray &bytes);
    void drop(const QString &path) { m_fixture->drop(path); }
    QMenu *recent();
    uint32_t boxes() { return phys_scene_box_count(m_fixture->session().scene().get()); }
    QString strip(); // all of its text
    QString line() { return m_fixture->window().messages().line(); }
};

namespace {
const QByteArray kFloor = "physics-maze 1\nunits m\nball 0.006\nstart 0 0 0.006\nbox -0.1 -0.1 -0.01 0.1 0.1 0\n";
const QByteArray kRoom = "box -0.1 -0.1 0 -0.09 0.1 0.02\nbox 0.09 -0.1 0 0.1 0.1 0.02\n"
                         "box -0.1 -0.1 0 0.1 -0.09 0.02\nbox -0.1 0.09 0 0.1 0.1 0.02\n";
const QByteArray kWall = "box 0.05 -0.1 0 0.06 0.1 0.02\n";
} // namespace

void TestWindowFiles::write(const QString &path, const QByteArray &bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

QString TestWindowFiles::maze(const QString &name, const QByteArray &more) {
    QString path = m_fixture->path(name);
    write(path, kFloor + more);
    return path;
}

QString TestWindowFiles::strip() {
    QStringList texts;
    for (const QLabel *label : m_fixture->find<QFrame>("game_strip")->findChildren<QLabel *>()) texts << label->text();
    return texts.join(' ');
}

// As the mouse opens it.
QMenu *TestWindowFiles::recent() {
    auto *menu = m_fixture->find<QMenu>("recent_menu");
    menu->popup(m_fixture->window().mapToGlobal(QPoint(40, 40)));
    return menu;
}

void TestWindowFiles::droppedMazeIsARecentOne() {
    const QString first = maze("first.txt");
    const QString second = maze("second.txt", kWall);
    drop(first);
    drop(second);
    QMenu *menu = recent();
    QCOMPARE(menu->actions().at(0)->text(), QString("&1  second.txt"));
    QCOMPARE(menu->actions().at(1)->text(), QString("&2  first.txt"));
    QTest::keyClick(menu, Qt::Key_2);
    QCOMPARE(m_fixture->session().level().path, first);
    menu = recent();
    QCOMPARE(menu->actions().at(0)->text(), QString("&1  first.txt"));
    QTest::keyClick(menu, Qt::Key_Escape);
}

// A source that also offers to move it would delete the file.
void TestWindowFiles::droppedFileIsNotMoved() {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(maze("mine.txt"))});
    QDragEnterEvent enter({9, 9}, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, Qt::ShiftModifier);
    QCOMPARE(enter.proposedAction(), Qt::MoveAction);
    QApplication::sendEvent(&m_fixture->window(), &enter);
    QVERIFY(enter.isAccepted());
    QCOMPARE(enter.dropAction(), Qt::CopyAction);
    QDropEvent drop({9, 9}, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, Qt::ShiftModifier);
    QApplication::sendEvent(&m_fixture->window(), &drop);
    QVERIFY(drop.isAccepted());
    QCOMPARE(drop.dropAction(), Qt::CopyAction);
    QTRY_COMPARE(m_fixture->session().level().name, QString("mine"));
}

void TestWindowFiles::nameOfTwoLinesIsShownInOne() {
    const QString maze = m_fixture->path("two\nlines.txt");
    QVERIFY(QFile::copy(LEVELS_FOLDER "/02.txt", maze));
    m_fixture->drop(maze);
    QTRY_COMPARE(m_fixture->window().windowTitle(), QString::fromUtf8("two\\nlines – Physics inspector"));
    m_fixture->window().refresh();
    QStringList texts;
    for (const QLabel *label : m_fixture->find<QWidget>("game_strip")->findChildren<QLabel *>()) texts += label->text();
    QVERIFY2(texts.contains("two\\nlines"), qPrintable(texts.join('|')));
    QCOMPARE(recent()->actions().at(0)->text(), QString("&1  two\\nlines.txt"));
}

void TestWindowFiles::recentFileThatIsGoneIsForgotten() {
    const QString path = maze("gone.txt");
    drop(path);
    QVERIFY(QFile::remove(path));
    QTest::keyClick(recent(), Qt::Key_1);
    QVERIFY2(line().contains("gone.txt"), qPrintable(line()));
    QCOMPARE(recent()->actions().at(0)->text(), QString("&None yet"));
    m_fixture->find<QMenu>("recent_menu")->close();
}

// Of a tool tip and of a message box: both are labels.
void TestWindowFiles::markupInANameIsText() {
    drop(maze("<b>bold.txt"));
    QMenu *menu = recent();
    const QPoint place = menu->actionGeometry(menu->actions().at(0)).center();
    QHelpEvent asked(QEvent::ToolTip, place, menu->mapToGlobal(place));
    QApplication::sendEvent(menu, &asked);
    QVERIFY2(QToolTip::text().endsWith("<b>bold.txt"), qPrintable(QToolTip::text()));
    const QWidgetList shown = QApplication::topLevelWidgets();
    const auto isTip = [](const QWidget *widget) { return widget->inherits("QTipLabel") && widget->isVisible(); };
    const auto tip = std::ranges::find_if(shown, isTip);
    QVERIFY(tip != shown.end());
    QCOMPARE(static_cast<QLabel *>(*tip)->textFormat(), Qt::PlainText);
    QTest::keyClick(menu, Qt::Key_Escape);
    m_fixture->trigger("save_run");
    m_fixture->answerFile(m_fixture->path("<b>bold.doc"));
    auto *refusal = m_fixture->find<QMessageBox>("nothing_saved");
    QTRY_COMPARE(refusal->findChild<QLabel *>("qt_msgbox_label")->textFormat(), Qt::PlainText);
    delete refusal;
}

void TestWindowFiles::labelsDoNotGuessWhatIsMarkup() {
    for (auto *dock : m_fixture->window().findChildren<QDockWidget *>()) dock->show();
    for (const QLabel *label : m_fixture->window().findChildren<QLabel *>())
        if (label->isVisible())
            QVERIFY2(label->textFormat() != Qt::AutoText,
                     qPrintable(label->parent()->objectName() + ' ' + label->text()));
}

void TestWindowFiles::nameIsOpenedAsItIsTyped_data() {
    QTest::addColumn<QString>("action");
    for (const char *action : {"open", "open_recording", "load_plugin"}) QTest::newRow(action) << action;
}

// The dialog adds no suffix, and lists files of every name.
void TestWindowFiles::nameIsOpenedAsItIsTyped() {
    QFETCH(QString, action);
    const QString path = maze("board", kWall);
    m_fixture->trigger(action);
    auto *dialog = m_fixture->window().findChild<QFileDialog *>();
    QVERIFY(dialog);
    dialog->setDirectory(QFileInfo(path).absolutePath());
    auto *name = dialog->findChild<QLineEdit *>("fileNameEdit");
    name->selectAll();
    QTest::keyClicks(name, "board");
    QCOMPARE(dialog->selectedFiles(), QStringList(path)); // otherwise a message would wait for an answer
    QVERIFY(dialog->nameFilters().contains("All files (*)"));
    QTest::keyClick(name, Qt::Key_Return);
    QTRY_VERIFY2(m_fixture->session().level().path == path || line().contains(path), qPrintable(line()));
}

void TestWindowFiles::changedMazeIsReadAgain() {
    const QString path = maze("mine.txt");
    drop(path);
    QCOMPARE(boxes(), 1U);
    write(path, kFloor + kWall);
    QTRY_COMPARE(boxes(), 2U);
    QCOMPARE(line(), QString("mine.txt was changed on disk and has been read again"));
    write(path, kFloor + kWall + "box -0.06 -0.1 0 -0.05 0.1 0.02\n"); // it is still watched
    QTRY_COMPARE(boxes(), 3U);
}

void TestWindowFiles::runOfAnOlderMazeSaysSoAndEndsWithIt() {
    const QString path = maze("mine.txt");
    drop(path);
    m_fixture->makeSteps(5);
    m_fixture->window().refresh(); // the run is in runs()
    write(path, kFloor + kWall);
    QTRY_COMPARE(boxes(), 2U);
    inspector::Session &session = m_fixture->session();
    session.lookAt(session.history().runs().back().end);
    const auto isBack = [&] {
        m_fixture->window().refresh();
        return boxes() == 1;
    };
    QTRY_VERIFY(isBack());
    session.takeOver();
    QVERIFY2(line().contains("mine.txt is an older one than that on disk"), qPrintable(line()));
    m_fixture->makeSteps(2);
    QString error;
    QVERIFY2(session.saveRun(m_fixture->path("older.rec"), &error), qPrintable(error));
    write(path, kFloor); // the recording names the maze that it was made in
    QVERIFY2(inspector::openRecording(m_fixture->path("older.rec"), session.registry(), {}, &error), qPrintable(error));
    write(path, kFloor + kWall);
    m_fixture->key(Qt::Key_R);
    QTRY_COMPARE(boxes(), 2U);
    QCOMPARE(line(), QString());
}

void TestWindowFiles::runsOfTheVersionsOfAMazeAreToldApart() {
    const auto titles = [this] {
        m_fixture->window().refresh();
        QStringList all;
        const auto *runs = m_fixture->find<QTreeWidget>("runs");
        for (int row = 0; row < runs->topLevelItemCount(); ++row) all += runs->topLevelItem(row)->text(0);
        return all.join('|');
    };
    const QString path = maze("mine.txt");
    drop(path);
    m_fixture->trigger("show_runs_dock");
    m_fixture->makeSteps(5);
    QCOMPARE(titles(), QString("mine"));
    write(path, kFloor + kWall);
    QTRY_COMPARE(boxes(), 2U);
    QCOMPARE(titles(), QString("mine, version 1"));
    m_fixture->makeSteps(5);
    QCOMPARE(titles(), QString("mine, version 2|mine, version 1"));
}

// It can't be replayed with the maze as it is now.
void TestWindowFiles::savedRunOfAnOlderMazeSaysSo() {
    const QString path = maze("mine.txt");
    drop(path);
    m_fixture->makeSteps(5);
    m_fixture->window().refresh(); // the run is in runs()
    const auto remark = [this] {
        m_fixture->trigger("save_run");
        m_fixture->answerFile(m_fixture->path("run.rec"));
        return line();
    };
    QCOMPARE(remark(), QString());
    write(path, kFloor + kWall);
    QTRY_COMPARE(boxes(), 2U);
    m_fixture->session().lookAt(m_fixture->session().history().runs().back().end);
    m_fixture->session().awaitMoment();
    QCOMPARE(remark(), m_fixture->path("run.rec") + ": '" + path +
                           "' has changed since this run and is needed as it was to replay it");
}

void TestWindowFiles::noteOfAChangedMazeIsForgottenAtARestart() {
    const QString path = maze("mine.txt");
    drop(path);
    write(path, kFloor + kWall);
    QTRY_VERIFY(line().contains("has been read again"));
    m_fixture->key(Qt::Key_R);
    QCOMPARE(line(), QString());
}

// Editors may write to another file first, which then replaces the file.
void TestWindowFiles::replacedMazeIsReadAgain() {
    const QString path = maze("mine.txt");
    drop(path);
    for (const QByteArray &more : {kWall, kWall + kWall}) {
        const QString beside = maze("new.txt", more);
        QVERIFY(QFile::remove(path) && QFile::rename(beside, path));
        QTRY_COMPARE(boxes(), uint32_t(1 + more.size() / kWall.size()));
    }
}

void TestWindowFiles::mazeThatIsDeletedIsSaid() {
    const QString path = maze("mine.txt", kWall);
    drop(path);
    QVERIFY(QFile::remove(path));
    QTRY_COMPARE(line(), "'" + path + "' can't be read any more; the maze stays open as it was");
    QCOMPARE(boxes(), 2U);
    m_fixture->key(Qt::Key_R);
    QVERIFY(!line().isEmpty()); // it is still gone
    write(path, kFloor + kWall);
    QTRY_COMPARE(line(), QString());
    QVERIFY(QFile::remove(path));
    QTRY_VERIFY(!line().isEmpty());
    QVERIFY(m_fixture->session().openLevel(m_fixture->session().levels().listed()[0]));
    QCOMPARE(line(), QString());
}

void TestWindowFiles::savedFileIsSaid_data() {
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("name");
    QTest::newRow("run") << "save_run"
                         << "run.rec";
    QTest::newRow("table of the run") << "save_run"
                                      << "run.csv";
    QTest::newRow("picture of the view") << "save_run"
                                         << "run.png";
    QTest::newRow("plot") << "save_plot"
                          << "plot.png";
    QTest::newRow("window") << "screenshot"
                            << "window.png";
    QTest::newRow("set of parameters") << "set_export"
                                       << "set.txt";
}

void TestWindowFiles::savedFileIsSaid() {
    QFETCH(QString, action);
    QFETCH(QString, name);
    m_fixture->makeSteps(2);
    const QString path = m_fixture->path(name);
    if (action == "set_export") {
        auto *menu = m_fixture->find<QMenu>("set_menu");
        menu->popup(m_fixture->window().mapToGlobal(QPoint(40, 40))); // which fills it
        menu->close();
    }
    m_fixture->trigger(action);
    m_fixture->answerFile(path);
    QVERIFY2(QFile::exists(path), qPrintable(line()));
    QCOMPARE(m_fixture->window().statusBar()->currentMessage(), "Saved: " + path);
}

void TestWindowFiles::mazeThatBecameWrongLeavesTheOpenOne() {
    const QString path = maze("mine.txt", kWall);
    drop(path);
    write(path, "box 1 2\n");
    QTRY_VERIFY2(line().contains("mine.txt"), qPrintable(line()));
    QVERIFY2(line().endsWith("; the maze stays open as it was"), qPrintable(line()));
    QCOMPARE(boxes(), 2U);
    write(path, kFloor);
    QTRY_COMPARE(boxes(), 1U);
}

// The running simulation isn't disturbed; another change shows that the first was noticed.
void TestWindowFiles::mazeWrittenWithTheSameBytesGoesOn() {
    const QString path = maze("mine.txt", kWall);
    drop(path);
    m_fixture->trigger("step");
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(1));
    QSignalSpy opened(&m_fixture->session(), &inspector::Session::levelOpened);
    write(path, kFloor + kWall);
    write(m_fixture->path("other.txt"), kFloor);
    write(path, kFloor);
    QTRY_COMPARE(boxes(), 1U);
    QCOMPARE(opened.size(), 1);
}

void TestWindowFiles::pluginsStepperCanBeChosen() {
    m_fixture->trigger("load_plugin");
    m_fixture->answerFile(ADAPTIVE_DRAG);
    auto *steppers = m_fixture->find<QComboBox>("stepper");
    QTRY_VERIFY(steppers->findData(QByteArray("adaptive-drag")) >= 0);
    QVERIFY(m_fixture->find<QComboBox>("comparison_stepper")->findData(QByteArray("adaptive-drag")) >= 0);
    steppers->setFocus(Qt::TabFocusReason);
    QTest::keyClick(steppers, Qt::Key_End);
    QCOMPARE(m_fixture->session().stepperId(), QByteArray("adaptive-drag"));
    m_fixture->trigger("step");
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(1));
    const int count = steppers->count();
    m_fixture->trigger("load_plugin"); // twice is said
    m_fixture->answerFile(ADAPTIVE_DRAG);
    QTRY_VERIFY2(line().contains("adaptive-drag"), qPrintable(line()));
    QCOMPARE(steppers->count(), count);
}

void TestWindowFiles::pluginsStepperIsShownInFull() {
    m_fixture->trigger("load_plugin");
    m_fixture->answerFile(ADAPTIVE_DRAG);
    auto *steppers = m_fixture->find<QComboBox>("stepper");
    QTRY_VERIFY(steppers->findData(QByteArray("adaptive-drag")) >= 0);
    steppers->setFocus(Qt::TabFocusReason);
    QTest::keyClick(steppers, Qt::Key_End);
    const auto room = [steppers] {
        QStyleOptionComboBox option;
        option.initFrom(steppers);
        return steppers->style()
            ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, steppers)
            .width();
    };
    QTRY_VERIFY2(room() >= steppers->fontMetrics().horizontalAdvance(steppers->currentText()),
                 qPrintable(QString::number(room())));
}

void TestWindowFiles::fileThatIsNoPluginIsRefusedInOneLine() {
    const QString path = maze("no.so");
    m_fixture->trigger("load_plugin");
    m_fixture->answerFile(path);
    QTRY_VERIFY2(line().contains("no.so"), qPrintable(line()));
    QVERIFY(!line().contains('\n'));
}

void TestWindowFiles::guideOpensByKeyAndIsSearched() {
    m_fixture->press(Qt::Key_F1, Qt::ShiftModifier);
    auto *page = m_fixture->find<QTextBrowser>("document");
    QTRY_VERIFY(page->isVisible());
    QVERIFY2(page->toPlainText().startsWith("inspector\n"), qPrintable(page->toPlainText().left(80)));
    const auto headingAtTheTop = [page] {
        const QTextBlock block = page->textCursor().block();
        const int top = page->cursorRect().top();
        return block.text() == QLatin1String("Using the window") && top >= 0 && top < page->viewport()->height() / 10;
    };
    QTRY_VERIFY(headingAtTheTop());
    auto *sought = m_fixture->find<QLineEdit>("document_sought");
    click(sought);
    QTest::keyClicks(sought, "After an interruption");
    QTest::keyClick(sought, Qt::Key_Return);
    QCOMPARE(page->textCursor().selectedText(), QString("After an interruption"));
    QTRY_VERIFY(page->verticalScrollBar()->value() > 0);
}

void TestWindowFiles::lettersTypedIntoAPageAreSought() {
    m_fixture->trigger("page_model");
    auto *page = m_fixture->find<QTextBrowser>("document");
    QTRY_VERIFY(page->hasFocus());
    m_fixture->type("Coulomb");
    QCOMPARE(m_fixture->find<QLineEdit>("document_sought")->text(), QString("Coulomb"));
    QCOMPARE(page->textCursor().selectedText(), QString("Coulomb"));
}

// Also where it has code, which Qt reads as text of the usual size.
void TestWindowFiles::headingsAreTitlesOfOneSize() {
    m_fixture->trigger("page_accuracy");
    const auto *page = m_fixture->find<QTextBrowser>("document");
    QTRY_VERIFY(page->isVisible());
    QString first;
    for (QTextBlock block = page->document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0) continue;
        if (first.isEmpty()) first = block.text();
        for (const QTextLayout::FormatRange &letters : block.textFormats())
            QVERIFY2(letters.format.intProperty(QTextFormat::FontSizeAdjustment) ==
                         4 - block.blockFormat().headingLevel(),
                     qPrintable(block.text()));
    }
    QVERIFY(!first.isEmpty());
    QCOMPARE(page->window()->windowTitle(), first + " – Help");
}

void TestWindowFiles::linkBetweenPagesIsFollowed() {
    m_fixture->trigger("page_accuracy");
    auto *page = m_fixture->find<QTextBrowser>("document");
    QTRY_VERIFY(page->isVisible());
    emit page->anchorClicked(QUrl("model.md"));
    QTRY_COMPARE(page->source().fileName(), QString("model.md"));
    page->backward();
    QTRY_COMPARE(page->source().fileName(), QString("accuracy.md"));
}

void TestWindowFiles::keysAreScrolledByPages() {
    m_fixture->press(Qt::Key_F1);
    auto *dialog = m_fixture->find<QDialog>("keys_dialog");
    dialog->resize(500, 240);
    QVERIFY(QTest::qWaitForWindowActive(dialog, kPatience));
    auto *bar = dialog->findChild<QScrollArea *>()->verticalScrollBar();
    QTRY_VERIFY(bar->maximum() > 0);
    auto *sought = m_fixture->find<QLineEdit>("keys_sought");
    QTest::keyClick(sought, Qt::Key_PageDown);
    QVERIFY(bar->value() > 0);
    QTest::keyClick(sought, Qt::Key_PageUp);
    QCOMPARE(bar->value(), 0);
}

// The text on the law of the bounce names its section; the link leads there.
void TestWindowFiles::sectionOfABounceOpensThere() {
    m_fixture->press(Qt::Key_6, Qt::ControlModifier);
    auto *detail = m_fixture->find<QLabel>("bounces_detail");
    QTRY_VERIFY(detail->isVisible());
    emit detail->linkActivated("2.2");
    auto *page = m_fixture->find<QTextBrowser>("document");
    QTRY_VERIFY(page->isVisible());
    QCOMPARE(page->source().fileName(), QString("model.md"));
    QVERIFY2(page->textCursor().block().text().startsWith("2.2 "), qPrintable(page->textCursor().block().text()));
}

// The window finds it open.
void TestWindowFiles::fileOfTheCommandLineIsARecentOne() {
    const QString path = maze("given.txt");
    QVERIFY(m_fixture->session().openLevel(inspector::levelOfFile(path)));
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    QCOMPARE(recent()->actions().at(0)->text(), QString("&1  given.txt"));
    m_fixture->find<QMenu>("recent_menu")->close();
}

void TestWindowFiles::ownMazeHasABestTime() {
    drop(maze("mine.txt"));
    QTest::keyClick(&m_fixture->window(), Qt::Key_Return);
    QTest::keyPress(&m_fixture->window(), Qt::Key_Right); // over the edge
    QTRY_COMPARE(m_fixture->game().phase(), inspector::Game::Phase::Won);
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Right);
    QVERIFY(m_fixture->game().isRecord());
    m_fixture->window().refresh();
    QVERIFY2(strip().contains("Enter or R: again") && !strip().contains("Level 1"), qPrintable(strip()));
    m_fixture->press(Qt::Key_Return); // no level follows it
    QCOMPARE(QFileInfo(m_fixture->session().level().path).fileName(), QString("mine.txt"));
    QCOMPARE(m_fixture->game().phase(), inspector::Game::Phase::Prompt);
    m_fixture->window().refresh();
    QTRY_VERIFY2(strip().contains("best time"), qPrintable(strip()));
    m_fixture->press(Qt::Key_Return); // the same again, not a level of the list
    QCOMPARE(QFileInfo(m_fixture->session().level().path).fileName(), QString("mine.txt"));
    QCOMPARE(m_fixture->game().phase(), inspector::Game::Phase::Playing);
}

void TestWindowFiles::freeRunSaysOnceThatTheBallIsOut() {
    drop(maze("mine.txt"));
    m_fixture->parameters().set({{QStringLiteral("tilt_x"), 10.0}});
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(m_fixture->simulation().latest().current.flags & PHYS_OUT);
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    m_fixture->window().refresh();
    QStringList texts;
    for (const QLabel *label : m_fixture->window().findChildren<QLabel *>())
        if (label->isVisible()) texts << label->text();
    QCOMPARE(texts.join('|').count("out of the maze", Qt::CaseInsensitive), 1);
    QVERIFY2(strip().contains("The free run has ended"), qPrintable(strip()));
}

void TestWindowFiles::mazeWithoutWayOutSaysSo() {
    drop(maze("closed.txt", kRoom));
    QTRY_VERIFY2(strip().contains("no way out"), qPrintable(strip()));
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 10);
    drop(maze("open.txt"));
    QTRY_VERIFY2(!strip().contains("no way out") && strip().contains("roll the ball out"), qPrintable(strip()));
}

void TestWindowFiles::folderWhereNothingCanBeSavedIsForgotten_data() {
    QTest::addColumn<QString>("file");
    QTest::newRow("processes") << "/proc/x.csv";
    QTest::newRow("device") << "/dev/full";
    QTest::newRow("no folder") << "/nowhere/x.csv";
}

// The next dialog begins where the last file was saved.
void TestWindowFiles::folderWhereNothingCanBeSavedIsForgotten() {
    QFETCH(QString, file);
    for (const QString &path : {m_fixture->path("run.rec"), file}) {
        m_fixture->trigger("save_run");
        m_fixture->answerFile(path);
    }
    QVERIFY(!line().isEmpty() || m_fixture->window().findChild<QMessageBox *>("nothing_saved"));
    m_fixture->trigger("save_run");
    auto *dialog = m_fixture->window().findChild<QFileDialog *>();
    QVERIFY(dialog);
    QCOMPARE(dialog->directory().absolutePath(), QFileInfo(m_fixture->path("run.rec")).absolutePath());
    delete dialog;
}

QTEST_MAIN(TestWindowFiles)
#include "tst_window_files.moc"
