// SPDX-License-Identifier: MIT
// The trade on the command line: arguments, table, files, recommendation, exit status.
#include "core/program/command_line.h"
#include "core/program/trade_command.h"
#include "core/trade/trade_svg.h"
#include "core/trade/trade_table.h"
#include "inspector/core/scenes.h"
#include "support/compare.h"
#include "support/files.h"

#include <QFile>
#include <QTemporaryDir>
#include <QXmlStreamReader>

using namespace inspector;
using support::contentOf;

class TestTradeCommand : public QObject {
    Q_OBJECT

private slots:
    void lengthsHaveAUnit_data();
    void lengthsHaveAUnit();
    void stepSizesReplaceTheUsualOnesOrJoinThem();
    void wrongUseIsOneLine_data();
    void wrongUseIsOneLine();
    void tradeNeedsNoWindow_data();
    void tradeNeedsNoWindow();
    void lastLineIsTheRecommendation();
    void progressFitsIntoALineAndIsErased();
    void progressIsShownFromTheStart();
    void unreachableToleranceGivesStatus1();
    void csvHeaderStaysAsItIs();
    void csvHasARowForEachPoint();
    void turnThatIsNotMeasuredIsNoFigure();
    void fileBesideTheTableTellsWhatWasMeasured();
    void svgIsWellFormedAndNamesEveryStepper();
    void otherPicturesAreLeftToTheirWriter();
    void whatCantBeOpenedGivesStatus2_data();
    void whatCantBeOpenedGivesStatus2();
    void unwritableFileIsToldBeforeAnythingIsMeasured();

private:
    QTemporaryDir m_folder;
};

namespace {

struct CommandResult {
    int status;
    QString out, messages;
    QString progress; // as the terminal gets it
    QString picture;  // asked of the writer
};

// A short measurement; times aren't tested.
CommandResult runOf(const QString &words) {
    const CommandLine line = parseCommandLine(("physics-inspector " + words).split(' '));
    if (line.exitStatus) return {*line.exitStatus, {}, line.error, {}, {}};
    CommandResult result{};
    QTextStream out(&result.out);
    QTextStream messages(&result.messages);
    QTextStream progress(&result.progress);
    result.status = runTrade(line.options, {out, messages, &progress},
                             [&](const ChartDescription &, const QString &path, QString *) {
                                 result.picture = path;
                                 return true;
                             });
    return result;
}

const QString kShort = QStringLiteral("--trade 1 --schedule random:3 --duration 0.5 --steps 0.05,0.01 --unknown none ");

} // namespace

void TestTradeCommand::lengthsHaveAUnit_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("radii"); // of a ball of 4 mm; 0: refused
    QTest::newRow("mm") << "1mm" << 0.25;
    QTest::newRow("m") << "0.002m" << 0.5;
    QTest::newRow("um") << "5e2um" << 0.125;
    QTest::newRow("R") << "0.1R" << 0.1;
    QTest::newRow("none") << "1" << 0.0;
    QTest::newRow("zero") << "0mm" << 0.0;
    QTest::newRow("negative") << "-1mm" << 0.0;
    QTest::newRow("unit only") << "mm" << 0.0;
    QTest::newRow("not finite") << "infR" << 0.0;
    QTest::newRow("nothing") << "" << 0.0;
}

void TestTradeCommand::lengthsHaveAUnit() {
    QFETCH(QString, text);
    QFETCH(double, radii);
    const std::optional<Length> length = parseLength(text);
    QCOMPARE(length.has_value(), radii > 0.0);
    if (length) COMPARE_WITHIN(length->inRadii(0.004), radii, 1e-15);
}

void TestTradeCommand::stepSizesReplaceTheUsualOnesOrJoinThem() {
    QVERIFY(parseStepSizes("0.02,1/60,4ms,3us,1s") == (std::vector<double>{0.02, 1.0 / 60.0, 4 * 1e-3, 3 * 1e-6, 1.0}));
    const std::vector<double> more = parseStepSizes("+0.02");
    QCOMPARE(more.size(), usualStepSizes().size() + 1);
    QVERIFY(more.back() == 0.02);
    for (const char *wrong : {"", "0", "1/0", "x", "0.01,", "20", "-1ms", "1e-9"})
        QVERIFY2(parseStepSizes(wrong).empty(), wrong);
}

void TestTradeCommand::wrongUseIsOneLine_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("line");
    const auto row = [](const char *words, const QString &line) { QTest::newRow(words) << words << line; };
    row("--under 1mm", "--under: needs --trade");
    row("--plot x.svg", "--plot: needs --trade");
    row("--trade 1 --under 1", "--under: expected a length above 0, as 1mm, 5um, 0.001m or 0.1R, found '1'");
    row("--trade 1 --steps 5,x", "--steps: expected step sizes from 1e-6 to 10 s, as 0.01,5ms,1/60, found '5,x'");
    row("--trade 1 --plot x.gif", "--plot: expected a file name ending in .svg, .pdf or .png, found 'x.gif'");
    row("--trade 1 --within 0", "--within: expected a number from 1 to 1e+12 ns, found '0'");
    row("--trade 1 --within 100 --under 1mm", "--within: takes neither --under nor --for");
    row("--trade 1 --stepper rk4", "--trade: doesn't go with --stepper");
    row("--share 0.5", "--share: needs --trade");
    row("--trade 1 --share 0", "--share: expected a number from 1e-06 to 1, found '0'");
    row("--trade 1 --unknown tilt", "--unknown: expected an amount above 0, as tilt=0.1deg; found nothing");
    row("--trade 99", QString("--trade: expected 1 to %1, found 99").arg(levelCount()));
}

void TestTradeCommand::wrongUseIsOneLine() {
    QFETCH(QString, words);
    QFETCH(QString, line);
    const CommandResult result = runOf(words);
    QCOMPARE(result.status, 2);
    QCOMPARE(result.messages, "physics-inspector: " + line + '\n');
}

void TestTradeCommand::tradeNeedsNoWindow_data() {
    QTest::addColumn<QByteArray>("word");
    QTest::newRow("apart") << QByteArray("--trade");
    QTest::newRow("joined") << QByteArray("--trade=3");
}

void TestTradeCommand::tradeNeedsNoWindow() {
    QFETCH(QByteArray, word);
    const QStringList words{"physics-inspector", QString::fromLatin1(word), "3"};
    QVERIFY(parseCommandLine(word.contains('=') ? words.mid(0, 2) : words).options.headless);
}

void TestTradeCommand::lastLineIsTheRecommendation() {
    const CommandResult result =
        runOf("--trade 1 --schedule random:3 --duration 0.5 --steps 0.05,0.01 --unknown tilt=0.1deg --under 10R");
    QVERIFY2(result.status == 0, qPrintable(result.messages));
    const QStringList lines = result.out.trimmed().split('\n');
    QVERIFY2(lines[2].startsWith("schedule random:3, 0.5 s: "), qPrintable(result.out));
    QVERIFY2(lines.last().startsWith("recommended: --stepper "), qPrintable(lines.last()));
    QVERIFY2(result.out.contains("  max error in all [R]  of unknown in 0.5 s [%]  "), qPrintable(result.out));
    QVERIFY2(lines[lines.size() - 2].startsWith("good enough for what is known: --stepper "), qPrintable(result.out));
    QVERIFY(result.messages.isEmpty());
}

void TestTradeCommand::progressFitsIntoALineAndIsErased() {
    const QStringList lines = runOf(kShort.trimmed()).progress.split("\r\x1b[K");
    QVERIFY(lines.size() > 4 * qsizetype(phys_registry_count(nullptr))); // errors and costs of each in two models
    QCOMPARE(lines.first(), QString());
    QCOMPARE(lines.last(), QString());
    for (const QString &line : lines) QVERIFY2(line.size() < 80 && !line.contains('\n'), qPrintable(line));
}

// Before the first stepper is measured.
void TestTradeCommand::progressIsShownFromTheStart() {
    const QStringList lines = runOf(kShort.trimmed()).progress.split("\r\x1b[K");
    QVERIFY2(lines[1].endsWith("schedules"), qPrintable(lines[1]));
    QVERIFY2(lines[2].endsWith("exact motion on random:3"), qPrintable(lines[2]));
    QCOMPARE(lines.filter("exact motion").size(), 2); // in each model
}

void TestTradeCommand::unreachableToleranceGivesStatus1() {
    const CommandResult result =
        runOf("--trade 1 --schedule random:3 --duration 0.5 --steps 0.01 --unknown none --within 0.002us");
    QCOMPARE(result.status, 1);
    QVERIFY2(result.out.endsWith("recommended: none: no step takes 2 ns or less\n"), qPrintable(result.out));
}

void TestTradeCommand::csvHeaderStaysAsItIs() {
    QCOMPARE(
        tradeCsvHeader(),
        QByteArray(
            "stepper,dt [s],model,position_largest [R],share_of_unknown [%],position_final [R],velocity_largest [m/s],"
            "orientation_largest [deg],energy_drift [J/kg],penetration_largest [R],time_until_wrong [s],"
            "wrong_impacts,model_error [R],steps,cpu_per_step [ns],cpu_per_second [us],cpu_spread [%],"
            "repeats,note\n"));
}

void TestTradeCommand::csvHasARowForEachPoint() {
    const QString path = m_folder.filePath("trade.csv");
    const CommandResult result = runOf(kShort + "--csv " + path);
    QVERIFY2(result.messages.isEmpty(), qPrintable(result.messages));
    QByteArrayList lines = contentOf(path).trimmed().split('\n');
    QCOMPARE(lines.size(), 1 + qsizetype(phys_registry_count(nullptr)) * 2 * 2); // steps, models
    QVERIFY2(lines[1].startsWith("explicit-euler,0.05,rolling,"), lines[1].constData());
    for (const QByteArray &line : lines) QVERIFY(line.contains('"') || line.count(',') == lines[0].count(','));
}

void TestTradeCommand::turnThatIsNotMeasuredIsNoFigure() {
    const QString path = m_folder.filePath("turn.csv");
    const auto figures = [&](const QString &more) { // of explicit-euler, in the table and in the file
        const QStringList lines = runOf(kShort + more + "--csv " + path).out.split('\n');
        const auto isHeader = [](const QString &line) { return line.startsWith("stepper "); };
        const auto header = std::find_if(lines.begin(), lines.end(), isHeader);
        const qsizetype end = header->indexOf("turn [deg]") + qsizetype(strlen("turn [deg]"));
        const QByteArrayList rows = contentOf(path).split('\n');
        const qsizetype column = rows[0].split(',').indexOf("orientation_largest [deg]");
        return QStringList{header[1].left(end).section(' ', -1), QString::fromUtf8(rows[1].split(',')[column])};
    };
    QCOMPARE(figures(QString()), (QStringList{"–", ""}));
    for (const QString &figure : figures("--with-orientation ")) QVERIFY2(figure.toDouble() > 0.0, qPrintable(figure));
}

void TestTradeCommand::fileBesideTheTableTellsWhatWasMeasured() {
    const QString path = m_folder.filePath("told.csv");
    QCOMPARE(runOf(kShort + "--gravity 9.8 --csv " + path).messages, QString());
    const QByteArray settings = contentOf(path + ".txt");
    QVERIFY2(settings.startsWith("physics-inspector "), settings.constData());
    for (const char *line : {"\nlevel 01\n", "\nschedule random:3, 0.5 s\n", "\nsteps 0.05 0.01 s\n",
                             "\nunknown none\n", "\nshare 0.25\n", "\nhorizon 0.5 s\n", "\ngravity 9.8 m/s^2\n"})
        QVERIFY2(settings.contains(line), settings.constData());
}

void TestTradeCommand::svgIsWellFormedAndNamesEveryStepper() {
    const QString path = m_folder.filePath("trade.svg");
    const CommandResult result = runOf(kShort + "--plot " + path);
    QVERIFY2(result.messages.isEmpty(), qPrintable(result.messages));
    QXmlStreamReader xml(contentOf(path));
    QStringList texts;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::Characters) texts += xml.text().toString();
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    for (uint32_t i = 0; i < phys_registry_count(nullptr); ++i) {
        phys_stepper_info info;
        phys_registry_info(nullptr, i, &info);
        QVERIFY2(texts.contains(QString(info.id)), info.id);
    }
}

void TestTradeCommand::otherPicturesAreLeftToTheirWriter() {
    QCOMPARE(runOf(kShort + "--plot a.pdf").picture, QString("a.pdf"));
}

void TestTradeCommand::whatCantBeOpenedGivesStatus2_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("part");
    QFile empty(m_folder.filePath("empty.txt"));
    QVERIFY(empty.open(QIODevice::WriteOnly));
    empty.write("physics-maze 1\nunits m\nball 0.006\nstart 0 0 0.006\n");
    QTest::newRow("no option") << "--trade " + empty.fileName()
                               << "physics-inspector: --trade: the ball leaves the maze";
    QTest::newRow("level") << "--trade nowhere/none.txt"
                           << "nowhere/none.txt";
    QTest::newRow("schedule") << "--trade 1 --schedule nowhere/none.txt"
                              << "--schedule: 'nowhere/none.txt': No such file";
    QTest::newRow("seed") << "--trade 1 --schedule random:x"
                          << "expected random: and a whole number, found 'random:x'";
}

void TestTradeCommand::whatCantBeOpenedGivesStatus2() {
    QFETCH(QString, words);
    QFETCH(QString, part);
    const CommandResult result = runOf(words);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.messages.contains(part) && result.messages.count('\n') == 1, qPrintable(result.messages));
    QVERIFY(result.out.isEmpty());
}

void TestTradeCommand::unwritableFileIsToldBeforeAnythingIsMeasured() {
    const CommandResult result = runOf(kShort + "--csv /nowhere/trade.csv");
    QCOMPARE(result.status, 2);
    QVERIFY2(result.messages.startsWith("physics-inspector: --csv: '/nowhere/trade.csv': No such file"),
             qPrintable(result.messages));
}

QTEST_GUILESS_MAIN(TestTradeCommand)
#include "tst_trade_command.moc"
