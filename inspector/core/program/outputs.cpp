// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/outputs.h"

#include "core/recording/playable_recording.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"

namespace inspector {

namespace {

struct Output {
    QString option;
    QString path;
    QByteArray mark;           ///< first bytes of such a file; empty: an existing one is kept
    bool isBesideLast = false; ///< stands next to the previous one, if that is a file
};

/// A table's header is its mark.
QByteArray markOfTable(Options::Action action) {
    if (action == Options::Action::Trade) return "stepper,dt [s],";
    return action == Options::Action::Fit ? "time [s],x [m],y [m],computed_x" : "time [s],step,";
}

QByteArray markOfChart(const QString &path) {
    if (path.endsWith(QLatin1String(".svg"))) return "<svg";
    return path.endsWith(QLatin1String(".pdf")) ? "%PDF" : "\x89PNG";
}

std::vector<Output> outputsOf(const Options &options) {
    std::vector<Output> outputs;
    const QString csv = isStandardOutput(options.csv) ? QString() : options.csv;
    const QString settings = csv.isEmpty() ? QString() : settingsFileOf(csv);
    for (const Output &output : {Output{QStringLiteral("--csv"), csv, markOfTable(options.action)},
                                 Output{QStringLiteral("--csv"), settings, kSettingsMark, true},
                                 Output{QStringLiteral("--record"), options.record, {}},
                                 Output{QStringLiteral("--grab"), options.grab, "\x89PNG"},
                                 Output{QStringLiteral("--plot"), options.trade.plot, markOfChart(options.trade.plot)}})
        if (!output.path.isEmpty()) outputs.push_back(output);
    return outputs;
}

/// The mazes of a recording, without which it can't be played any more. Empty if the file isn't a recording or can't be
/// opened, which is reported later.
QStringList mazesOf(const QString &recording, const Options &options) {
    QString error;
    const auto found = openRecording(recording, options.registry, options.levels, &error);
    QStringList mazes;
    for (size_t i = 0; found && i < found->recording().segments.size(); ++i)
        mazes += {found->level(i).path, found->level(i).mesh};
    mazes.removeDuplicates();
    return mazes;
}

QStringList inputsOf(const Options &options) {
    QStringList inputs{options.level.path,     options.level.mesh, options.replay,
                       options.trade.schedule, options.fit.track,  options.parameters};
    inputs += options.plugins;
    for (const Level &level : options.levels) inputs += {level.path, level.mesh};
    for (const QString &name : fileNamesIn(options.shaders)) inputs += options.shaders + QLatin1Char('/') + name;
    for (const QString &recording : {options.replay, options.trade.schedule})
        if (!recording.isEmpty()) inputs += mazesOf(recording, options);
    inputs.removeAll(QString());
    return inputs;
}

} // namespace

QString settingsFileOf(const QString &csv) { return csv + QStringLiteral(".txt"); }

bool isStandardOutput(const QString &csv) { return csv.isEmpty() || csv == QLatin1String("-"); }

QString outputProblem(const Options &options) {
    const std::vector<Output> outputs = outputsOf(options);
    const QStringList inputs = outputs.empty() ? QStringList() : inputsOf(options);
    std::vector<std::unique_ptr<OutputFile>> opened; // kept open, so that a name given twice is found
    for (const Output &output : outputs) {
        if (output.isBesideLast && !opened.back()->isRegular()) continue;
        const auto refusal = [&](const QString &reason) { return output.option + QStringLiteral(": ") + reason; };
        for (const QString &input : inputs)
            if (isSameFile(output.path, input))
                return refusal(QStringLiteral("%1 is read by this run").arg(quoted(output.path)));
        for (const auto &other : opened)
            if (isSameFile(output.path, other->name()) && other->isRegular())
                return refusal(QStringLiteral("%1 is written by this run already").arg(quoted(output.path)));
        const Existing other = output.mark.isEmpty() ? Existing::Keep : Existing::ReplaceOwn;
        QString reason;
        auto file = OutputFile::open(output.path, options.force ? Existing::Replace : other, output.mark, &reason);
        if (!file) return refusal(reason);
        opened.push_back(std::move(file));
    }
    return {};
}

} // namespace inspector
