// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/command_line.h"

#include "core/program/option_table.h"
#include "core/program/outputs.h"
#include "core/program/plugins.h"
#include "core/recording/recording.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "core/setup/numbers.h"
#include "core/setup/parameter_sets.h"
#include "core/setup/tables.h"
#include "core/simulation/simulation.h"

#include <QCommandLineParser>

#include <algorithm>
#include <string_view>
#include <utility>

namespace inspector {

namespace {

/// Invalid usage: one line with the option, the expected and the found value.
struct WrongUse {
    QString line;
};

/// Makes --rolling_friction=1 and --rolling-friction=1 the same option.
QStringList normalised(const QStringList &arguments) {
    QStringList result;
    for (const QString &argument : arguments) {
        const qsizetype end = argument.indexOf(QLatin1Char('='));
        const QString name = argument.left(end < 0 ? argument.size() : end);
        result += argument.startsWith(QLatin1String("--")) ? dashed(name) + argument.mid(name.size()) : argument;
    }
    return result;
}

/// The files of --plugin. They are loaded before the parser is set up, because their steppers' rows become options as
/// well.
QStringList pluginsOf(const QStringList &arguments) {
    const QString prefix = QStringLiteral("--plugin=");
    QStringList paths;
    for (qsizetype i = 1; i < arguments.size(); ++i) {
        if (arguments[i].startsWith(prefix)) paths += arguments[i].mid(prefix.size());
        if (arguments[i] == QLatin1String("--plugin") && i + 1 < arguments.size()) paths += arguments[++i];
    }
    return paths;
}

/// One row per id: the board's, the library's and all steppers' own.
std::vector<const phys_param_row *> allRows(const Registry &registry) {
    const Parameters parameters;
    std::vector<const phys_param_row *> rows;
    rows.reserve(size_t(parameters.count()));
    for (int i = 0; i < parameters.count(); ++i) rows.push_back(&parameters.row(i));
    for (uint32_t i = 0; i < phys_registry_count(registry.get()); ++i) {
        phys_stepper_info info;
        if (phys_registry_info(registry.get(), i, &info) != PHYS_OK) continue;
        for (uint32_t j = 0; j < info.row_count; ++j) {
            const auto hasId = [&](const phys_param_row *row) { return std::string_view(row->id) == info.rows[j]->id; };
            if (std::none_of(rows.begin(), rows.end(), hasId)) rows.push_back(info.rows[j]);
        }
    }
    return rows;
}

double valueOf(const QString &option, const NumberReading &read) {
    if (!read.value) throw WrongUse{QStringLiteral("--%1: ").arg(option) + read.problem};
    return *read.value;
}

double numberOf(const QCommandLineParser &parser, const QString &option, const NumberRange &range) {
    return valueOf(option, readNumber(parser.value(option), range));
}

double wholeNumberOf(const QCommandLineParser &parser, const QString &option, double min, double max) {
    return valueOf(option, readWholeNumber(parser.value(option), {min, max}));
}

double durationOf(const QCommandLineParser &parser, const QString &option, double min, double max) {
    return valueOf(option, readDuration(parser.value(option), min, max));
}

/// text: the option's value.
double parameterOf(const QString &option, const QString &text, const phys_param_row &row) {
    const qsizetype choice = choicesOf(row).indexOf(text.toLower());
    if (choice >= 0) return row.min + double(choice);
    const bool isNumber = choicesOf(row).isEmpty() && !(row.flags & PHYS_ROW_SWITCH);
    const NumberRange range{row.min, row.max, QString::fromUtf8(row.unit)};
    const NumberReading read = isNumber ? readNumber(text, range) : readWholeNumber(text, range);
    if (isNumber || read.value) return valueOf(option, read);
    throw WrongUse{QStringLiteral("--%1: expected %2, found %3").arg(option, expectedOf(row), foundText(text))};
}

void readParameterFile(const QString &path, Options &options) {
    QString error;
    const std::optional<QByteArray> text = readFile(path, kMegabyte, &error);
    const std::optional<ParameterSet> set = text ? readSet(*text, path, &error) : std::nullopt;
    if (!set) throw WrongUse{QStringLiteral("--parameters: ") + error};
    options.parameters = path;
    options.settings = set->values;
}

void readParameters(const QCommandLineParser &parser, const std::vector<const phys_param_row *> &rows,
                    Options &options) {
    QString error;
    phys_stepper_info info;
    phys_error failure;
    if (phys_registry_find(options.registry.get(), options.stepper.constData(), &info, &failure) != PHYS_OK)
        throw WrongUse{QStringLiteral("--stepper: ") + QString::fromUtf8(failure.text)};
    Parameters parameters;
    parameters.setStepper(info);
    if (parser.isSet("parameters")) readParameterFile(parser.value("parameters"), options);
    if (!parameters.set(options.settings, &error))
        throw WrongUse{QStringLiteral("--parameters: %1: %2").arg(quoted(options.parameters), error)};
    for (const phys_param_row *row : rows) {
        if (!parser.isSet(optionName(*row))) continue;
        const QString id = QString::fromUtf8(row->id);
        const int index = parameters.indexOf(id);
        if (index < 0)
            throw WrongUse{QStringLiteral("--%1: stepper '%2' has no such parameter")
                               .arg(optionName(*row), QString::fromUtf8(options.stepper))};
        options.settings.push_back({id, parameterOf(optionName(*row), parser.value(optionName(*row)),
                                                    parameters.row(index))}); // the current stepper's range may differ
    }
    if (!parameters.set(options.settings, &error)) throw WrongUse{error};
}

/// Refuses a tilt, also one of --parameters, where something else tilts the board.
void checkTilts(const QCommandLineParser &parser, const std::vector<Setting> &settings) {
    for (const QString &tilt : {QStringLiteral("tilt_x"), QStringLiteral("tilt_y")})
        for (const char *pilot : {"autopilot", "all-levels", "trade", "fit"})
            if (parser.isSet(pilot) && std::ranges::count(settings, tilt, &Setting::id) > 0)
                throw WrongUse{QStringLiteral("--%1: doesn't go with --%2").arg(dashed(tilt), pilot)};
}

void checkFileNames(const QCommandLineParser &parser) {
    for (const char *name : {"csv", "record", "replay", "grab", "plot", "parameters", "fit", "track"})
        if (parser.isSet(name) && parser.value(name).isEmpty())
            throw WrongUse{QStringLiteral("--%1: expected the name of a file, found nothing").arg(name)};
}

void readMode(const QCommandLineParser &parser, Options &options) {
    const bool playsAll = parser.isSet("all-levels");
    options.force = parser.isSet("force");
    options.headless = parser.isSet("headless") || playsAll;
    options.autopilot = parser.isSet("autopilot") || playsAll;
    if (playsAll) options.action = Options::Action::PlayAllLevels;
}

void readTable(const QCommandLineParser &parser, Options &options) {
    options.csv = parser.value("csv");
    for (const char *ending : {".png", ".svg", ".pdf"})
        if (options.csv.endsWith(QLatin1String(ending), Qt::CaseInsensitive))
            throw WrongUse{
                QStringLiteral("--csv: expected a file name ending in .csv, found %1").arg(foundText(options.csv))};
    if (parser.isSet("csv-every")) options.csvEvery = uint64_t(wholeNumberOf(parser, "csv-every", 1, 1e9));
}

void readView(const QString &view, Options &options) {
    if (view != QLatin1String("2d") && view != QLatin1String("3d"))
        throw WrongUse{QStringLiteral("--view: expected 3d or 2d, found %1").arg(foundText(view))};
    options.view = view == QLatin1String("2d") ? Options::View::Flat : Options::View::Solid;
}

void readWindow(const QCommandLineParser &parser, Options &options) {
    for (const auto &[name, what] : {std::pair("grab", "there is no picture"), std::pair("shaders", "nothing is drawn"),
                                     std::pair("view", "nothing is drawn")})
        if (options.headless && parser.isSet(name))
            throw WrongUse{QStringLiteral("--%1: %2 without a window; leave out --headless").arg(name, what)};
    options.grab = parser.value("grab");
    if (parser.isSet("grab") && !options.grab.endsWith(QLatin1String(".png")))
        throw WrongUse{
            QStringLiteral("--grab: expected a file name ending in .png, found %1").arg(foundText(options.grab))};
    options.shaders = parser.value("shaders");
    if (parser.isSet("shaders") && !isFolder(options.shaders))
        throw WrongUse{QStringLiteral("--shaders: expected a folder, found %1").arg(foundText(options.shaders))};
    if (parser.isSet("view")) readView(parser.value("view"), options);
}

void readComparison(const QCommandLineParser &parser, Options &options) {
    if (!parser.isSet("compare")) return;
    if (!options.replay.isEmpty() && (options.headless || parser.isSet("check")))
        throw WrongUse{QStringLiteral("--compare: goes with --replay in the window only")};
    GhostChoice ghostChoice{parser.value("compare").toUtf8()};
    phys_stepper_info info;
    phys_error failure;
    if (phys_registry_find(options.registry.get(), ghostChoice.stepper.constData(), &info, &failure) != PHYS_OK)
        throw WrongUse{QStringLiteral("--compare: ") + QString::fromUtf8(failure.text)};
    if (parser.isSet("compare-substeps")) {
        ghostChoice.substeps = int(wholeNumberOf(parser, "compare-substeps", 1, GhostChoice::kMostSubsteps));
    }
    options.comparison = ghostChoice;
}

/// Reads the ghost's parameters, which must be valid together with the remaining parameters of the first ball.
void readGhostsParameters(const QCommandLineParser &parser, Options &options) {
    const QString option = QStringLiteral("compare-set");
    if (!parser.isSet(option)) return;
    phys_stepper_info info;
    phys_registry_find(options.registry.get(), options.comparison->stepper.constData(), &info, nullptr);
    Parameters parameters;
    parameters.setStepper(info);
    for (const QString &word : parser.value(option).split(QLatin1Char(','))) {
        const int index = parameters.indexOf(word.section(QLatin1Char('='), 0, 0).trimmed());
        if (index < 0 || isTilt(parameters.row(index)) || !word.contains(QLatin1Char('=')))
            throw WrongUse{
                QStringLiteral("--compare-set: expected parameters other than the tilt, as rolling_friction=0.004, "
                               "found %1")
                    .arg(foundText(word))};
        const phys_param_row &row = parameters.row(index);
        const QString id = QString::fromUtf8(row.id);
        if (std::ranges::count(options.comparisonSettings, id, &Setting::id) > 0)
            throw WrongUse{QStringLiteral("--compare-set: '%1' is named twice").arg(id)};
        const QString value = word.section(QLatin1Char('='), 1).trimmed();
        options.comparisonSettings.push_back({id, parameterOf(option + QStringLiteral(": ") + id, value, row)});
    }
    QString error;
    if (!ghostsInputs(options, &error)) throw WrongUse{QStringLiteral("--compare-set: ") + error};
}

void readRecordings(const QCommandLineParser &parser, const std::vector<const phys_param_row *> &rows,
                    Options &options) {
    if (parser.isSet("record") && !options.replay.isEmpty())
        throw WrongUse{QStringLiteral("--record: doesn't go with --replay")};
    options.record = parser.value("record");
    if (isStandardOutput(options.record) && parser.isSet("record"))
        throw WrongUse{QStringLiteral("--record: expected the name of a file, found '-'")};
    options.check = parser.isSet("check");
    if (options.replay.isEmpty()) {
        if (options.check) throw WrongUse{QStringLiteral("--check: needs --replay")};
        return;
    }
    const bool isWatched = !options.headless && !options.check;
    QStringList others{"level", "stepper", "dt", "parameters", "autopilot", "all-levels", "trade"};
    others += isWatched ? QStringList{"csv"} : QStringList{"speed", "duration", "grab", "shaders"};
    for (const phys_param_row *row : rows) others += optionName(*row);
    for (const QString &name : others)
        if (parser.isSet(name))
            throw WrongUse{QStringLiteral("--replay: %1; doesn't go with --%2")
                               .arg(isWatched && name == QLatin1String("csv") ? "its table needs --headless"
                                                                              : "the recording says all",
                                    name)};
    options.action = Options::Action::Replay;
    options.headless = !isWatched;
}

void readUnknowns(const QCommandLineParser &parser, TradeOptions &trade) {
    QString error;
    const QString words = parser.isSet("unknown") ? parser.value("unknown") : usualUnknowns();
    const std::optional<Unknowns> unknowns = parseUnknowns(words, &error);
    if (!unknowns) throw WrongUse{QStringLiteral("--unknown: ") + error};
    trade.unknowns = *unknowns;
    if (parser.isSet("share")) trade.share = numberOf(parser, "share", {1e-6, 1.0});
}

void readTrade(const QCommandLineParser &parser, Options &options) {
    if (!parser.isSet("trade")) return;
    const auto wrong = [&](const char *name, const char *expected) {
        return WrongUse{
            QStringLiteral("--%1: expected %2, found %3").arg(name, expected, foundText(parser.value(name)))};
    };
    options.action = Options::Action::Trade;
    options.headless = true;
    TradeOptions &trade = options.trade;
    if (parser.isSet("schedule")) trade.schedule = parser.value("schedule");
    if (parser.isSet("steps")) trade.stepSizes = parseStepSizes(parser.value("steps"));
    if (trade.stepSizes.empty()) throw wrong("steps", "step sizes from 1e-6 to 10 s, as 0.01,5ms,1/60");
    const std::optional<Length> under = parser.isSet("under") ? parseLength(parser.value("under")) : Length();
    if (!under) throw wrong("under", "a length above 0, as 1mm, 5um, 0.001m or 0.1R");
    trade.under = *under;
    if (parser.isSet("for")) trade.seconds = durationOf(parser, "for", 1e-3, 1e6);
    if (parser.isSet("within")) trade.within = numberOf(parser, "within", {1.0, 1e12, QStringLiteral("ns")});
    readUnknowns(parser, trade);
    trade.withOrientation = parser.isSet("with-orientation");
    trade.plot = parser.value("plot");
    const QString ending = trade.plot.section(QLatin1Char('.'), -1);
    if (!trade.plot.isEmpty() && !QStringList{"svg", "pdf", "png"}.contains(ending))
        throw wrong("plot", "a file name ending in .svg, .pdf or .png");
}

/// Refuses options that are given twice, because one of the values would be ignored.
void checkGivenOnce(const QCommandLineParser &parser) {
    for (const QString &name : parser.optionNames()) {
        const QStringList values = parser.values(name);
        if (values.size() > 1 && name != QLatin1String("plugin"))
            throw WrongUse{
                QStringLiteral("--%1: given twice, %2 and %3").arg(name, quoted(values[0]), quoted(values[1]))};
    }
}

/// The positional file argument; empty if there is none.
QString fileOf(const QCommandLineParser &parser) {
    const QStringList words = parser.positionalArguments();
    if (words.isEmpty()) return {};
    if (words.size() > 1)
        throw WrongUse{QStringLiteral("expected one file, found %1 and %2; --help lists the options")
                           .arg(quoted(words[0]), quoted(words[1]))};
    if (words[0].isEmpty()) throw WrongUse{QStringLiteral("expected the name of a file, found nothing")};
    QStringList others{"trade", "fit", "all-levels"};
    others += isTrackFile(words[0]) ? QStringList{"track"} : QStringList{"level", "replay"};
    for (const QString &name : others)
        if (parser.isSet(name))
            throw WrongUse{QStringLiteral("--%1: doesn't go with the file %2").arg(name, quoted(words[0]))};
    return words[0];
}

TrackFrame readFrame(const QCommandLineParser &parser) {
    const QStringList words = parser.value("track-frame").split(QLatin1Char(','));
    const NumberRange length{-1e6, 1e6, QStringLiteral("mm")};
    const NumberRange ranges[] = {length, length, {-1e6, 1e6, QStringLiteral("deg")}, {1e-6, 1e6}};
    if (words.size() != qsizetype(std::size(ranges)))
        throw WrongUse{QStringLiteral("--track-frame: expected x,y,angle,scale as 12,-3,90,1, found %1")
                           .arg(foundText(parser.value("track-frame")))};
    std::vector<double> numbers;
    for (qsizetype i = 0; i < words.size(); ++i)
        numbers.push_back(valueOf(QStringLiteral("track-frame"), readNumber(words[i], ranges[i])));
    return {numbers[3], radians(numbers[2]), numbers[0] * 1e-3, numbers[1] * 1e-3};
}

/// The track's file, units and frame, for both the fit and the window.
void readTrackOptions(const QCommandLineParser &parser, FitOptions &fit) {
    QString error;
    fit.unitWords = parser.value("track-units");
    const std::optional<TrackUnits> units = parseTrackUnits(fit.unitWords, &error);
    if (!units) throw WrongUse{QStringLiteral("--track-units: ") + error};
    fit.units = *units;
    if (parser.isSet("track-frame")) fit.frame = readFrame(parser);
}

/// file: the positional argument, if it is a track; else empty.
void readTrackOfWindow(const QCommandLineParser &parser, const QString &file, Options &options) {
    options.fit.track = parser.isSet("track") ? parser.value("track") : file;
    for (const char *name : {"track-units", "track-frame"})
        if (options.fit.track.isEmpty() && parser.isSet(name))
            throw WrongUse{QStringLiteral("--%1: needs --fit or --track").arg(name)};
    if (options.fit.track.isEmpty() && !parser.isSet("track")) return;
    if (options.headless) throw WrongUse{QStringLiteral("--track: is shown in the window; --fit needs none")};
    readTrackOptions(parser, options.fit);
    QString error;
    if (!readTrackFile(options.fit.track, options.fit.units, &error))
        throw WrongUse{QStringLiteral("--track: ") + error};
}

void readFit(const QCommandLineParser &parser, Options &options) {
    if (!parser.isSet("fit")) return;
    QString error;
    options.action = Options::Action::Fit;
    options.headless = true;
    options.fit.track = parser.value("fit");
    readTrackOptions(parser, options.fit);
    const QString words = parser.isSet("fit-for") ? parser.value("fit-for") : usualFitQuantities();
    const std::optional<std::vector<FitQuantity>> quantities = parseFitQuantities(words, &error);
    if (!quantities) throw WrongUse{QStringLiteral("--fit-for: ") + error};
    options.fit.quantities = *quantities;
}

/// file: the positional argument, if it is a maze; else empty. A window returns to the level after a replay.
Level readLevel(const QCommandLineParser &parser, const QString &file, const Options &options) {
    if (!file.isEmpty()) return levelOfFile(file);
    if (options.action == Options::Action::Fit && !parser.isSet("level"))
        throw WrongUse{QStringLiteral("--fit: needs the track's maze: --level L or a file")};
    const QString named = parser.isSet("trade") ? QStringLiteral("trade") : QStringLiteral("level");
    if (!parser.isSet(named) && !options.levels.empty()) return firstLevel(options.levels);
    const QString wanted = parser.isSet(named) ? parser.value(named) : QStringLiteral("1");
    QString error;
    const std::optional<Level> level = findLevel(options.levels, wanted, &error);
    const QString option = options.action == Options::Action::Replay ? QStringLiteral("replay") : named;
    if (!level) throw WrongUse{QStringLiteral("--%1: ").arg(option) + error};
    if (!fileExists(level->path))
        throw WrongUse{QStringLiteral("--%1: expected the number of a level or a maze's file, found %2")
                           .arg(option, foundText(wanted))};
    return *level;
}

Options readOptions(const QCommandLineParser &parser, const std::vector<const phys_param_row *> &rows,
                    const Registry &registry, const QStringList &plugins) {
    Options options;
    options.registry = registry;
    options.plugins = plugins;
    checkGivenOnce(parser);
    checkFileNames(parser);
    if (const QString conflict = conflictOf(parser); !conflict.isEmpty()) throw WrongUse{conflict};
    const QString file = fileOf(parser);
    const QString track = isTrackFile(file) ? file : QString();
    if (isRecordingFile(file)) options.replay = file;
    if (parser.isSet("replay")) options.replay = parser.value("replay");
    if (parser.isSet("stepper")) options.stepper = parser.value("stepper").toUtf8();
    if (parser.isSet("dt")) options.dt = durationOf(parser, "dt", Engine::kSmallestDt, Engine::kLargestDt);
    if (parser.isSet("speed")) options.speed = numberOf(parser, "speed", {Simulation::kSlowest, Simulation::kFastest});
    if (parser.isSet("duration")) options.duration = durationOf(parser, "duration", 0.0, 1e9);
    readMode(parser, options);
    readTable(parser, options);
    readWindow(parser, options);
    readComparison(parser, options);
    readRecordings(parser, rows, options);
    readTrade(parser, options);
    readFit(parser, options);
    if (options.action != Options::Action::Fit) readTrackOfWindow(parser, track, options);
    readParameters(parser, rows, options);
    checkTilts(parser, options.settings);
    readGhostsParameters(parser, options);

    options.levels = levelsIn(levelsFolder());
    const bool isReplay = options.action == Options::Action::Replay;
    const bool isMaze = track.isEmpty() && !isReplay;
    if (!isReplay || !options.headless) options.level = readLevel(parser, isMaze ? file : QString(), options);
    const QString problem = outputProblem(options);
    if (!problem.isEmpty()) throw WrongUse{problem};
    return options;
}

CommandLine ended(const QString &output) {
    CommandLine result;
    result.exitStatus = 0;
    result.output = output;
    return result;
}

CommandLine parseOrThrow(const QStringList &arguments, PluginLoader load) {
    QString error;
    QStringList leftOut;
    const QStringList plugins = pluginsOf(arguments);
    const Registry registry = registryWith(plugins, load, &leftOut, &error);
    if (!registry) throw WrongUse{QStringLiteral("--plugin: ") + error};
    const std::vector<const phys_param_row *> rows = allRows(registry);
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Shows, plays and tunes one ball rolling through a maze."));
    parser.addPositionalArgument(QStringLiteral("file"),
                                 QStringLiteral("A maze, a recording or a table of a measured ball to open."),
                                 QStringLiteral("[file]"));
    addOptions(parser, rows);
    if (!parser.parse(arguments)) throw WrongUse{parser.errorText() + QStringLiteral(" --help lists the options")};
    if (parser.isSet("help")) return ended(parser.helpText());
    if (parser.isSet("version")) return ended(versionLine() + QLatin1Char('\n'));
    QString lists;
    if (parser.isSet("list-steppers")) lists += stepperTable(registry);
    if (parser.isSet("list-parameters")) lists += parameterTable(rows);
    CommandLine result = lists.isEmpty() ? CommandLine{} : ended(lists);
    for (const QString &line : leftOut)
        result.error += QStringLiteral("physics-inspector: plugin left out: %1\n").arg(line);
    if (lists.isEmpty()) result.options = readOptions(parser, rows, registry, plugins);
    result.options.pluginLoader = load;
    return result;
}

} // namespace

CommandLine parseCommandLine(const QStringList &arguments, PluginLoader load) {
    try {
        return parseOrThrow(normalised(arguments), load);
    } catch (const WrongUse &wrong) {
        CommandLine result;
        result.exitStatus = 2;
        result.error = QStringLiteral("physics-inspector: %1\n").arg(oneLine(wrong.line));
        return result;
    }
}

} // namespace inspector
