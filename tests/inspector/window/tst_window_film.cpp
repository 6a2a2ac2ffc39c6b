// SPDX-License-Identifier: MIT
// The last seconds as pictures in a folder or as one file: progress, cancelling, and no effect on the simulation.
#include "support/file_limit.h"
#include "support/files.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/number_box.h"
#include "ui/window/film.h"
#include "window_fixture.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QProgressDialog>
#include <QPushButton>
#include <QStandardPaths>

using namespace window_test;
using inspector::ui::NumberBox;

class TestWindowFilm : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void cleanup() override;
    void escGivesBackAChangedNumberThenLeaves();
    void enterTakesAChangedNumberThenSaves();
    void numberTypedFirstTakesTheUsualOnesPlace();
    void filmIsOfTheSecondsAskedFor();
    void picturesFollowTheBall();
    void filmIsOfTheRunShown();
    void filmOfARecordingIsOfItsRun();
    void runWithoutStepsIsOnePictureOfItsStart();
    void presentIsShownAgainAfterwards();
    void cancelledFilmLeavesNothing();
    void filmOfAWindowThatEndsLeavesNothing();
    void folderThatHoldsSomethingIsRefused();
    void withoutToolThereArePicturesOnly();
    void toolGetsThePicturesAndTheirRate();
    void whatTheToolCanNotDoIsSaid();
    void whatAFileLimitLosesIsSaidAndNoPictureIsLeft();
    void whatAFileLimitLosesOfAFilmIsSaidAndTheLastOneIsKept();
    void filmIsOneFile_data();
    void filmIsOneFile();

private:
    phys_state ball() { return m_fixture->simulation().latest().current; }
    void openDialog();
    void ask(const QString &seconds, const QString &rate, const QString &path, int kind = 0);
    void putInPath(const QByteArray &script);
    QStringList picturesIn(const QString &folder) { return QDir(folder).entryList({"*.png"}, QDir::Files, QDir::Name); }
    bool isOver() { return !m_fixture->window().findChild<QProgressDialog *>("film_progress"); }

    const QByteArray m_path = qgetenv("PATH");
};

void TestWindowFilm::init() {
    m_fixture = std::make_unique<Fixture>(3, solidIn({"picturesFollowTheBall", "filmOfARecordingIsOfItsRun"}));
    m_fixture->window().resize(1100, 420); // small pictures, below a line of text
    QVERIFY(m_fixture->isReady());
    m_fixture->parameters().set({{"tilt_x", 3.0}, {"tilt_y", 4.0}});
    m_fixture->makeSteps(100); // 1 s
}

void TestWindowFilm::cleanup() {
    m_fixture.reset();
    qputenv("PATH", m_path);
}

// Puts a tool of this name with these lines into the path, and nothing else.
void TestWindowFilm::putInPath(const QByteArray &script) {
    QVERIFY(QDir().mkpath(m_fixture->path("tools")));
    QFile tool(m_fixture->path("tools/ffmpeg"));
    QVERIFY(tool.open(QIODevice::WriteOnly));
    tool.write("#!/bin/sh\n" + script);
    tool.setPermissions(QFile::ReadOwner | QFile::ExeOwner);
    qputenv("PATH", QFile::encodeName(m_fixture->path("tools")));
}

void TestWindowFilm::openDialog() {
    m_fixture->press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(m_fixture->window().findChild<QDialog *>("film_dialog"));
    auto *dialog = m_fixture->find<QDialog>("film_dialog");
    dialog->activateWindow(); // as window managers do
    QTRY_COMPARE(QApplication::activeWindow(), dialog);
}

void TestWindowFilm::ask(const QString &seconds, const QString &rate, const QString &path, int kind) {
    openDialog();
    const std::pair<const char *, QString> fields[] = {{"film_seconds", seconds}, {"film_rate", rate}};
    for (const auto &[name, text] : fields) {
        auto *box = m_fixture->find<NumberBox>(name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
    }
    auto *kinds = m_fixture->find<QComboBox>("film_kind");
    kinds->setFocus();
    for (int i = 0; i < kind; ++i) QTest::keyClick(kinds, Qt::Key_Down);
    QCOMPARE(kinds->currentIndex(), kind);
    click(m_fixture->find<QDialog>("film_dialog")->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok));
    m_fixture->answerFile(path);
}

void TestWindowFilm::escGivesBackAChangedNumberThenLeaves() {
    openDialog();
    auto *seconds = m_fixture->find<NumberBox>("film_seconds");
    QCOMPARE(QApplication::focusWidget(), seconds);
    const QString before = seconds->text();
    m_fixture->type("7");
    m_fixture->key(Qt::Key_Escape);
    QCOMPARE(seconds->text(), before);
    QVERIFY(m_fixture->find<QDialog>("film_dialog")->isVisible());
    m_fixture->key(Qt::Key_Escape);
    QTRY_VERIFY(!m_fixture->window().findChild<QDialog *>("film_dialog"));
}

void TestWindowFilm::enterTakesAChangedNumberThenSaves() {
    openDialog();
    auto *seconds = m_fixture->find<NumberBox>("film_seconds");
    seconds->selectAll();
    m_fixture->type("0.2");
    m_fixture->key(Qt::Key_Return);
    QCOMPARE(seconds->value(), 0.2);
    QVERIFY(m_fixture->find<QDialog>("film_dialog")->isVisible());
    m_fixture->key(Qt::Key_Return);
    const QString folder = m_fixture->path("film");
    m_fixture->answerFile(folder);
    QTRY_VERIFY(isOver());
    QVERIFY(!picturesIn(folder).isEmpty());
}

void TestWindowFilm::numberTypedFirstTakesTheUsualOnesPlace() {
    openDialog();
    m_fixture->type("3");
    m_fixture->key(Qt::Key_Return);
    QCOMPARE(m_fixture->find<NumberBox>("film_seconds")->value(), 3.0);
}

void TestWindowFilm::filmIsOfTheSecondsAskedFor() {
    const QString folder = m_fixture->path("film");
    ask("0.5", "10", folder);
    QTRY_COMPARE(picturesIn(folder).size(), 6); // both ends
    QTRY_VERIFY(isOver());
    QCOMPARE(picturesIn(folder).first(), QString("00001.png"));
    const QImage first(folder + "/00001.png");
    QCOMPARE(first.size(), m_fixture->window().view().size() * m_fixture->window().devicePixelRatio());
    QCOMPARE(m_fixture->window().messages().line(), QString());
}

void TestWindowFilm::picturesFollowTheBall() {
    const QString folder = m_fixture->path("film");
    ask("0.9", "2", folder);
    QTRY_COMPARE(picturesIn(folder).size(), 2);
    QTRY_VERIFY(isOver());
    QVERIFY(QImage(folder + "/00001.png") != QImage(folder + "/00002.png"));
}

// Also if more seconds are asked for than it has.
void TestWindowFilm::filmIsOfTheRunShown() {
    m_fixture->press(Qt::Key_R);
    QTRY_COMPARE(ball().step, uint64_t(0));
    m_fixture->parameters().set({{"tilt_x", -3.0}, {"tilt_y", -4.0}});
    m_fixture->makeSteps(50);
    const QString folder = m_fixture->path("film");
    ask("10", "10", folder);
    QTRY_VERIFY(m_fixture->session().isInPast());
    while (m_fixture->session().isInPast()) {
        QCOMPARE(m_fixture->session().runPlace().begin, uint64_t(101));
        QTest::qWait(1);
    }
    QTRY_VERIFY(isOver());
    QCOMPARE(picturesIn(folder).size(), 6);
}

void TestWindowFilm::filmOfARecordingIsOfItsRun() {
    inspector::Session &session = m_fixture->session();
    const auto position = [&] { return m_fixture->simulation().latest().replay.position; };
    QVERIFY(session.saveRun(m_fixture->path("run.rec"), nullptr));
    QVERIFY(session.openRecording(m_fixture->path("run.rec")));
    m_fixture->simulation().pause();
    session.replay()->seek(60);
    QTRY_COMPARE(position(), uint64_t(60));
    const QString folder = m_fixture->path("film");
    ask("0.2", "10", folder);
    while (!isOver()) {
        const uint64_t shown = position();
        QVERIFY2(shown == 40 || shown == 50 || shown == 60, qPrintable(QString::number(shown)));
        QTest::qWait(1);
    }
    QCOMPARE(picturesIn(folder).size(), 3);
    QVERIFY(QImage(folder + "/00001.png") != QImage(folder + "/00003.png"));
    QTRY_COMPARE(position(), uint64_t(60));
    QVERIFY(session.isReplaying());
    for (const char *name : {"table.csv", "picture.png"}) {
        m_fixture->trigger("save_run");
        m_fixture->answerFile(m_fixture->path(name));
        QVERIFY2(QFile::exists(m_fixture->path(name)), name);
    }
    QCOMPARE(support::contentOf(m_fixture->path("table.csv")).count('\n'), 61); // with its header
}

void TestWindowFilm::runWithoutStepsIsOnePictureOfItsStart() {
    m_fixture->press(Qt::Key_R);
    QTRY_COMPARE(ball().step, uint64_t(0));
    m_fixture->key(Qt::Key_Home, Qt::ControlModifier);
    QVERIFY(!m_fixture->session().isInPast());
    const QString folder = m_fixture->path("film");
    ask("10", "10", folder);
    QTRY_VERIFY(isOver());
    QCOMPARE(picturesIn(folder).size(), 1);
    QVERIFY(!m_fixture->session().isInPast());
    QCOMPARE(ball().step, uint64_t(0));
}

void TestWindowFilm::presentIsShownAgainAfterwards() {
    const phys_state before = ball();
    ask("0.2", "10", m_fixture->path("film"));
    QTRY_COMPARE(picturesIn(m_fixture->path("film")).size(), 3);
    QTRY_VERIFY(isOver());
    QTRY_VERIFY(!m_fixture->session().isInPast());
    QTRY_COMPARE(ball().step, before.step);
}

void TestWindowFilm::cancelledFilmLeavesNothing() {
    const QString folder = m_fixture->path("film");
    ask("1", "100", folder);
    QTRY_VERIFY(!picturesIn(folder).isEmpty());
    m_fixture->find<QProgressDialog>("film_progress")->cancel();
    QTRY_VERIFY(isOver());
    QVERIFY(!QDir(folder).exists());
    QTRY_VERIFY(!m_fixture->session().isInPast());
}

void TestWindowFilm::filmOfAWindowThatEndsLeavesNothing() {
    const QTemporaryDir own;
    const QString folder = own.filePath("film");
    ask("1", "100", folder);
    QTRY_VERIFY(!picturesIn(folder).isEmpty());
    m_fixture.reset();
    QVERIFY(!QDir(folder).exists());
}

void TestWindowFilm::folderThatHoldsSomethingIsRefused() {
    const QString folder = m_fixture->path("full");
    QVERIFY(QDir().mkpath(folder + "/inner"));
    QString error;
    auto *film = new inspector::ui::Film(m_fixture->session(), m_fixture->window().view(), {}, 1, m_fixture->window());
    QVERIFY(!film->begin(folder, &error));
    QCOMPARE(error, '\'' + folder + "': expected a new or an empty folder, found one that holds something");
    QVERIFY(picturesIn(folder).isEmpty());
}

void TestWindowFilm::withoutToolThereArePicturesOnly() {
    qputenv("PATH", QFile::encodeName(m_fixture->path("nothing")));
    m_fixture->trigger("save_film");
    QTRY_VERIFY(m_fixture->window().findChild<QDialog *>("film_dialog"));
    QCOMPARE(m_fixture->find<QComboBox>("film_kind")->count(), 1);
}

// The tool lists its arguments and the folder's files.
void TestWindowFilm::toolGetsThePicturesAndTheirRate() {
    putInPath("for last; do :; done\n{ echo \"$@\"; echo *.png; } > \"$last\"\n");
    const QString file = m_fixture->path("film.gif");
    ask("0.2", "10", file, 2);
    QTRY_VERIFY(isOver());
    QFile film(file);
    QVERIFY(film.open(QIODevice::ReadOnly));
    QVERIFY(film.readLine().startsWith("-v error -framerate 10 -i %05d.png "));
    QCOMPARE(film.readLine(), QByteArray("00001.png 00002.png 00003.png\n"));
}

void TestWindowFilm::whatTheToolCanNotDoIsSaid() {
    putInPath("echo something >&2\necho no room >&2\nexit 1\n");
    const QString file = m_fixture->path("film.webm");
    ask("0.2", "10", file, 1);
    QTRY_VERIFY(isOver());
    QCOMPARE(m_fixture->window().messages().line(), QString("ffmpeg: no room"));
    QVERIFY(!QFile::exists(file));
}

void TestWindowFilm::whatAFileLimitLosesIsSaidAndNoPictureIsLeft() {
    const QString folder = m_fixture->path("film");
    ask("0.2", "10", folder);
    const support::FileLimit limit(100);
    QTRY_VERIFY(isOver());
    QCOMPARE(m_fixture->window().messages().line(), "'" + folder + "/00001.png': File too large");
    QVERIFY(!QDir(folder).exists());
}

// The tool isn't limited and writes more than the program is allowed to.
void TestWindowFilm::whatAFileLimitLosesOfAFilmIsSaidAndTheLastOneIsKept() {
    putInPath("for last; do :; done\nulimit -S -f unlimited\nhead -c 9000000 /dev/zero > \"$last\"\n");
    qputenv("PATH", qgetenv("PATH") + ":" + m_path);
    const QString file = m_fixture->path("film.gif");
    support::write(file, "the last one");
    ask("0.2", "10", file, 2);
    const support::FileLimit limit(8'000'000);
    QTRY_VERIFY(isOver());
    QCOMPARE(m_fixture->window().messages().line(), "'" + file + "': File too large");
    QCOMPARE(support::contentOf(file), QByteArray("the last one"));
}

void TestWindowFilm::filmIsOneFile_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("beginning");
    QTest::newRow("webm") << 1 << "film.webm" << QByteArray("\x1a\x45\xdf\xa3"); // EBML
    QTest::newRow("gif") << 2 << "film.gif" << QByteArray("GIF89a");
}

void TestWindowFilm::filmIsOneFile() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("ffmpeg isn't installed");
    QFETCH(int, kind);
    QFETCH(QString, name);
    QFETCH(QByteArray, beginning);
    const QString file = m_fixture->path(name);
    ask("0.2", "10", file, kind);
    QTRY_VERIFY(isOver());
    QCOMPARE(m_fixture->window().messages().line(), QString());
    QFile film(file);
    QVERIFY(film.open(QIODevice::ReadOnly));
    QCOMPARE(film.read(beginning.size()), beginning);
}

QTEST_MAIN(TestWindowFilm)
#include "tst_window_film.moc"
