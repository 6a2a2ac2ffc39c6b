// SPDX-License-Identifier: MIT
// Named sets of parameters in the Parameters dock: applied, saved, deleted, imported, exported, undone.
#include "core/setup/parameter_sets.h"
#include "support/compare.h"
#include "support/files.h"
#include "ui/input/menu_letters.h"
#include "ui/parts/message_bar.h"
#include "window_fixture.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

#include <algorithm>

using namespace window_test;
using inspector::ui::plainText;

class TestWindowSets : public WindowSuite {
    Q_OBJECT

private slots:
    void knownSetIsChosenByKeyboardAndUndone();
    void tipSaysValuesAndSources();
    void savedSetComesBackWithTheNextWindow();
    void longNameLeavesTheMenuOnTheScreen();
    void nameOfABuiltInSetCantBeSaved();
    void replacedSetIsSaidBefore();
    void importedSetReplacesNoOther_data();
    void importedSetReplacesNoOther();
    void nameIsTheKeyOfTheSettings_data();
    void nameIsTheKeyOfTheSettings();
    void setOfAnEarlierVersionIsRenamed();
    void blankNameCantBeSaved();
    void deletionIsUndone();
    void ghostGetsASetOfItsOwn();
    void exportedFileIsImported();
    void fileThatIsNoneIsRefusedInOneLine();
    void refusalInARecordingGoesWithTheNextCommand_data();
    void refusalInARecordingGoesWithTheNextCommand();
    void refusalInARecordingGoesWithTheGhostsNextValue();

private:
    double own(const char *id) { return m_fixture->parameters().value(m_fixture->parameters().indexOf(id)); }
    QMenu *menu();
    void choose(const QString &text, const QString &inMenu = {});
    QInputDialog *asked();
    static QAbstractButton *saveButton(const QInputDialog &dialog);
    void save(const QString &name);
    void refuseInRecording();
};

// As a click on the button opens it; it stays open until something is chosen.
QMenu *TestWindowSets::menu() {
    auto *menu = m_fixture->find<QMenu>("set_menu");
    menu->popup(m_fixture->find<QPushButton>("parameter_sets")->mapToGlobal(QPoint(0, 20)));
    return menu;
}

// By a click on the text, in the menu or in one of its submenus.
void TestWindowSets::choose(const QString &text, const QString &inMenu) {
    QMenu *shown = menu();
    if (!inMenu.isEmpty()) {
        for (QAction *action : shown->actions())
            if (plainText(action->text()) == inMenu) shown = action->menu();
        QVERIFY(shown->isEnabled());
        shown->popup(menu()->pos() + QPoint(40, 40));
    }
    const QList<QAction *> actions = shown->actions();
    const auto found =
        std::find_if(actions.begin(), actions.end(), [&](QAction *a) { return plainText(a->text()) == text; });
    QVERIFY2(found != actions.end(), qPrintable(text));
    QTest::mouseClick(shown, Qt::LeftButton, {}, shown->actionGeometry(*found).center());
    while (QWidget *open = QApplication::activePopupWidget()) open->close();
}

void TestWindowSets::save(const QString &name) {
    auto *line = asked()->findChild<QLineEdit *>();
    QTest::keyClicks(line, name);
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_VERIFY(!m_fixture->window().findChild<QInputDialog *>("set_name"));
}

void TestWindowSets::knownSetIsChosenByKeyboardAndUndone() {
    auto *button = m_fixture->find<QPushButton>("parameter_sets");
    button->setFocus(Qt::TabFocusReason);
    QTimer::singleShot(0, button, [] {
        QTRY_VERIFY(QApplication::activePopupWidget());
        for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Down, Qt::Key_Return})
            QTest::keyClick(QApplication::activePopupWidget(), key);
    });
    QTest::keyClick(button, Qt::Key_Space);       // waits until the menu is closed
    COMPARE_EXACT(own("restitution_wall"), 0.65); // glass
    COMPARE_EXACT(own("rolling_friction"), 0.001);
    QTRY_COMPARE(m_fixture->simulated("restitution_wall"), 0.65);
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    COMPARE_EXACT(own("restitution_wall"), 0.5);
    COMPARE_EXACT(own("rolling_friction"), 0.002);
}

void TestWindowSets::tipSaysValuesAndSources() {
    const QAction *first = menu()->actions().front();
    QCOMPARE(plainText(first->text()), QString("Steel on wood"));
    QVERIFY2(first->toolTip().contains("rolling_friction = 0.002"), qPrintable(first->toolTip()));
    QVERIFY2(first->toolTip().contains("Cross"), qPrintable(first->toolTip()));
    m_fixture->find<QMenu>("set_menu")->close();
}

void TestWindowSets::savedSetComesBackWithTheNextWindow() {
    m_fixture->parameters().set({{"gravity", 1.62}, {"tilt_x", 3.0}});
    save("Moon & more");
    m_fixture->press(Qt::Key_R, Qt::ControlModifier);
    COMPARE_EXACT(own("gravity"), 9.81);
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    choose("Moon & more");
    COMPARE_EXACT(own("gravity"), 1.62);
    COMPARE_EXACT(own("tilt_x"), 0.0); // the board's tilt isn't part of it
}

void TestWindowSets::longNameLeavesTheMenuOnTheScreen() {
    save(QString(300, 'x'));
    const int width = menu()->sizeHint().width();
    m_fixture->find<QMenu>("set_menu")->close();
    QVERIFY2(width < 600, qPrintable(QString::number(width)));
}

// The dialog that asks for a name.
QInputDialog *TestWindowSets::asked() {
    choose("Save these parameters as…");
    [this] { QTRY_VERIFY(m_fixture->window().findChild<QInputDialog *>("set_name")); }();
    auto *dialog = m_fixture->find<QInputDialog>("set_name");
    [dialog] { QTRY_VERIFY(dialog->findChild<QLineEdit *>()->isVisible()); }();
    return dialog;
}

QAbstractButton *TestWindowSets::saveButton(const QInputDialog &dialog) {
    return dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
}

// Two entries of the same text couldn't be told apart.
void TestWindowSets::nameOfABuiltInSetCantBeSaved() {
    QInputDialog *dialog = asked();
    QTest::keyClicks(dialog->findChild<QLineEdit *>(), "Steel on wood");
    QVERIFY(!saveButton(*dialog)->isEnabled());
    QVERIFY2(dialog->labelText().contains("built-in"), qPrintable(dialog->labelText()));
    QTest::keyClick(dialog->findChild<QLineEdit *>(), Qt::Key_Backspace);
    QVERIFY(saveButton(*dialog)->isEnabled());
    QVERIFY2(!dialog->labelText().contains("built-in"), qPrintable(dialog->labelText()));
    dialog->reject();
}

void TestWindowSets::replacedSetIsSaidBefore() {
    save("Mine");
    m_fixture->parameters().set({{"gravity", 1.62}});
    QInputDialog *dialog = asked();
    QTest::keyClicks(dialog->findChild<QLineEdit *>(), "Min");
    QCOMPARE(saveButton(*dialog)->text(), QString("Save"));
    QTest::keyClicks(dialog->findChild<QLineEdit *>(), "e");
    QCOMPARE(saveButton(*dialog)->text(), QString("Replace"));
    QVERIFY2(dialog->labelText().contains("replaces"), qPrintable(dialog->labelText()));
    QTest::keyClick(dialog->findChild<QLineEdit *>(), Qt::Key_Return);
    QTRY_VERIFY(m_fixture->settings().value("parameter_sets/Mine").toString().contains("gravity 1.62"));
}

void TestWindowSets::importedSetReplacesNoOther_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("built-in") << "Steel on wood";
    QTest::newRow("of the user") << "Mine";
}

void TestWindowSets::importedSetReplacesNoOther() {
    QFETCH(QString, name);
    save("Mine");
    const QString before = m_fixture->settings().value("parameter_sets/Mine").toString();
    const QString path = m_fixture->path("other.txt");
    support::write(path, "physics-parameters 1\nname " + name.toUtf8() + "\nset gravity 1.62\n");
    for (int i = 0; i < 2; ++i) { // the same again is no other
        choose("Import…");
        m_fixture->answerFile(path);
        QTRY_VERIFY(m_fixture->settings().contains("parameter_sets/" + name + " 2"));
    }
    COMPARE_EXACT(own("gravity"), 1.62);
    QCOMPARE(m_fixture->settings().value("parameter_sets/Mine").toString(), before);
    QVERIFY(!m_fixture->settings().contains("parameter_sets/Steel on wood"));
    QVERIFY(!m_fixture->settings().contains("parameter_sets/" + name + " 3"));
}

void TestWindowSets::nameIsTheKeyOfTheSettings_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("key");
    QTest::newRow("words") << "Ball on ice"
                           << "Ball on ice";
    QTest::newRow("slash") << "a/b"
                           << "a%2Fb";
    QTest::newRow("share") << "50%"
                           << "50%25";
}

void TestWindowSets::nameIsTheKeyOfTheSettings() {
    QFETCH(QString, name);
    QFETCH(QString, key);
    save(name);
    QVERIFY2(m_fixture->settings().contains("parameter_sets/" + key),
             qPrintable(m_fixture->settings().allKeys().join(' ')));
    choose(name); // it reads back
}

// Of earlier versions, which escaped more.
void TestWindowSets::setOfAnEarlierVersionIsRenamed() {
    m_fixture->settings().setValue("parameter_sets/Ball%20on%20ice", "physics-parameters 1\nset gravity 1.62\n");
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    QVERIFY(m_fixture->settings().contains("parameter_sets/Ball on ice"));
    choose("Ball on ice", "Delete");
    QVERIFY(m_fixture->settings().allKeys().filter("parameter_sets").isEmpty());
}

void TestWindowSets::blankNameCantBeSaved() {
    QInputDialog *dialog = asked();
    const QAbstractButton *save = saveButton(*dialog);
    QTest::keyClicks(dialog->findChild<QLineEdit *>(), "  ");
    QVERIFY(!save->isEnabled());
    QTest::keyClick(dialog->findChild<QLineEdit *>(), Qt::Key_Return);
    QVERIFY(dialog->isVisible());
    QTest::keyClicks(dialog->findChild<QLineEdit *>(), "a");
    QVERIFY(save->isEnabled());
    dialog->reject();
}

void TestWindowSets::deletionIsUndone() {
    const auto isThere = [this] { return m_fixture->settings().contains("parameter_sets/Mine"); };
    save("Mine");
    QVERIFY(isThere());
    choose("Mine", "Delete");
    QVERIFY(!isThere());
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(isThere());
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier); // the save
    QVERIFY(!isThere());
}

void TestWindowSets::ghostGetsASetOfItsOwn() {
    m_fixture->press(Qt::Key_C, Qt::ShiftModifier);
    choose("Steel on ice", "For the ghost");
    const inspector::Parameters &ghosts = m_fixture->session().comparison().parameters();
    COMPARE_EXACT(ghosts.value(ghosts.indexOf("sliding_friction")), 0.02);
    COMPARE_EXACT(own("sliding_friction"), 0.3);
}

void TestWindowSets::exportedFileIsImported() {
    m_fixture->parameters().set({{"gravity", 1.62}});
    const QString path = m_fixture->path("moon.txt");
    choose("Export…");
    m_fixture->answerFile(path);
    QTRY_VERIFY(QFile::exists(path));
    QVERIFY(support::contentOf(path).startsWith("physics-parameters 1\nname moon\nset gravity 1.62\n"));
    m_fixture->press(Qt::Key_R, Qt::ControlModifier);
    choose("Import…");
    m_fixture->answerFile(path);
    QTRY_COMPARE(own("gravity"), 1.62);
    QVERIFY(m_fixture->settings().contains("parameter_sets/moon"));
    m_fixture->press(Qt::Key_Z, Qt::ControlModifier); // both at once
    COMPARE_EXACT(own("gravity"), 9.81);
    QVERIFY(!m_fixture->settings().contains("parameter_sets/moon"));
}

void TestWindowSets::fileThatIsNoneIsRefusedInOneLine() {
    const QString path = m_fixture->path("no.txt");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("nothing\n") == 8);
    file.close();
    choose("Import…");
    m_fixture->answerFile(path);
    QTRY_COMPARE(m_fixture->window().messages().line(), path + ":1: expected 'physics-parameters 1', found 'nothing'");
    COMPARE_EXACT(own("gravity"), 9.81);
}

// A recorded ball's values can't be changed.
void TestWindowSets::refuseInRecording() {
    const QString file = m_fixture->path("run.rec");
    m_fixture->makeSteps(20);
    QString error;
    QVERIFY2(m_fixture->session().saveRun(file, &error), qPrintable(error));
    m_fixture->drop(file);
    QTRY_VERIFY(m_fixture->session().isReplaying());
    choose("Steel on wood");
    QVERIFY(m_fixture->window().messages().line().startsWith("a recording is shown as it was"));
}

void TestWindowSets::refusalInARecordingGoesWithTheNextCommand_data() {
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::newRow("go on") << Qt::Key_G << Qt::KeyboardModifiers();
    QTest::newRow("run") << Qt::Key_Space << Qt::KeyboardModifiers();
    QTest::newRow("close the recording") << Qt::Key_W << Qt::KeyboardModifiers(Qt::ControlModifier);
    QTest::newRow("ghost's parameters") << Qt::Key_C << Qt::KeyboardModifiers(Qt::ShiftModifier);
    QTest::newRow("compare") << Qt::Key_C << Qt::KeyboardModifiers();
    QTest::newRow("restart") << Qt::Key_R << Qt::KeyboardModifiers();
}

void TestWindowSets::refusalInARecordingGoesWithTheNextCommand() {
    QFETCH(Qt::Key, key);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    refuseInRecording();
    m_fixture->press(key, modifiers);
    QCOMPARE(m_fixture->window().messages().line(), QString());
}

void TestWindowSets::refusalInARecordingGoesWithTheGhostsNextValue() {
    m_fixture->press(Qt::Key_C, Qt::ShiftModifier);
    refuseInRecording();
    choose("Steel on ice", "For the ghost");
    QCOMPARE(m_fixture->window().messages().line(), QString());
}

QTEST_MAIN(TestWindowSets)
#include "tst_window_sets.moc"
