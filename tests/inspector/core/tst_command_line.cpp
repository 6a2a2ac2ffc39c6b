// SPDX-License-Identifier: MIT
// From words to options, and what is said of words that mean nothing.
#include "core/program/command_line.h"

#include <QTest>

using namespace inspector;

class TestCommandLine : public QObject {
    Q_OBJECT

private slots:
    void defaultsAreThoseOfTheHelp();
    void optionsAreRead();
    void durationsAreReadAsInTheWindow();
    void everyParameterRowIsAnOptionInBothSpellings();
    void choicesAreReadByNameAndNumber();
    void stepperOwnParametersAreOptions();
    void helpNamesEveryOptionWithItsUnit();
    void listsNameEverySteppersAndParametersId();
    void versionIsThatOfProgramAndLibrary();
    void wrongUseGivesOneLineAndStatus2_data();
    void wrongUseGivesOneLineAndStatus2();
    void windowIsNeededUnlessTheArgumentsSayOtherwise();
};

namespace {

CommandLine parsed(const QStringList &words) { return parseCommandLine(QStringList("physics-inspector") + words); }

} // namespace

void TestCommandLine::defaultsAreThoseOfTheHelp() {
    const CommandLine line = parsed({});
    QVERIFY2(!line.exitStatus, qPrintable(line.error));
    const Options &options = line.options;
    QCOMPARE(options.level.name, QString("01"));
    QCOMPARE(options.levels.size(), size_t(10));
    QCOMPARE(options.stepper, QByteArray("symplectic-euler"));
    QCOMPARE(options.dt, 0.01);
    QCOMPARE(options.speed, 1.0);
    QCOMPARE(options.csvEvery, uint64_t(1));
    QVERIFY(!options.headless && !options.autopilot && !options.duration);
    QVERIFY(options.settings.empty() && options.csv.isEmpty() && options.grab.isEmpty());
}

void TestCommandLine::optionsAreRead() {
    const CommandLine line = parsed({"--level", "7", "--stepper=rk4", "--dt", "0.002", "--speed", "4", "--headless",
                                     "--autopilot", "--duration", "12.5", "--csv", "run.csv", "--csv-every", "10"});
    QVERIFY2(!line.exitStatus, qPrintable(line.error));
    const Options &options = line.options;
    QCOMPARE(options.level.name, QString("07"));
    QCOMPARE(options.stepper, QByteArray("rk4"));
    QCOMPARE(options.dt, 0.002);
    QCOMPARE(options.speed, 4.0);
    QCOMPARE(options.duration, 12.5);
    QCOMPARE(options.csv, QString("run.csv"));
    QCOMPARE(options.csvEvery, uint64_t(10));
    QVERIFY(options.headless && options.autopilot);
}

void TestCommandLine::durationsAreReadAsInTheWindow() {
    QCOMPARE(parsed({"--dt", "5 us"}).options.dt, 5e-6);
    QCOMPARE(parsed({"--dt", "1/60"}).options.dt, 1.0 / 60.0);
    QCOMPARE(parsed({"--dt", "0,01"}).options.dt, 0.01);
    QCOMPARE(parsed({"--duration", "2 min"}).options.duration, 120.0);
    QCOMPARE(parsed({"--trade", "1", "--for", "500ms"}).options.trade.seconds, 0.5);
}

void TestCommandLine::everyParameterRowIsAnOptionInBothSpellings() {
    const Parameters parameters;
    for (int i = 0; i < parameters.count(); ++i) {
        const QString id = QString::fromUtf8(parameters.row(i).id);
        const QString value = QString::number(parameters.row(i).min);
        for (const QString &name : {id, QString(id).replace('_', '-')}) {
            for (const QStringList &words : {QStringList{"--" + name, value}, QStringList{"--" + name + "=" + value}}) {
                const CommandLine line = parsed(words);
                QVERIFY2(!line.exitStatus, qPrintable(line.error));
                QCOMPARE(line.options.settings.size(), size_t(1));
                QCOMPARE(line.options.settings[0].id, id);
                QCOMPARE(line.options.settings[0].value, parameters.row(i).min);
            }
        }
    }
}

void TestCommandLine::choicesAreReadByNameAndNumber() {
    for (const char *word : {"rigid", "Rigid", "1"}) {
        const CommandLine line = parsed({"--model", word});
        QVERIFY2(!line.exitStatus, qPrintable(line.error));
        QCOMPARE(line.options.settings[0].value, double(PHYS_MODEL_RIGID));
    }
}

void TestCommandLine::stepperOwnParametersAreOptions() {
    phys_stepper_info info;
    QCOMPARE(phys_registry_find(nullptr, "symplectic-euler", &info, nullptr), PHYS_OK);
    for (uint32_t i = 0; i < info.row_count; ++i) {
        const QString option = QString("--%1").arg(info.rows[i]->id);
        const CommandLine line = parsed({option, QString::number(info.rows[i]->max)});
        QVERIFY2(!line.exitStatus, qPrintable(line.error));
        QCOMPARE(line.options.settings[0].value, info.rows[i]->max);
    }
}

void TestCommandLine::helpNamesEveryOptionWithItsUnit() {
    const CommandLine line = parsed({"--help"});
    QCOMPARE(line.exitStatus, 0);
    const Parameters parameters;
    for (int i = 0; i < parameters.count(); ++i) {
        const phys_param_row &row = parameters.row(i);
        const QString option = QString("--%1 <").arg(QString(row.id).replace('_', '-'));
        QVERIFY2(line.output.contains(option + (row.unit[0] ? QString(row.unit) + ">" : QString())), row.id);
    }
    for (const char *option :
         {"--level", "--stepper", "--dt <s>", "--speed", "--headless", "--autopilot", "--duration <s>", "--csv",
          "--compare <id>", "--compare-substeps", "--grab", "--all-levels", "--list-steppers"})
        QVERIFY2(line.output.contains(option), option);
}

void TestCommandLine::listsNameEverySteppersAndParametersId() {
    const CommandLine steppers = parsed({"--list-steppers"});
    QCOMPARE(steppers.exitStatus, 0);
    for (uint32_t i = 0; i < phys_registry_count(nullptr); ++i) {
        phys_stepper_info info;
        phys_registry_info(nullptr, i, &info);
        QVERIFY2(steppers.output.contains(QString("%1 ").arg(info.id)), info.id);
    }
    const CommandLine list = parsed({"--list-parameters"});
    QCOMPARE(list.exitStatus, 0);
    const Parameters parameters;
    for (int i = 0; i < parameters.count(); ++i) QVERIFY(list.output.contains(QString(parameters.row(i).id) + " "));
}

void TestCommandLine::versionIsThatOfProgramAndLibrary() {
    const CommandLine line = parsed({"--version"});
    QCOMPARE(line.exitStatus, 0);
    QCOMPARE(line.output, QString("physics-inspector 1.1.0, libphysics %1\n").arg(phys_version()));
}

void TestCommandLine::wrongUseGivesOneLineAndStatus2_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("said"); // what the line must contain: the option and what was found
    QTest::newRow("unknown opponent") << "--compare none"
                                      << "--compare: no stepper has the id 'none'";
    QTest::newRow("substeps of nothing") << "--compare-substeps 2"
                                         << "--compare-substeps: needs --compare";
    QTest::newRow("no whole number of substeps") << "--compare exact --compare-substeps 1.5"
                                                 << "'1.5'";
    QTest::newRow("too many substeps") << "--compare exact --compare-substeps 1001"
                                       << "from 1 to 1000, found '1001'";
    QTest::newRow("comparison of a replay") << "--replay x --check --compare exact"
                                            << "--replay in the window only";
    QTest::newRow("comparison of all levels") << "--all-levels --compare exact"
                                              << "doesn't go with --all-levels";
    QTest::newRow("comparison of a trade") << "--trade 1 --compare exact"
                                           << "doesn't go with --trade";
    QTest::newRow("unknown option") << "--colour"
                                    << "colour";
    QTest::newRow("stray word") << "maze.txt"
                                << "'maze.txt'";
    QTest::newRow("value missing") << "--dt"
                                   << "dt";
    QTest::newRow("value where none belongs") << "--headless=yes"
                                              << "headless";
    QTest::newRow("level not in the list") << "--level 11"
                                           << "--level: expected 1 to 10, found 11";
    QTest::newRow("unknown stepper") << "--stepper magic"
                                     << "magic";
    QTest::newRow("plugin missing") << "--plugin nowhere/none.so"
                                    << "nowhere/none.so";
    QTest::newRow("plugin that is none") << "--plugin=" LEVELS_FOLDER "/01.txt"
                                         << "01.txt";
    QTest::newRow("dt zero") << "--dt 0"
                             << "--dt: expected a duration from 1e-06 s to 10 s (as 5 ms or 1/60), found '0'";
    QTest::newRow("dt not a number") << "--dt nan"
                                     << "'nan'";
    QTest::newRow("dt in metres") << "--dt 5m"
                                  << "'5m', whose unit isn't one of: ns us ms s min";
    QTest::newRow("every half step") << "--csv-every 2.5"
                                     << "--csv-every: expected a whole number from 1 to 1e+09, found '2.5'";
    QTest::newRow("speed too high") << "--speed 17"
                                    << "--speed: expected a number from 0.0625 to 16, found '17'";
    QTest::newRow("duration negative") << "--duration -1"
                                       << "--duration";
    QTest::newRow("csv-every zero") << "--csv-every 0"
                                    << "--csv-every";
    QTest::newRow("parameter no number") << "--tilt-x steep"
                                         << "--tilt-x: expected a number from -80 to 80 deg, found 'steep'";
    QTest::newRow("parameter out of range") << "--restitution-wall 1.5"
                                            << "--restitution-wall: expected a number from 0 to 1, found '1.5'";
    QTest::newRow("parameter infinite") << "--rolling-friction inf"
                                        << "--rolling-friction";
    QTest::newRow("choice unknown") << "--model square"
                                    << "--model: expected rolling or rigid, found 'square'";
    QTest::newRow("parameters at odds") << "--model rigid --rolling-friction 0.5"
                                        << "rolling_friction";
    QTest::newRow("picture without window") << "--headless --grab a.png"
                                            << "--grab";
    QTest::newRow("shaders without window") << "--headless --shaders ."
                                            << "--shaders: nothing is drawn";
    QTest::newRow("no folder of shaders") << "--shaders /nowhere"
                                          << "--shaders: expected a folder, found '/nowhere'";
    QTest::newRow("one level and all") << "--all-levels --level 2"
                                       << "--all-levels";
}

void TestCommandLine::wrongUseGivesOneLineAndStatus2() {
    QFETCH(QString, words);
    QFETCH(QString, said);
    const CommandLine line = parsed(words.split(' '));
    QCOMPARE(line.exitStatus, 2);
    QVERIFY(line.output.isEmpty());
    QVERIFY2(line.error.startsWith("physics-inspector: ") && line.error.contains(said), qPrintable(line.error));
    QCOMPARE(line.error.count('\n'), 1);
}

void TestCommandLine::windowIsNeededUnlessTheArgumentsSayOtherwise() {
    const auto windowless = [](std::initializer_list<const char *> words) {
        std::vector<const char *> argv{"physics-inspector"};
        argv.insert(argv.end(), words);
        return isWindowless(int(argv.size()), argv.data());
    };
    QVERIFY(!windowless({}));
    QVERIFY(!windowless({"--autopilot", "--level", "3"}));
    QVERIFY(!windowless({"--replay", "r", "--grab", "p.png"}));
    QVERIFY(windowless({"--replay", "r", "--check"}));
    for (const char *word : {"--headless", "--all-levels", "--all_levels", "--list-steppers", "--help", "--version"})
        QVERIFY2(windowless({"--level", "3", word}), word);
}

QTEST_GUILESS_MAIN(TestCommandLine)
#include "tst_command_line.moc"
