// SPDX-License-Identifier: MIT
// From arguments to options, and the messages for invalid arguments.
#include "core/program/command_line.h"
#include "core/recording/recording.h"
#include "core/setup/files.h"
#include "inspector/core/scenes.h"

#include <physics/plugin.h>

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
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
    void noRowOfAPluginCanHideAnOption();
    void listsNameEverySteppersAndParametersId();
    void versionIsThatOfProgramAndLibrary();
    void wrongUseGivesOneLineAndStatus2_data();
    void wrongUseGivesOneLineAndStatus2();
    void wrongComparisonGivesOneLineAndStatus2_data();
    void wrongComparisonGivesOneLineAndStatus2();
    void tiltOfAFileIsRefusedWhereTheAutopilotTilts();
    void wrongLineOfAFileOfParametersNamesTheFile_data();
    void wrongLineOfAFileOfParametersNamesTheFile();
    void checkOfARecordingNeedsNoLevels();
    void windowIsNeededUnlessTheArgumentsSayOtherwise();
    void aFileAloneIsALevelOrARecording();
    void aTableAloneIsLaidOverTheLevel();
    void listsAskedForTogetherArePrintedTogether();
    void outputsThatWouldDestroyAFileAreRefused_data();
    void outputsThatWouldDestroyAFileAreRefused();
    void wrongWordsAreQuotedInOneLine();
};

namespace {

CommandLine parsed(const QStringList &words) { return parseCommandLine(QStringList("physics-inspector") + words); }

void put(const QString &path, const QByteArray &bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

// A recording of one step, which no stepper would make.
QByteArray recordingIn(const QString &maze) {
    const Registry registry = makeRegistry(nullptr);
    phys_stepper_info stepper;
    phys_registry_find(registry.get(), PHYS_STEPPER_DEFAULT, &stepper, nullptr);
    Segment segment;
    segment.conditions.maze = {maze, hashOf(readFile(maze, kLargestMaze, nullptr).value())};
    segment.conditions.stepper = {stepper.id, stepper.version};
    segment.conditions.dt = 0.01;
    segment.hashes = {0};
    segment.from.emplace();
    phys_scene_start(loadScene(maze, nullptr).get(), &*segment.from);
    return recordingText({{}, {}, {}, {segment}, true}, registry);
}

} // namespace

void TestCommandLine::defaultsAreThoseOfTheHelp() {
    const CommandLine line = parsed({});
    QVERIFY2(!line.exitStatus, qPrintable(line.error));
    const Options &options = line.options;
    QCOMPARE(options.level.name, QString("01"));
    QCOMPARE(options.levels.size(), size_t(levelCount()));
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
    QCOMPARE(parsed({"--restitution-wall", "50%"}).options.settings.at(0).value, 0.5);
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
    QVERIFY(line.output.simplified().contains("beside it into FILE.txt the settings")); // which --csv also writes
}

// Rows become options with their ids; all other option names are reserved.
void TestCommandLine::noRowOfAPluginCanHideAnOption() {
    QStringList taken{PHYS_RESERVED_ROW_IDS};
    uint32_t count = 0;
    for (const phys_param_row *row = phys_param_rows(&count); count-- > 0; ++row) taken += row->id;
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(nullptr, i, &info) == PHYS_OK; ++i)
        for (uint32_t j = 0; j < info.row_count; ++j) taken += info.rows[j]->id;
    static const QRegularExpression option("--([a-z][a-z-]+)");
    for (const QString &line : parsed({"--help"}).output.split('\n')) {
        if (!line.startsWith("  -")) continue;
        const QString id = option.match(line).captured(1).replace('-', '_');
        QVERIFY2(taken.contains(id), qPrintable("PHYS_RESERVED_ROW_IDS of physics/plugin.h lacks " + id));
    }
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
    QTest::addColumn<QString>("said"); // what the line must contain: the option and the value found
    QTest::newRow("view of no window") << "--headless --view 2d"
                                       << "--view: nothing is drawn without a window";
    QTest::newRow("no such view") << "--view 4d"
                                  << "--view: expected 3d or 2d, found '4d'";
    QTest::newRow("no file of parameters") << "--parameters /nowhere"
                                           << "--parameters: '/nowhere'";
    QTest::newRow("angle that is a length") << "--track t.csv --track-frame 0,0,1mm,1"
                                            << "--track-frame: expected";
    QTest::newRow("tilt beside the autopilot's") << "--autopilot --tilt-x 3"
                                                 << "--tilt-x: doesn't go with --autopilot";
    QTest::newRow("tilt of all levels") << "--all-levels --tilt-y 3"
                                        << "--tilt-y: doesn't go with --all-levels";
    for (const char *option : {"--tilt-x 3", "--tilt-y 3", "--speed 2", "--view 2d"}) {
        QTest::addRow("trade %s", option) << QStringLiteral("--trade 1 %1").arg(option) << "doesn't go with --";
        QTest::addRow("fit %s", option) << QStringLiteral("--fit t.csv --level 1 %1").arg(option)
                                        << "doesn't go with --";
    }
    QTest::newRow("unknown option") << "--colour"
                                    << "colour";
    QTest::newRow("two files") << "a.txt b.txt"
                               << "expected one file, found 'a.txt' and 'b.txt'";
    QTest::newRow("a file and a level") << "a.txt --level 2"
                                        << "--level: doesn't go with the file 'a.txt'";
    QTest::newRow("value missing") << "--dt"
                                   << "dt";
    QTest::newRow("value where none belongs") << "--headless=yes"
                                              << "headless";
    QTest::newRow("level not in the list") << "--level 9999"
                                           << "--level: expected 1 to ";
    QTest::newRow("level neither a number nor a file")
        << "--level 1.0"
        << "--level: expected the number of a level or a maze's file, found '1.0'";
    QTest::newRow("no level") << "--level="
                              << "--level: expected the number of a level or a maze's file, found nothing";
    QTest::newRow("trade of no level") << "--trade nowhere/none.txt"
                                       << "--trade: expected the number of a level or a maze's file, found 'nowhere";
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
    QTest::newRow("every half step") << "--headless --csv-every 2.5"
                                     << "--csv-every: expected a whole number from 1 to 1e+09, found '2.5'";
    QTest::newRow("speed too high") << "--speed 17"
                                    << "--speed: expected a number from 0.0625 to 16, found '17'";
    QTest::newRow("duration negative") << "--duration -1"
                                       << "--duration";
    QTest::newRow("csv-every zero") << "--headless --csv-every 0"
                                    << "--csv-every";
    QTest::newRow("parameter no number") << "--tilt-x steep"
                                         << "--tilt-x: expected a number from -80 to 80 \u00b0, found 'steep'";
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
    QTest::newRow("track without window") << "--headless --track t.csv"
                                          << "--track: is shown in the window";
    QTest::newRow("no such track") << "--track /nowhere/t.csv"
                                   << "--track: '/nowhere/t.csv'";
    QTest::newRow("level for a track") << LEVELS_FOLDER "/01.txt --track t.csv"
                                       << "--track: 't.csv'";
    QTest::newRow("two tracks") << "a.csv --track b.csv"
                                << "--track: doesn't go with the file 'a.csv'";
    QTest::newRow("units of no track") << "--track-units x=mm"
                                       << "--track-units: needs --fit or --track";
    QTest::newRow("two levels, spelt in two ways") << "--level=1 --level 2"
                                                   << "--level: given twice, '1' and '2'";
    QTest::newRow("a parameter twice") << "--rolling_friction 0.1 --rolling-friction=0.2"
                                       << "--rolling-friction: given twice, '0.1' and '0.2'";
    QTest::newRow("table as a picture") << "--headless --csv tab.png"
                                        << "--csv: expected a file name ending in .csv, found 'tab.png'";
    QTest::newRow("one level and all") << "--all-levels --level 2"
                                       << "--all-levels: doesn't go with --level";
    QTest::newRow("rows of a check") << "--replay x --check --csv-every 10"
                                     << "--csv-every: no table is written without --csv";
    QTest::newRow("rows of a window") << "--csv-every 10"
                                      << "--csv-every: no table is written without --csv";
    QTest::newRow("rows of all levels") << "--all-levels --csv-every 10"
                                        << "--all-levels: doesn't go with --csv-every";
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

void TestCommandLine::wrongComparisonGivesOneLineAndStatus2_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("said");
    QTest::newRow("unknown ghostChoice") << "--compare none"
                                         << "--compare: no stepper has the id 'none'";
    QTest::newRow("substeps of nothing") << "--compare-substeps 2"
                                         << "--compare-substeps: needs --compare";
    QTest::newRow("parameters of nothing") << "--compare-set gravity=3"
                                           << "--compare-set: needs --compare";
    QTest::newRow("ghost's tilt") << "--compare exact --compare-set tilt_x=3"
                                  << "--compare-set: expected parameters other than the tilt, as "
                                     "rolling_friction=0.004, found 'tilt_x=3'";
    QTest::newRow("ghost's unknown parameter") << "--compare exact --compare-set speed=3"
                                               << "--compare-set: expected parameters other than the tilt, as "
                                                  "rolling_friction=0.004, found 'speed=3'";
    QTest::newRow("ghost's forbidden value")
        << "--compare exact --compare-set restitution_wall=2"
        << "--compare-set: restitution_wall: expected a number from 0 to 1, found '2'";
    QTest::newRow("ghost's parameter twice")
        << "--compare exact --compare-set restitution_wall=0.1,restitution-wall=0.9"
        << "--compare-set: 'restitution_wall' is named twice";
    QTest::newRow("ghost's values that don't agree")
        << "--compare exact --compare-set model=rigid,rolling_friction=1,sliding_friction=0.5"
        << "--compare-set: rolling_friction is 1";
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
}

void TestCommandLine::wrongComparisonGivesOneLineAndStatus2() { wrongUseGivesOneLineAndStatus2(); }

// Here a file's tilt isn't used either.
void TestCommandLine::tiltOfAFileIsRefusedWhereTheAutopilotTilts() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("leaning.txt");
    put(file, "physics-parameters 1\nname leaning\nset tilt_x 3\n");
    QVERIFY(!parsed({"--parameters", file}).exitStatus);
    QCOMPARE(parsed({"--parameters", file, "--autopilot"}).error,
             QString("physics-inspector: --tilt-x: doesn't go with --autopilot\n"));
}

void TestCommandLine::wrongLineOfAFileOfParametersNamesTheFile_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("said");
    QTest::newRow("id") << QByteArray("set speed 1") << "': expected the id of a parameter, found 'speed'";
    QTest::newRow("value") << QByteArray("set gravity -1") << "': gravity is -1 m/s^2; allowed is ";
    QTest::newRow("number") << QByteArray("set gravity x") << ":3: expected a number, found 'x'";
}

void TestCommandLine::wrongLineOfAFileOfParametersNamesTheFile() {
    QFETCH(QByteArray, text);
    QFETCH(QString, said);
    const QTemporaryDir folder;
    const QString file = folder.filePath("wrong.txt");
    put(file, "physics-parameters 1\nname wrong\n" + text + "\n");
    const QString error = parsed({"--parameters", file}).error;
    QVERIFY2(error.startsWith("physics-inspector: --parameters: ") && error.contains("wrong.txt" + said),
             qPrintable(error));
}

// A recording names its mazes, which may lie beside it.
void TestCommandLine::checkOfARecordingNeedsNoLevels() {
    const QTemporaryDir folder;
    const QByteArray levels = qgetenv("PHYSICS_LEVELS");
    qputenv("PHYSICS_LEVELS", QFile::encodeName(folder.filePath("none")));
    const CommandLine check = parsed({"--replay", "a.rec", "--check"});
    const CommandLine window = parsed({"--replay", "a.rec"});
    qputenv("PHYSICS_LEVELS", levels);
    QVERIFY2(!check.exitStatus, qPrintable(check.error));
    QCOMPARE(window.error, QString("physics-inspector: --replay: no levels found in the folder '%1' (PHYSICS_LEVELS "
                                   "names another)\n")
                               .arg(folder.filePath("none")));
}

void TestCommandLine::windowIsNeededUnlessTheArgumentsSayOtherwise() {
    QVERIFY(!parsed({}).options.headless);
    QVERIFY(!parsed({"--autopilot", "--level", "3"}).options.headless);
    QVERIFY(!parsed({"--replay", "r", "--grab", "p.png"}).options.headless);
    QVERIFY(parsed({"--replay", "r", "--check"}).options.headless);
    for (const char *word : {"--headless", "--all-levels", "--all_levels"})
        QVERIFY2(parsed({word}).options.headless, word);
}

void TestCommandLine::aFileAloneIsALevelOrARecording() {
    const QTemporaryDir folder;
    const QString recording = folder.filePath("run.rec");
    put(recording, "physics-recording 1\n");
    QCOMPARE(parsed({recording}).options.replay, recording);
    QVERIFY(parsed({recording}).options.action == Options::Action::Replay);
    const CommandLine level = parsed({"--dt", "5ms", LEVELS_FOLDER "/03.txt"});
    QVERIFY2(!level.exitStatus, qPrintable(level.error));
    QCOMPARE(level.options.level.name, QString("03"));
    QVERIFY(level.options.level.mesh.endsWith("03.obj"));
}

void TestCommandLine::aTableAloneIsLaidOverTheLevel() {
    const QTemporaryDir folder;
    const QString table = folder.filePath("video.csv");
    QByteArray rows = "t_ms,x_mm,y_mm\n";
    for (int i = 0; i < 10; ++i) rows += QByteArray::number(i) + ",0,0\n";
    put(table, rows);
    const CommandLine alone = parsed({table, "--level", "2", "--track-frame", "0.5cm,0,90 deg,1"});
    QVERIFY2(!alone.exitStatus, qPrintable(alone.error));
    QVERIFY(alone.options.action == Options::Action::Run);
    QVERIFY(!alone.options.headless);
    QCOMPARE(alone.options.fit.track, table);
    QCOMPARE(alone.options.fit.frame.x, 5e-3);
    QCOMPARE(alone.options.level.name, QString("02"));
    QCOMPARE(parsed({"--track", table, "--track-units", "px=0.2mm"}).options.fit.unitWords, QString("px=0.2mm"));
}

void TestCommandLine::listsAskedForTogetherArePrintedTogether() {
    const CommandLine both = parsed({"--list-steppers", "--list-parameters"});
    QCOMPARE(both.output, parsed({"--list-steppers"}).output + parsed({"--list-parameters"}).output);
}

void TestCommandLine::outputsThatWouldDestroyAFileAreRefused_data() {
    QTest::addColumn<QString>("words"); // FOLDER/level.txt, .obj, run.rec, a.set, table.csv and note.txt are there
    QTest::addColumn<QString>("said");  // empty: not refused
    const QString force = "--force ";
    QTest::newRow("table onto the level") << "--level FOLDER/level.txt --csv FOLDER/level.txt"
                                          << "--csv: 'FOLDER/level.txt' is read by this run";
    QTest::newRow("by another name") << "--level FOLDER/level.txt --csv FOLDER/../NAME/level.txt"
                                     << "is read by this run";
    QTest::newRow("even if forced") << force + "--level FOLDER/level.txt --record FOLDER/level.txt"
                                    << "--record: 'FOLDER/level.txt' is read by this run";
    QTest::newRow("onto the mesh") << force + "--level FOLDER/level.txt --csv FOLDER/level.obj"
                                   << "is read by this run";
    QTest::newRow("onto the replay") << force + "--headless --replay FOLDER/run.rec --csv FOLDER/run.rec"
                                     << "--csv: 'FOLDER/run.rec' is read by this run";
    QTest::newRow("onto the replay's maze") << force + "--headless --replay FOLDER/run.rec --csv FOLDER/level.txt"
                                            << "--csv: 'FOLDER/level.txt' is read by this run";
    QTest::newRow("onto the schedule") << "--trade 1 --schedule FOLDER/table.csv --csv FOLDER/table.csv"
                                       << "is read by this run";
    QTest::newRow("onto the parameters") << force + "--parameters FOLDER/a.set --csv FOLDER/a.set"
                                         << "--csv: 'FOLDER/a.set' is read by this run";
    QTest::newRow("onto another level") << force + "--record " LEVELS_FOLDER "/02.txt"
                                        << "is read by this run";
    QTest::newRow("onto a shader") << force + "--shaders FOLDER --grab FOLDER/note.png"
                                   << "--grab: 'FOLDER/note.png' is read by this run";
    QTest::newRow("two outputs, new") << "--csv FOLDER/new --record FOLDER/new"
                                      << "--record: 'FOLDER/new' is written by this run already";
    QTest::newRow("two outputs, there") << "--csv FOLDER/table.csv --record FOLDER/table.csv"
                                        << "--record: 'FOLDER/table.csv' is written by this run already";
    QTest::newRow("recording onto a recording") << "--record FOLDER/run.rec"
                                                << "--record: 'FOLDER/run.rec': there is a file of this name already";
    QTest::newRow("that, forced") << force + "--record FOLDER/run.rec"
                                  << "";
    QTest::newRow("table onto a note") << "--csv FOLDER/note.txt"
                                       << "--force replaces it";
    QTest::newRow("table onto a table") << "--csv FOLDER/table.csv"
                                        << "";
    QTest::newRow("table onto a measured track") << "--csv FOLDER/track.csv"
                                                 << "--force replaces it";
    QTest::newRow("settings of a table onto a note") << "--csv FOLDER/mine.csv"
                                                     << "--csv: 'FOLDER/mine.csv.txt': there is a file of this name";
    QTest::newRow("trade's table onto one of steps") << "--trade 1 --csv FOLDER/table.csv"
                                                     << "--force replaces it";
    QTest::newRow("picture onto a note") << "--grab FOLDER/note.png"
                                         << "--force replaces it";
    QTest::newRow("picture of another kind") << "--grab FOLDER/new.jpg"
                                             << "--grab: expected a file name ending in .png, found 'FOLDER/new.jpg'";
    QTest::newRow("no such folder") << "--csv FOLDER/none/t.csv"
                                    << "--csv: 'FOLDER/none/t.csv': No such file or directory";
    QTest::newRow("recording to nowhere") << "--record FOLDER/none/r"
                                          << "--record: 'FOLDER/none/r': No such file or directory";
    QTest::newRow("chart in no folder") << "--trade 1 --plot FOLDER/none/c.svg"
                                        << "--plot: 'FOLDER/none/c.svg': No such file or directory";
    QTest::newRow("a folder") << "--csv FOLDER"
                              << "Is a directory";
    QTest::newRow("to standard output") << "--csv -"
                                        << "";
    QTest::newRow("a device twice") << "--csv /dev/null --record /dev/null"
                                    << "";
}

void TestCommandLine::outputsThatWouldDestroyAFileAreRefused() {
    QFETCH(QString, words);
    QFETCH(QString, said);
    const QTemporaryDir folder;
    const QString path = folder.path();
    const QString level = path + "/level.txt";
    QVERIFY(QFile::copy(LEVELS_FOLDER "/01.txt", level));
    put(path + "/level.obj", "v 0 0 0\n");
    put(path + "/run.rec", recordingIn(level));
    put(path + "/a.set", "physics-parameters 1\nname a\nset rolling_friction 0.01\n");
    put(path + "/table.csv", "time [s],step,x [m]\n");
    put(path + "/track.csv", "time [s],x [m],y [m]\n");
    put(path + "/mine.csv.txt", "mine");
    put(path + "/note.txt", "mine");
    put(path + "/note.png", "mine");
    const auto filled = [&](QString text) {
        return text.replace("FOLDER", path).replace("NAME", QFileInfo(path).fileName());
    };
    const CommandLine line = parsed(filled(words).split(' '));
    if (said.isEmpty()) {
        QVERIFY2(!line.exitStatus, qPrintable(line.error));
    } else {
        QCOMPARE(line.exitStatus, 2);
        QVERIFY2(line.error.contains(filled(said)), qPrintable(line.error));
    }
    // Nothing is changed, and no file is left behind.
    QCOMPARE(QDir(path).entryList(QDir::Files).join(' '),
             QString("a.set level.obj level.txt mine.csv.txt note.png note.txt run.rec table.csv track.csv"));
    QCOMPARE(readFile(path + "/note.txt", 100, nullptr), QByteArray("mine"));
    QCOMPARE(QFileInfo(level).size(), QFileInfo(LEVELS_FOLDER "/01.txt").size());
}

void TestCommandLine::wrongWordsAreQuotedInOneLine() {
    for (const QString &word :
         {QStringLiteral("--dt=\n\x1b[2J"), QStringLiteral("--\nx"), QStringLiteral("--grab=a\nb"),
          QStringLiteral("--shaders=\u202e"), QStringLiteral("--stepper=\n")}) {
        const CommandLine line = parsed({word});
        QCOMPARE(line.exitStatus, 2);
        QCOMPARE(line.error.count('\n'), 1);
        QVERIFY(!line.error.contains(QChar(0x1b)) && !line.error.contains(QChar(0x202e)));
    }
}

QTEST_GUILESS_MAIN(TestCommandLine)
#include "tst_command_line.moc"
