// SPDX-License-Identifier: GPL-3.0-or-later
// A recording: all inputs of a run's steps and the hash of each resulting state, as one text file. This is the one
// place in the inspector that knows its format, libphysics/docs/recording_format.md; libphysics/examples/c/replay.c
// reads it as well. Numbers are the shortest decimals that read back to the same bits, in every locale.
#pragma once

#include "core/setup/handles.h"
#include "core/setup/inputs.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace inspector {

inline constexpr int kRecordingVersion = 1;
inline constexpr char kRecordingMark[] = "physics-recording"; ///< first word of the file

/// FNV-1a, as phys_state_hash.
uint64_t hashOf(const QByteArray &bytes);
/// 16 hexadecimal digits.
QByteArray hashText(uint64_t hash);

/// A maze text file and the hash of its bytes.
struct MazeSource {
    QString path;
    uint64_t hash = 0;
    bool operator==(const MazeSource &) const = default;
};

/// The stepper as it is known on any machine.
struct StepperSource {
    QByteArray id;
    QByteArray version;
    bool operator==(const StepperSource &) const = default;
};

/// The conditions of a step.
struct Conditions {
    MazeSource maze;
    StepperSource stepper;
    double dt = 0.0; ///< s
    Inputs inputs = initialInputs();
};

/// Consecutive steps under the same conditions.
struct Segment {
    Conditions conditions;
    std::optional<phys_state> from; ///< before the first step; empty: continues the previous segment
    std::vector<uint64_t> hashes;   ///< phys_state_hash after each step
    QString failure;                ///< the library's message if the step after these failed; else empty
    int mazeLine = 0;               ///< in the file
    int stepperLine = 0;
};

struct Recording {
    QString file;
    QString program; ///< with its version
    QString library; ///< its version
    std::vector<Segment> segments;
    bool isWhole = false; ///< complete: the program that wrote it wasn't interrupted
};

// ---- writing ----

/// The rows that `set` lines hold: the library's (except the board's gravity) and the stepper's.
std::vector<const phys_param_row *> recordedRows(const phys_stepper_info &info);

QByteArray recordingHead();
/// Lines for what differs from `before`, or for everything if `before` is null.
QByteArray conditionsText(const Conditions *before, const Conditions &now, const phys_stepper_info &info);
QByteArray stateText(const phys_state &state);
QByteArray stepText(const phys_state &after);
QByteArray failureText(const QString &line);
QByteArray recordingEnd();
/// The text of a whole recording, whose steppers must be in the registry.
QByteArray recordingText(const Recording &recording, const Registry &registry);

// ---- reading ----

/// Whether the file begins with a recording's first word.
bool isRecordingFile(const QString &path);

/// registry: has the rows of the steppers named. An incomplete last line is ignored. Returns nothing, with one line in
/// `error` that begins with the line's number, if the text isn't a recording.
std::optional<Recording> parseRecording(const QByteArray &text, const Registry &registry, QString *error);
/// The same from a file; `error` begins with file and line.
std::optional<Recording> readRecording(const QString &path, const Registry &registry, QString *error);

} // namespace inspector
