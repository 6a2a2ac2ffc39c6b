// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/csv_writer.h"

#include "core/program/outputs.h"
#include "core/setup/lines.h"
#include "core/setup/tables.h"

#include <cmath>

namespace inspector {

namespace {

// Each has the columns of the one before, and more after them.
size_t countOf(Columns columns) {
    switch (columns) {
    case Columns::Ball:
        return kBallChannelCount;
    case Columns::BallAndGhost:
        return kTableChannelCount;
    case Columns::All:
        break;
    }
    return kChannelCount;
}

QByteArray comparisonLines(const Options &options) {
    if (!options.comparison) return {};
    const auto &[id, substeps] = *options.comparison;
    phys_stepper_info info{};
    phys_registry_find(options.registry.get(), id.constData(), &info, nullptr);
    QByteArray lines = "compare " + id + " " + (info.version ? info.version : "") + "\ncompare-substeps " +
                       QByteArray::number(substeps) + "\n";
    for (const Setting &own : options.comparisonSettings)
        lines += "compare-set " + own.id.toUtf8() + " " + exactText(own.value) + "\n";
    return lines;
}

} // namespace

QByteArray tableSettings(const Options &options) {
    Parameters parameters;
    phys_stepper_info info{};
    if (phys_registry_find(options.registry.get(), options.stepper.constData(), &info, nullptr) == PHYS_OK)
        parameters.setStepper(info);
    parameters.set(options.settings);

    QByteArray text = versionLine().toUtf8() + "\n";
    text += "level " + oneLine(options.level.name).toUtf8() + "\n";
    text += "stepper " + options.stepper + " " + (info.version ? info.version : "") + "\n";
    text += "dt " + exactText(options.dt) + " s\nautopilot " + QByteArray(options.autopilot ? "on" : "off") + "\n";
    text += comparisonLines(options);
    for (int i = 0; i < parameters.count(); ++i) {
        const phys_param_row &row = parameters.row(i);
        text += QByteArray(row.id) + " " + exactText(parameters.value(i));
        text += row.unit[0] ? " " + QByteArray(row.unit) + "\n" : "\n";
    }
    return text;
}

QByteArray csvHeader(Columns columns) {
    QByteArray line = "time [s],step";
    for (size_t i = 0; i < countOf(columns); ++i) {
        const ChannelInfo &info = channelInfos()[i];
        line += "," + QByteArray(info.id);
        if (info.unit[0]) line += " [" + QByteArray(info.unit) + "]";
    }
    return line + "\n";
}

QByteArray csvRow(const Sample &sample, Columns columns) {
    QByteArray line;
    line.reserve(400);
    line += exactText(sample.time) + "," + QByteArray::number(qulonglong(sample.step));
    for (size_t i = 0; i < countOf(columns); ++i) {
        const double value = sample.values[i];
        line += ',' + (std::isnan(value) ? QByteArray() : exactText(value));
    }
    return line + "\n";
}

CsvWriter::CsvWriter(QIODevice &out, const Options &options)
    : m_out(out)
    , m_columns(options.comparison ? Columns::BallAndGhost : Columns::Ball)
    , m_every(options.csvEvery) {
    put(csvHeader(m_columns));
}

void CsvWriter::write(const Sample &sample) {
    if (sample.step % m_every == 0) put(csvRow(sample, m_columns));
}

void CsvWriter::put(const QByteArray &text) {
    if (m_isGood) m_isGood = m_out.write(text) == text.size();
}

std::unique_ptr<OutputFile> openTable(const QString &path, const Options &options, QString *error) {
    if (isStandardOutput(path)) return standardOutput();
    std::unique_ptr<OutputFile> table = OutputFile::open(path, Existing::Replace, {}, error);
    if (!table || !table->isRegular()) return table; // beside a device there is no place for a file
    const QByteArray settings = tableSettings(options);
    const std::unique_ptr<OutputFile> beside =
        OutputFile::open(settingsFileOf(path), Existing::Replace, {}, error); // outputProblem() has looked
    if (!beside) return nullptr;
    beside->write(settings);
    if (beside->finish()) return table;
    if (error) *error = beside->problem();
    return nullptr;
}

bool writeTable(const QString &path, const SampleRing &samples, const Options &options, QString *error) {
    const std::unique_ptr<OutputFile> file = openTable(path, options, error);
    if (!file) return false;
    CsvWriter writer(*file, options);
    Sample sample;
    const uint64_t end = samples.last();
    for (uint64_t number = samples.first(); number < end && writer.isGood(); ++number)
        if (samples.read(number, sample)) writer.write(sample);
    if (file->finish() || file->isUnread()) return true;
    if (error) *error = file->problem();
    return false;
}

} // namespace inspector
