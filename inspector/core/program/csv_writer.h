// SPDX-License-Identifier: GPL-3.0-or-later
// Samples as a table of text: a header with units, a row per step, nothing else, so that any program reads it; what
// made it stands in a file beside it. The same bytes in every locale; the shortest numbers that read back exactly.
#pragma once

#include "core/program/options.h"
#include "core/setup/files.h"
#include "core/simulation/sample_ring.h"

#include <QByteArray>
#include <QIODevice>

namespace inspector {

// What made a table, a line each: program, level, stepper, dt and every parameter.
QByteArray tableSettings(const Options &options);
// Which of a run's samples a ring still has: "samples from 12.3 s to 20 s; earlier ones aren't kept" and the like.
QString spanOf(const SampleRing &samples);
enum class Columns { Ball, BallAndGhost, All }; // without or with those of the comparison; whatever there is

std::vector<Channel> channelsOf(Columns columns);

// The line that names the columns.
QByteArray csvHeader(const std::vector<Channel> &channels = channelsOf(Columns::Ball));
// A field without a value is empty.
QByteArray csvRow(const Sample &sample, const std::vector<Channel> &channels = channelsOf(Columns::Ball));
// Header and rows of what a ring has from a time on, s. Of Columns::All those in which no row has a value are left out.
void writeSamples(QIODevice &out, const SampleRing &samples, double since, Columns columns);

// The file that --csv names, or standard output; null and one line in `error` (or nullptr) if it can't be opened.
// Beside a file, with .txt after its name, stand the settings and the remark, a line, if there is one.
std::unique_ptr<OutputFile> openTable(const QString &path, const Options &options, QString *error,
                                      const QString &remark = {});

class CsvWriter {
public:
    // out: open for writing; outlives the writer.
    CsvWriter(QIODevice &out, const Options &options);

    // Writes the sample if its step number is a multiple of options.csvEvery.
    void write(const Sample &sample);
    // False once something could not be written; the device knows why.
    bool isGood() const { return m_isGood; }

private:
    void put(const QByteArray &text);

    QIODevice &m_out;
    std::vector<Channel> m_channels;
    uint64_t m_every;
    bool m_isGood = true;
};

// Writes all samples of a ring to a file, or to standard output if it is "-"; their span is said beside it. One line in
// `error` (or nullptr) if it can't be written.
bool writeTable(const QString &path, const SampleRing &samples, const Options &options, QString *error);

} // namespace inspector
