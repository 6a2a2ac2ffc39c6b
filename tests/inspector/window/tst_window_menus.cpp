// SPDX-License-Identifier: MIT
// All menus: what is in them, and the letters by which their entries are chosen.
#include "support/files.h"
#include "ui/input/menu_letters.h"
#include "window_fixture.h"

#include <QAbstractScrollArea>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeySequence>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTableView>
#include <QUndoStack>

using namespace window_test;
using inspector::ui::plainText;

class TestWindowMenus : public WindowSuite {
    Q_OBJECT

private slots:
    void cleanup() override;
    void everyMenuHasItsEntries();
    void noMenuSaysTheSameTwice();
    void everyEntryHasALetterOfItsOwn_data();
    void everyEntryHasALetterOfItsOwn();
    void letterChoosesItsEntry();
    void entryKeepsItsLetter();
    void nameWithTheMarkIsShownAsItIs();

private:
    void openByKey(Qt::Key key);
    void openContextMenuOf(QWidget *widget);
    QStringList faultsOf(QMenu &menu);
    static QChar letterOf(const QAction &entry);
    QAction *entryOf(const QString &text);
};

void TestWindowMenus::cleanup() {
    while (QWidget *open = QApplication::activePopupWidget()) open->close();
    m_fixture.reset();
}

void TestWindowMenus::everyMenuHasItsEntries() {
    QStringList titles;
    for (const QAction *menu : m_fixture->window().menuBar()->actions()) {
        titles << plainText(menu->text());
        QVERIFY2(menu->menu()->actions().size() >= 2, qPrintable(menu->text()));
    }
    QCOMPARE(titles, QStringList({"File", "Edit", "View", "Game", "Help"}));
}

void TestWindowMenus::noMenuSaysTheSameTwice() {
    m_fixture->trigger("run"); // whose entry then says that it pauses
    QTRY_COMPARE(m_fixture->find<QAction>("run")->text(), QString("Pause"));
    for (const QAction *menu : m_fixture->window().menuBar()->actions()) {
        QStringList texts;
        for (const QAction *entry : menu->menu()->actions())
            if (!entry->isSeparator()) texts << plainText(entry->text());
        QVERIFY2(texts.removeDuplicates() == 0, qPrintable(menu->text()));
    }
}

// Of the menu bar.
void TestWindowMenus::openByKey(Qt::Key key) {
    m_fixture->press(key, Qt::AltModifier);
    QTRY_VERIFY(QApplication::activePopupWidget());
}

void TestWindowMenus::openContextMenuOf(QWidget *widget) {
    const QPoint place = widget->rect().center();
    QContextMenuEvent asked(QContextMenuEvent::Mouse, place, widget->mapToGlobal(place));
    QApplication::sendEvent(widget, &asked);
    QTRY_VERIFY(QApplication::activePopupWidget());
}

QChar TestWindowMenus::letterOf(const QAction &entry) {
    const QKeySequence keys = QKeySequence::mnemonic(entry.text());
    return keys.isEmpty() ? QChar() : QChar(ushort(keys[0].key()));
}

// Of the menu that is open.
QAction *TestWindowMenus::entryOf(const QString &text) {
    for (QAction *entry : QApplication::activePopupWidget()->actions())
        if (plainText(entry->text()) == text) return entry;
    return nullptr;
}

// Entries without a letter, and those whose letter another one has; also of the menus in it, which are opened in turn.
QStringList TestWindowMenus::faultsOf(QMenu &menu) {
    QStringList faults;
    QHash<QChar, QString> owners;
    for (QAction *entry : menu.actions()) {
        if (entry->isSeparator()) continue;
        const QChar letter = letterOf(*entry);
        if (!letter.isLetterOrNumber()) faults << "no letter: " + entry->text();
        if (owners.contains(letter)) faults << owners[letter] + " as " + entry->text();
        owners[letter] = entry->text();
    }
    if (owners.isEmpty()) faults << "no entries";
    for (QAction *entry : menu.actions()) {
        if (!entry->menu()) continue;
        entry->menu()->popup(menu.pos() + QPoint(30, 30));
        for (const QString &fault : faultsOf(*entry->menu())) faults << plainText(entry->text()) + " > " + fault;
        entry->menu()->close();
    }
    return faults;
}

void TestWindowMenus::everyEntryHasALetterOfItsOwn_data() {
    QTest::addColumn<std::function<void()>>("open");
    const auto row = [](const char *name, const std::function<void()> &open) { QTest::newRow(name) << open; };
    row("file", [this] {
        const QString maze = m_fixture->path("mine.txt");
        QFile::copy(m_fixture->session().level().path, maze);
        m_fixture->drop(maze);
        openByKey(Qt::Key_F);
    });
    row("edit", [this] {
        m_fixture->session().parameters().set({{"gravity", 3.0}});
        openByKey(Qt::Key_E);
    });
    row("view", [this] { openByKey(Qt::Key_V); });
    row("game", [this] { openByKey(Qt::Key_G); });
    row("game while it runs", [this] {
        m_fixture->trigger("run");
        QTRY_COMPARE(m_fixture->find<QAction>("run")->text(), QString("Pause"));
        openByKey(Qt::Key_G);
    });
    row("help", [this] { openByKey(Qt::Key_H); });
    row("sets", [this] {
        for (const char *name : {"Steel", "Steel & wood", "Steel 3"})
            m_fixture->settings().setValue(QStringLiteral("parameter_sets/") + name,
                                           "physics-parameters 1\nset gravity 3\n");
        m_fixture->find<QMenu>("set_menu")->popup(m_fixture->window().pos());
    });
    row("plot", [this] { openContextMenuOf(m_fixture->find<QWidget>("velocity_plot")); });
    row("watch", [this] {
        m_fixture->trigger("show_watch_dock");
        openContextMenuOf(m_fixture->find<QAbstractScrollArea>("watched")->viewport());
    });
    row("columns of the trade", [this] {
        m_fixture->trigger("show_trade_dock");
        openContextMenuOf(m_fixture->find<QTableView>("trade_table")->horizontalHeader()->viewport());
    });
    row("a text", [this] {
        m_fixture->trigger("show_track_dock");
        auto *text = m_fixture->find<QLineEdit>("track_units");
        QTRY_VERIFY(text->isVisible());
        openContextMenuOf(text);
    });
    row("docks and bars", [this] { openContextMenuOf(m_fixture->window().menuBar()); });
}

void TestWindowMenus::everyEntryHasALetterOfItsOwn() {
    QFETCH(std::function<void()>, open);
    open();
    auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
    QVERIFY(menu);
    const QStringList faults = faultsOf(*menu);
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
}

void TestWindowMenus::letterChoosesItsEntry() {
    openByKey(Qt::Key_G);
    const QAction *autopilot = entryOf("Autopilot");
    QVERIFY(autopilot);
    m_fixture->type(letterOf(*autopilot));
    QVERIFY(m_fixture->session().hasAutopilot());
    QTRY_VERIFY(!QApplication::activePopupWidget());
}

// While others come, go, or say something else.
void TestWindowMenus::entryKeepsItsLetter() {
    const auto letters = [&] {
        openByKey(Qt::Key_G);
        QString all;
        for (const QAction *entry : QApplication::activePopupWidget()->actions())
            if (entry->objectName() != "run" && !entry->isSeparator()) all += letterOf(*entry);
        QApplication::activePopupWidget()->close();
        return all;
    };
    const QString before = letters();
    m_fixture->trigger("run");
    QTRY_COMPARE(plainText(m_fixture->find<QAction>("run")->text()), QString("Pause"));
    QCOMPARE(letters(), before);
}

void TestWindowMenus::nameWithTheMarkIsShownAsItIs() {
    m_fixture->settings().setValue("parameter_sets/Moon & more", "physics-parameters 1\nset gravity 3\n");
    m_fixture->find<QMenu>("set_menu")->popup(m_fixture->window().pos());
    const QAction *entry = entryOf("Moon & more");
    QVERIFY(entry);
    QVERIFY2(entry->text().contains(" && "), qPrintable(entry->text()));
}

QTEST_MAIN(TestWindowMenus)
#include "tst_window_menus.moc"
