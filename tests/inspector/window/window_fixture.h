// SPDX-License-Identifier: MIT
// A window over a level with its own settings, driven by real mouse and key events.
#pragma once

#include "core/session/session.h"
#include "gl/view/maze_view.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QObject>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include <initializer_list>
#include <memory>

#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE
#define QTRY_VERIFY(expression) QTRY_VERIFY_WITH_TIMEOUT((expression), window_test::kPatience)
#define QTRY_VERIFY2(expression, message) QTRY_VERIFY2_WITH_TIMEOUT((expression), (message), window_test::kPatience)
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT((actual), (expected), window_test::kPatience)

class QCustomPlot;

namespace window_test {

// A time limit that only stops what hangs; QTest's 5 s are too short on a busy machine.
constexpr int kPatience = 60000; // ms

// Call before the application object exists.
void prepare();

/// The text above a plot's curves about the sample under the cursor.
QString readOutOf(const QCustomPlot *plot);

/// Whether that text has the room that it needs.
bool isReadOutWhole(const QCustomPlot *plot);

// Solid in those of a suite's facts, which are about what the view shows: by OpenGL a window takes twice the time.
inspector::gl::Drawing solidIn(std::initializer_list<const char *> facts);

class Fixture {
public:
    explicit Fixture(int level = 1, inspector::gl::Drawing drawing = inspector::gl::Drawing::Flat,
                     const QString &levels = QStringLiteral(LEVELS_FOLDER));
    // The window is on the screen, has drawn once and has the keyboard.
    bool isReady();

    inspector::Session &session() { return *m_session; }
    inspector::Simulation &simulation() { return m_session->simulation(); }
    inspector::Parameters &parameters() { return m_session->parameters(); }
    inspector::Game &game() { return m_session->game(); }
    inspector::ui::MainWindow &window() { return *m_window; }
    QSettings &settings() { return m_settings; }
    QString path(const QString &name) const { return m_folder.filePath(name); }
    // Closes the window and opens another one on the same session.
    void reopen();

    // The simulation's own value of a parameter row.
    double simulated(const QString &id);

    // A child of the window. If there is none, the program ends and lists the children that exist.
    template<typename Widget>
    Widget *find(const QString &name) {
        auto *found = m_window->findChild<Widget *>(name);
        if (!found) reportMissing(name);
        return found;
    }
    void trigger(const QString &action) { find<QAction>(action)->trigger(); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(m_window.get(), key, modifiers); }

    // Sends a key as the window system does: to whatever has the keyboard, which may be an open list. Enter in a text
    // waits until the board has the keyboard again.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
    void type(const QString &text);
    // Uses the command for a single step; waits for the last one.
    void makeSteps(uint64_t count);
    // Drops a file from another program onto the window.
    void drop(const QString &path);
    // Chooses a file in the dialog that is open or about to be.
    void answerFile(const QString &path);

private:
    [[noreturn]] void reportMissing(const QString &name) const;

    inspector::gl::Drawing m_drawing;
    QTemporaryDir m_folder;
    QSettings m_settings;
    std::unique_ptr<inspector::Session> m_session;
    std::unique_ptr<inspector::ui::MainWindow> m_window;
};

// A suite of which each fact has a new window.
class WindowSuite : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepare(); }

protected:
    // Makes the window, over level 1 drawn flat unless told otherwise, and shows it.
    template<typename... Arguments>
    bool open(Arguments... arguments) {
        m_fixture = std::make_unique<Fixture>(arguments...);
        return m_fixture->isReady();
    }

    std::unique_ptr<Fixture> m_fixture;

private slots:
    virtual void init();
    virtual void cleanup();
};

void click(QWidget *widget);
void drag(QWidget *widget, const QPoint &from, const QPoint &to, Qt::KeyboardModifiers modifiers = {});
void turnWheel(QWidget *widget, const QPoint &place, int notches, Qt::KeyboardModifiers modifiers = {});
void hover(QWidget *widget, const QPoint &place);

} // namespace window_test
