// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/csv_writer.h"

#include "core/program/outputs.h"
#include "core/setup/lines.h"
#include "core/setup/tables.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inspector {

namespace {

QByteArray parameterLine(const phys_param_row &row, double value) {
    const QStringList choices = choicesOf(row);
    const QByteArray text = choices.isEmpty() ? exactText(value) : choices.value(qsizetype(value - row.min)).toUtf8();
    return QByteArray(row.id) + " " + text + (row.unit[0] ? " " + QByteArray(row.unit) : QByteArray()) + "\n";
}

/// The ghost's tilt is the ball's.
QByteArray comparisonLines(const Options &options) {
    if (!options.comparison) return {};
    const auto &[id, substeps] = *options.comparison;
    phys_stepper_info info{};
    phys_registry_find(options.registry.get(), id.constData(), &info, nullptr);
    QByteArray lines = "compare " + id + " " + (info.version ? info.version : "") + "\ncompare-substeps " +
                       QByteArray::number(substeps) + "\n";
    Parameters parameters;
    if (info.id) parameters.setStepper(info);
    for (const Setting &own : options.comparisonSettings) {
        const int index = parameters.indexOf(own.id);
        if (index < 0 || isTilt(parameters.row(index))) continue;
        lines += "compare-set " + parameterLine(parameters.row(index), own.value);
    }
    return lines;
}

} // namespace

/// Each extends the previous one's columns.
std::vector<Channel> channelsOf(Columns columns) {
    const size_t count = columns == Columns::Ball           ? kBallChannelCount
                         : columns == Columns::BallAndGhost ? kTableChannelCount
                                                            : kChannelCount;
    std::vector<Channel> channels;
    for (size_t i = 0; i < count; ++i) channels.push_back(Channel(i));
    return channels;
}

QByteArray tableSettings(const Options &options) {
    Parameters parameters;
    phys_stepper_info info{};
    if (phys_registry_find(options.registry.get(), options.stepper.constData(), &info, nullptr) == PHYS_OK)
        parameters.setStepper(info);
    parameters.set(options.settings);

    QByteArray text = settingsHead(options);
    text += "stepper " + options.stepper + " " + (info.version ? info.version : "") + "\n";
    text += "dt " + exactText(options.dt) + " s\nautopilot " + QByteArray(options.autopilot ? "on" : "off") + "\n";
    text += comparisonLines(options) + parameterLines(parameters);
    return options.autopilot ? withVariedTilt(text) : text;
}

QByteArray withVariedTilt(const QByteArray &settings) {
    QByteArrayList lines = settings.trimmed().split('\n');
    lines.removeIf([](const QByteArray &line) { return line.startsWith("tilt_"); });
    lines += "tilt varies: columns tilt_x, tilt_y\n";
    return lines.join('\n');
}

QByteArray settingsHead(const Options &options) {
    return versionLine().toUtf8() + "\nlevel " + oneLine(options.level.name).toUtf8() + "\n";
}

QByteArray parameterLines(const Parameters &parameters) {
    QByteArray text;
    for (int i = 0; i < parameters.count(); ++i) text += parameterLine(parameters.row(i), parameters.value(i));
    return text;
}

QString spanOf(const SampleRing &samples, double since) {
    Sample first;
    Sample last;
    const bool isThere = samples.read(samples.find(since), first) && samples.read(samples.last() - 1, last);
    if (!isThere) return QStringLiteral("no samples");
    QStringList parts{QStringLiteral("samples from %1 s to %2 s").arg(first.time).arg(last.time)};
    if (samples.hasLostSamples()) parts += QStringLiteral("earlier ones aren't kept");
    return parts.join(QStringLiteral("; "));
}

bool hasValues(const SampleRing &samples, Channel channel, double since) {
    constexpr double kEver = std::numeric_limits<double>::infinity();
    const std::vector<Column> all = samples.columns(channel, since, kEver, 1);
    return std::any_of(all.begin(), all.end(), [](const Column &one) { return !std::isnan(one.min); });
}

QByteArray csvHeader(const std::vector<Channel> &channels) {
    QByteArray line = "time [s],step";
    for (const Channel channel : channels) {
        const ChannelInfo &info = channelInfos()[size_t(channel)];
        line += "," + QByteArray(info.id);
        if (info.unit[0]) line += " [" + QByteArray(info.unit) + "]";
    }
    return line + "\n";
}

QByteArray csvRow(const Sample &sample, const std::vector<Channel> &channels) {
    QList<QByteArray> fields{exactText(sample.time), QByteArray::number(qulonglong(sample.step))};
    for (const Channel channel : channels) {
        const double value = sample[channel];
        fields += std::isnan(value) ? QByteArray() : exactText(value);
    }
    return csvLine(fields);
}

void writeSamples(QIODevice &out, const SampleRing &samples, double since, Columns columns) {
    std::vector<Channel> channels = channelsOf(columns);
    if (columns == Columns::All)
        std::erase_if(channels, [&](Channel channel) { return !hasValues(samples, channel, since); });
    out.write(csvHeader(channels));
    Sample sample;
    const uint64_t end = samples.last();
    for (uint64_t number = std::max(samples.first(), samples.find(since)); number < end; ++number)
        if (samples.read(number, sample)) out.write(csvRow(sample, channels));
}

bool saveSamples(const QString &path, const SampleRing &samples, double since, Columns columns, QString *error) {
    if (samples.find(since) == samples.last()) {
        if (error) *error = quoted(path) + QStringLiteral(": no samples");
        return false;
    }
    const auto write = [&](QIODevice &file) {
        writeSamples(file, samples, since, columns);
        return true;
    };
    return replaceFile(path, write, error);
}

TableShape tableShape(const Options &options) {
    return {options.comparison ? Columns::BallAndGhost : Columns::Ball, options.csvEvery};
}

CsvWriter::CsvWriter(QIODevice &out, const TableShape &shape)
    : m_out(out)
    , m_channels(channelsOf(shape.columns))
    , m_every(shape.every) {
    put(csvHeader(m_channels));
}

void CsvWriter::write(const Sample &sample) {
    if (sample.step % m_every == 0) put(csvRow(sample, m_channels));
}

void CsvWriter::put(const QByteArray &text) {
    if (m_isGood) m_isGood = m_out.write(text) == text.size();
}

std::unique_ptr<OutputFile> openTable(const QString &path, const QByteArray &settings, QString *error) {
    if (isStandardOutput(path)) return standardOutput();
    std::unique_ptr<OutputFile> table = OutputFile::open(path, Existing::Replace, {}, error);
    if (!table || !table->isRegular()) return table; // a device has no file next to it
    const std::unique_ptr<OutputFile> beside =
        OutputFile::open(settingsFileOf(path), Existing::Replace, {}, error); // checked by outputProblem()
    if (!beside) return nullptr;
    beside->write(settings);
    if (beside->finish()) return table;
    if (error) *error = beside->problem();
    return nullptr;
}

bool writeTable(const QString &path, const QByteArray &table, const QByteArray &settings, QString *error) {
    const std::unique_ptr<OutputFile> file = openTable(path, settings, error);
    if (!file) return false;
    file->write(table);
    if (file->finish()) return true;
    if (error) *error = file->problem();
    return false;
}

bool writeTable(const QString &path, const SampleRing &samples, const TableShape &shape, const QByteArray &settings,
                QString *error) {
    if (samples.first() == samples.last()) {
        if (error) *error = quoted(path) + QStringLiteral(": no samples");
        return false;
    }
    const std::unique_ptr<OutputFile> file = openTable(path, settings, error);
    if (!file) return false;
    CsvWriter writer(*file, shape);
    Sample sample;
    const uint64_t end = samples.last();
    for (uint64_t number = samples.first(); number < end && writer.isGood(); ++number)
        if (samples.read(number, sample)) writer.write(sample);
    if (file->finish() || file->isUnread()) return true;
    if (error) *error = file->problem();
    return false;
}

} // namespace inspector
