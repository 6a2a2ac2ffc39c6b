// SPDX-License-Identifier: MIT
// What can't be used is marked where it was typed, readable in every theme; it is said when it happens, and takes
// nothing away.
#include "inspector/contrast.h"
#include "inspector/track/made_track.h"
#include "support/files.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/theme.h"
#include "ui/track/track_dock.h"
#include "window_fixture.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QHash>
#include <QImage>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScopeGuard>

#include <algorithm>
#include <memory>

using namespace window_test;
using inspector::ui::MessageBar;

class TestWindowRefusals : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void refusedTextCanBeReadInEveryTheme_data();
    void refusedTextCanBeReadInEveryTheme();
    void reasonFollowsTheTheme();
    void lostSettingsAreSaidAtTheChangeAndOnce();
    void refusedTableTakesNothingAway();
    void refusedUnitsTakeNothingAway();
    void pictureDoesNotReplaceARecording();
    void endingOfAnotherKindIsRefused_data();
    void endingOfAnotherKindIsRefused();

private:
    void choose(const QString &theme);
    QLineEdit *refused(const QString &name);
    QString report() { return m_fixture->find<QPlainTextEdit>("track_report")->toPlainText(); }
    QString write(const char *name, const QByteArray &text);
};

namespace {

// The most common colour.
QColor backgroundOf(const QImage &picture) {
    QHash<QRgb, int> counts;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) ++counts[picture.pixel(x, y)];
    return QColor(
        std::max_element(counts.keyValueBegin(), counts.keyValueEnd(), [](const auto &one, const auto &other) {
            return one.second < other.second;
        })->first);
}

// Between the background and the reddest pixel.
double contrastOfRedIn(const QImage &picture, const QColor &background) {
    const auto redness = [](QRgb pixel) { return qRed(pixel) - qBlue(pixel); };
    QRgb reddest = picture.pixel(0, 0);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (redness(picture.pixel(x, y)) > redness(reddest)) reddest = picture.pixel(x, y);
    return redness(reddest) > 60 ? support::contrastOf(QColor(reddest), background) : 0.0;
}

} // namespace

void TestWindowRefusals::init() { QVERIFY(open(3)); }

// Widgets get the palette with the next events.
void TestWindowRefusals::choose(const QString &theme) {
    m_fixture->trigger(theme);
    const auto has = [](const QWidget &widget) {
        return widget.palette().color(QPalette::Base) == QApplication::palette().color(QPalette::Base);
    };
    QTRY_VERIFY(has(m_fixture->window()) && has(*m_fixture->find<QWidget>("tilt_x_box")));
}

// Typed into a field of a dock that is open, and entered.
QLineEdit *TestWindowRefusals::refused(const QString &name) {
    auto *field = m_fixture->find<QLineEdit>(name);
    field->setFocus();
    field->selectAll();
    m_fixture->type("nonsense");
    m_fixture->key(Qt::Key_Return);
    return field;
}

QString TestWindowRefusals::write(const char *name, const QByteArray &text) {
    QFile file(m_fixture->path(QLatin1String(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("%s", name);
    return file.fileName();
}

void TestWindowRefusals::refusedTextCanBeReadInEveryTheme_data() {
    QTest::addColumn<QString>("dock");
    QTest::addColumn<QString>("field");
    QTest::addColumn<QString>("shown");
    QTest::addColumn<QString>("theme");
    const struct {
        const char *dock, *field, *shown;
    } fields[] = {
        {"", "gravity_box", "gravity_box"},
        {"", "time_step_box", "time_step_box"},
        {"show_track_dock", "track_file", "track_file"},
        {"show_track_dock", "track_units", "track_units"},
        {"show_trade_dock", "trade_unknowns", "trade_unknowns"},
        {"show_trade_dock", "trade_unknowns", "trade_unknowns_error"},
    };
    for (const char *theme : {"theme_0", "theme_1", "theme_2"})
        for (const auto &each : fields)
            QTest::addRow("%s %s", each.shown, theme) << each.dock << each.field << each.shown << theme;
}

// As painted: WCAG 2.1, 1.4.3 for the colours; thin letters are painted paler. The theme changes while the text is
// there, and the field keeps nothing of the theme before.
void TestWindowRefusals::refusedTextCanBeReadInEveryTheme() {
    QFETCH(QString, dock);
    QFETCH(QString, field);
    QFETCH(QString, shown);
    QFETCH(QString, theme);
    const auto restore = qScopeGuard([] { inspector::ui::applyTheme(inspector::ui::Theme::System); });
    choose(theme == "theme_2" ? "theme_1" : "theme_2");
    if (!dock.isEmpty()) m_fixture->trigger(dock);
    refused(field);
    auto *widget = m_fixture->find<QWidget>(shown);
    QTRY_VERIFY(widget->isVisible());
    choose(theme);
    m_fixture->window().view().setFocus(); // no cursor, no selection
    const QPalette themes = QApplication::palette();
    const bool isField = qobject_cast<QLineEdit *>(widget);
    const QColor plate = themes.color(isField ? QPalette::Base : QPalette::Window);
    const QImage picture = widget->grab().toImage();
    const QColor background = backgroundOf(picture);
    QCOMPARE(background.name(), plate.name());
    const double ofColours =
        support::contrastOf(widget->palette().color(isField ? QPalette::Text : QPalette::WindowText), background);
    QVERIFY2(ofColours >= 4.5, qPrintable(QString::number(ofColours)));
    const double ofPixels = contrastOfRedIn(picture, background);
    QVERIFY2(ofPixels >= 3.0, qPrintable(QString::number(ofPixels)));
}

// Below the field.
void TestWindowRefusals::reasonFollowsTheTheme() {
    const auto restore = qScopeGuard([] { inspector::ui::applyTheme(inspector::ui::Theme::System); });
    choose("theme_1");
    refused("gravity_box");
    const auto *note = m_fixture->find<QWidget>("gravity_box_note");
    QVERIFY(note->isVisible());
    choose("theme_2");
    const double contrast =
        support::contrastOf(note->palette().color(QPalette::WindowText), note->palette().color(QPalette::Window));
    QVERIFY2(!note->isVisible() || contrast >= 4.5, qPrintable(QString::number(contrast)));
}

void TestWindowRefusals::lostSettingsAreSaidAtTheChangeAndOnce() {
    const auto *messages = m_fixture->find<MessageBar>("messages");
    const QString file = m_fixture->settings().fileName();
    m_fixture->settings().sync();
    QVERIFY(QFile::remove(file) && QDir().mkdir(file));
    m_fixture->window().refresh();
    QCOMPARE(messages->line(), QString()); // nothing is lost yet
    m_fixture->key(Qt::Key_B);
    QTRY_VERIFY2(messages->line().contains("settings can't be written"), qPrintable(messages->line()));
    QVERIFY2(messages->line().contains(file), qPrintable(messages->line()));
    const uint64_t said = messages->count();
    click(m_fixture->find<QWidget>("dismiss"));
    m_fixture->key(Qt::Key_B);
    m_fixture->settings().sync();
    m_fixture->window().refresh();
    QCOMPARE(messages->count(), said);
}

// Neither the track nor what a fit has found, nor the names in the boxes.
void TestWindowRefusals::refusedTableTakesNothingAway() {
    const inspector::BoardParameters board{inspector::initialInputs().params, 9.81, {}, 0.0, {}};
    const QString good =
        write("track.csv", support::csvOf(support::makeTrack(m_fixture->session().registry(),
                                                             m_fixture->session().scene(), board, {.duration = 8.0})));
    m_fixture->drop(good);
    QVERIFY(m_fixture->session().track());
    auto *fit = m_fixture->find<QPushButton>("track_fit");
    click(fit);
    QTRY_COMPARE(fit->text(), QString("Fit"));
    const QString found = report();
    QVERIFY2(found.contains("verdict"), qPrintable(found));
    const auto track = m_fixture->session().track();
    m_fixture->drop(write("half.csv", "t,x\n0,1\n"));
    QCOMPARE(m_fixture->session().track(), track);
    QVERIFY2(report().startsWith(m_fixture->path("half.csv")), qPrintable(report()));
    QVERIFY2(report().endsWith(found), qPrintable(report()));
    QCOMPARE(m_fixture->find<QLineEdit>("track_file")->text(), good);
    QVERIFY(m_fixture->find<QPushButton>("track_take_over")->isEnabled());
    QVERIFY(m_fixture->find<QPushButton>("track_follow")->isEnabled());
}

void TestWindowRefusals::refusedUnitsTakeNothingAway() {
    QByteArray table = "t,x,y\n";
    for (int i = 0; i < 20; ++i) table += QByteArray::number(0.02 * i) + "," + QByteArray::number(0.001 * i) + ",0\n";
    m_fixture->drop(write("track.csv", table));
    const auto track = m_fixture->session().track();
    QVERIFY2(track, qPrintable(report()));
    const QLineEdit *units = refused("track_units");
    QVERIFY2(report().contains("'nonsense'"), qPrintable(report()));
    QCOMPARE(m_fixture->session().track(), track);
    QCOMPARE(units->text(), QString("nonsense")); // to be mended
}

// Another run is a recording, too, and replaces it: the dialog has asked.
void TestWindowRefusals::pictureDoesNotReplaceARecording() {
    const QByteArray recording = "physics-recording 1\n";
    const QString path = write("run.png", recording);
    m_fixture->press(Qt::Key_P, Qt::ControlModifier);
    m_fixture->answerFile(path);
    QCOMPARE(support::contentOf(path), recording);
    auto *refusal = m_fixture->find<QMessageBox>("nothing_saved");
    QVERIFY(refusal->text().startsWith("'" + path + "' is a recording"));
    refusal->activateWindow(); // as window managers do
    QTRY_COMPARE(QApplication::activeWindow(), refusal);
    click(refusal->button(QMessageBox::Ok));
    QTRY_VERIFY(!m_fixture->window().findChild<QMessageBox *>());
    const QString other = write("run.rec", recording);
    m_fixture->makeSteps(3);
    m_fixture->trigger("save_run");
    m_fixture->answerFile(other);
    QVERIFY(support::contentOf(other).size() > recording.size());
}

void TestWindowRefusals::endingOfAnotherKindIsRefused_data() {
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("expected");
    QTest::newRow("picture as a table") << "screenshot"
                                        << "a.csv"
                                        << ".png";
    QTest::newRow("picture as a recording") << "screenshot"
                                            << "a.rec"
                                            << ".png";
    QTest::newRow("run as a text") << "save_run"
                                   << "a.txt"
                                   << ".rec or .csv or .png";
    QTest::newRow("plot as a drawing") << "save_plot"
                                       << "a.svg"
                                       << ".png or .pdf or .csv";
    QTest::newRow("recording as a table") << "record"
                                          << "a.csv"
                                          << ".rec";
}

void TestWindowRefusals::endingOfAnotherKindIsRefused() {
    QFETCH(QString, command);
    QFETCH(QString, name);
    QFETCH(QString, expected);
    m_fixture->makeSteps(3);
    m_fixture->trigger(command);
    QTRY_VERIFY(m_fixture->window().findChild<QFileDialog *>());
    auto *dialog = m_fixture->window().findChild<QFileDialog *>();
    dialog->setDirectory(QFileInfo(m_fixture->path(name)).absolutePath());
    auto *line = dialog->findChild<QLineEdit *>("fileNameEdit");
    line->selectAll();
    QTest::keyClicks(line, name);
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_VERIFY(m_fixture->window().findChild<QMessageBox *>("nothing_saved"));
    QCOMPARE(m_fixture->find<QMessageBox>("nothing_saved")->text(),
             "expected a name that ends in " + expected + ", found '" + name + "'; nothing was saved");
    QVERIFY(!QFile::exists(m_fixture->path(name)));
}

QTEST_MAIN(TestWindowRefusals)
#include "tst_window_refusals.moc"
