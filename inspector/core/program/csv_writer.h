// SPDX-License-Identifier: GPL-3.0-or-later
// Samples as a text table: a header with units and a row per step, nothing else, so that any program reads it; its
// settings are in a file next to it. The same bytes in every locale; the shortest numbers that read back exactly.
#pragma once

#include "core/program/options.h"
#include "core/setup/files.h"
#include "core/simulation/sample_ring.h"

#include <QByteArray>
#include <QIODevice>

#include <cmath>

namespace inspector {

/// The first lines of each table's settings: program and level.
QByteArray settingsHead(const Options &options);
/// A line for each parameter, with its unit.
QByteArray parameterLines(const Parameters &parameters);
/// The settings of a run's table, one per line: program, level, stepper, dt and every parameter.
QByteArray tableSettings(const Options &options);
/// Those settings with a tilt that isn't constant: instead of its values, that they are in the table's columns.
QByteArray withVariedTilt(const QByteArray &settings);
/// Describes which of the run's samples from `since` on, s, the ring still has: "samples from 12.3 s to 20 s; earlier
/// ones aren't kept" and the like.
QString spanOf(const SampleRing &samples, double since = -HUGE_VAL);
/// Whether any sample from `since` on has a value of this channel.
bool hasValues(const SampleRing &samples, Channel channel, double since);
enum class Columns { Ball, BallAndGhost, All }; ///< without the comparison's columns, with them, or every channel

std::vector<Channel> channelsOf(Columns columns);

/// The header line.
QByteArray csvHeader(const std::vector<Channel> &channels = channelsOf(Columns::Ball));
/// One row; a field without a value is empty.
QByteArray csvRow(const Sample &sample, const std::vector<Channel> &channels = channelsOf(Columns::Ball));
/// Writes a header and the ring's samples from `since` on, s. With Columns::All, columns without any value are left
/// out.
void writeSamples(QIODevice &out, const SampleRing &samples, double since, Columns columns);
/// Writes them to a file, whole or not at all. Returns false, with one line in `error` (may be nullptr), if that fails
/// or there are none.
bool saveSamples(const QString &path, const SampleRing &samples, double since, Columns columns, QString *error);

/// Opens the file that --csv names, or standard output; null, with one line in `error` (may be nullptr), if that fails.
/// Next to a file, under its name with .txt appended, the settings are written.
std::unique_ptr<OutputFile> openTable(const QString &path, const QByteArray &settings, QString *error);

/// Writes a whole table there. Returns false, with one line in `error` (may be nullptr), on failure.
bool writeTable(const QString &path, const QByteArray &table, const QByteArray &settings, QString *error);

/// Which columns and rows a table has.
struct TableShape {
    Columns columns = Columns::Ball;
    uint64_t every = 1; ///< steps from one row to the next
};
/// What the options ask for.
TableShape tableShape(const Options &options);

class CsvWriter {
public:
    /// out: open for writing; must outlive the writer.
    CsvWriter(QIODevice &out, const TableShape &shape);

    /// Writes the sample if its step number is a multiple of the shape's `every`.
    void write(const Sample &sample);
    /// False once something could not be written; the device has the reason.
    bool isGood() const { return m_isGood; }

private:
    void put(const QByteArray &text);

    QIODevice &m_out;
    std::vector<Channel> m_channels;
    uint64_t m_every;
    bool m_isGood = true;
};

/// Writes all samples of a ring to a file, with the settings next to it, or to standard output for "-". Returns false,
/// with one line in `error` (may be nullptr), on failure.
bool writeTable(const QString &path, const SampleRing &samples, const TableShape &shape, const QByteArray &settings,
                QString *error);

} // namespace inspector
