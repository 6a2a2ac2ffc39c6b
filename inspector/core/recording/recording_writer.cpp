// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/recording.h"
#include "core/setup/files.h"
#include "core/setup/tables.h"

#include <bit>
#include <initializer_list>

namespace inspector {

namespace {

QByteArray line(const QByteArray &word, std::initializer_list<double> numbers) {
    QByteArray text = word;
    for (const double number : numbers) text += ' ' + exactText(number);
    return text + '\n';
}

/// Replaces line breaks, which would end the line.
QByteArray unbroken(const QString &text) { return text.toUtf8().replace('\n', ' ').replace('\r', ' '); }

/// Compares bits: 0 and -0 differ.
bool isSame(double a, double b) { return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b); }

/// A file name's bytes, with line breaks and % encoded as in a URL.
QByteArray pathText(const QString &path) {
    return encodePath(path).replace('%', "%25").replace('\n', "%0A").replace('\r', "%0D");
}

QByteArray boardText(const Inputs &inputs) {
    const phys_vec3 &g = inputs.params.gravity;
    return line("board", {inputs.tilt.x, inputs.tilt.y, inputs.gravity, g.x, g.y, g.z});
}

QByteArray rowsText(const phys_params *before, const phys_params &now, const phys_stepper_info &info) {
    QByteArray text;
    for (const phys_param_row *row : recordedRows(info)) {
        const double value = phys_param_get(&now, row);
        if (!before || !isSame(phys_param_get(before, row), value)) text += line("set " + QByteArray(row->id), {value});
    }
    if (!before || before->options != now.options) text += "options " + QByteArray::number(now.options) + '\n';
    return text;
}

} // namespace

uint64_t hashOf(const QByteArray &bytes) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const char byte : bytes) hash = (hash ^ uint8_t(byte)) * 0x100000001b3u;
    return hash;
}

QByteArray hashText(uint64_t hash) { return QByteArray::number(qulonglong(hash), 16).rightJustified(16, '0'); }

std::vector<const phys_param_row *> recordedRows(const phys_stepper_info &info) {
    std::vector<const phys_param_row *> result;
    uint32_t count = 0;
    const phys_param_row *rows = phys_param_rows(&count);
    for (const phys_param_row *row = rows; row != rows + count; ++row)
        if (!(row->flags & PHYS_ROW_INPUT)) result.push_back(row);
    result.insert(result.end(), info.rows, info.rows + info.row_count);
    return result;
}

QByteArray recordingHead() {
    return QByteArray(kRecordingMark) + ' ' + QByteArray::number(kRecordingVersion) +
           "\n# Repeat it: physics-inspector --replay THIS_FILE --check\n"
           "# level: hash of the maze file, file; board: tilt x, y [rad], gravity and its vector [m/s^2]\n"
           "# state: time, step, position, velocity, spin, orientation, flags; then a line a step: hash of its state\n"
           "program physics-inspector " +
           QByteArray(programVersion()) + "\nlibrary " + QByteArray(phys_version()) + '\n';
}

QByteArray conditionsText(const Conditions *before, const Conditions &now, const phys_stepper_info &info) {
    QByteArray text;
    if (!before || !(before->maze == now.maze))
        text += "level " + hashText(now.maze.hash) + ' ' + pathText(now.maze.path) + '\n';
    const bool isNewStepper = !before || !(before->stepper == now.stepper);
    if (isNewStepper) text += "stepper " + now.stepper.id + ' ' + now.stepper.version + '\n';
    if (!before || !isSame(before->dt, now.dt)) text += line("dt", {now.dt});
    // A new stepper needs all rows: reading its line resets its own to their initial values.
    text += rowsText(isNewStepper ? nullptr : &before->inputs.params, now.inputs.params, info);
    const QByteArray board = boardText(now.inputs);
    return before && boardText(before->inputs) == board ? text : text + board;
}

QByteArray stateText(const phys_state &state) {
    const phys_vec3 &p = state.position;
    const phys_vec3 &v = state.velocity;
    const phys_vec3 &w = state.spin;
    QByteArray text = "state " + exactText(state.time) + ' ' + QByteArray::number(qulonglong(state.step));
    for (const double number : {p.x, p.y, p.z, v.x, v.y, v.z, w.x, w.y, w.z}) text += ' ' + exactText(number);
    for (const double number : state.orientation) text += ' ' + exactText(number);
    return text + ' ' + QByteArray::number(qulonglong(state.flags)) + '\n';
}

QByteArray stepText(const phys_state &after) { return hashText(phys_state_hash(&after)) + '\n'; }

QByteArray failureText(const QString &line) { return "failed " + unbroken(line) + '\n'; }

QByteArray recordingEnd() { return "end\n"; }

QByteArray recordingText(const Recording &recording, const Registry &registry) {
    QByteArray text = recordingHead();
    const Conditions *before = nullptr;
    for (const Segment &segment : recording.segments) {
        phys_stepper_info info{};
        phys_registry_find(registry.get(), segment.conditions.stepper.id.constData(), &info, nullptr);
        text += conditionsText(before, segment.conditions, info);
        if (segment.from) text += stateText(*segment.from);
        for (const uint64_t hash : segment.hashes) text += hashText(hash) + '\n';
        if (!segment.failure.isEmpty()) text += failureText(segment.failure);
        before = &segment.conditions;
    }
    return text + recordingEnd();
}

} // namespace inspector
