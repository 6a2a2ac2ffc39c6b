// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/run_settings.h"

#include "core/program/csv_writer.h"
#include "core/recording/replay.h"
#include "core/recording/same_bits.h"
#include "core/setup/tables.h"

#include <algorithm>
#include <utility>

namespace inspector {

namespace {

QByteArray from(double time) { return "from " + QByteArray::number(time) + " s: "; }

QByteArray wordOf(const QByteArray &line) { return line.left(line.indexOf(' ')); }

bool hasWord(const QByteArrayList &lines, const QByteArray &word) {
    return std::ranges::any_of(lines, [&](const QByteArray &line) { return wordOf(line) == word; });
}

} // namespace

std::vector<SettingsSpan> spansOf(const PlayableRecording &recording, uint64_t from, uint64_t to) {
    std::vector<SettingsSpan> spans;
    double time = 0.0;
    for (size_t i = 0; i < recording.recording().segments.size(); ++i) {
        const Segment &segment = recording.segment(i);
        const double begin = segment.from ? segment.from->time : time;
        const uint64_t end = std::clamp(to, recording.begin(i), recording.end(i));
        time = begin + double(end - recording.begin(i)) * segment.conditions.dt;
        if (segment.hashes.empty() || recording.end(i) <= from || recording.begin(i) >= to) continue;
        spans.push_back({segment.conditions, recording.level(i), begin, time, segment.from.has_value()});
    }
    return spans;
}

std::vector<SettingsSpan> joined(std::vector<SettingsSpan> earlier, const std::vector<SettingsSpan> &run) {
    if (run.empty()) return earlier;
    const double begin = run.front().begin;
    std::erase_if(earlier, [&](const SettingsSpan &span) { return span.begin >= begin - 0.5 * span.conditions.dt; });
    const bool isContinued = !earlier.empty();
    if (isContinued) earlier.back().end = std::min(earlier.back().end, begin);
    const size_t place = earlier.size();
    earlier.insert(earlier.end(), run.begin(), run.end());
    if (isContinued) earlier[place].beginsRun = false;
    return earlier;
}

bool isSameButForTilt(const Conditions &a, const Conditions &b) {
    const auto level = [](Inputs inputs) {
        inputs.tilt = {};
        inputs.params.gravity = {};
        return inputs;
    };
    return a.maze == b.maze && a.stepper == b.stepper && a.dt == b.dt && isSameBits(level(a.inputs), level(b.inputs));
}

RunSettings::RunSettings(Registry registry, const std::vector<SettingsSpan> &spans)
    : m_registry(std::move(registry)) {
    m_isTiltVaried = std::ranges::any_of(spans, [&](const SettingsSpan &span) {
        return !(span.conditions.inputs.tilt == spans.front().conditions.inputs.tilt);
    });
}

void RunSettings::note(const SettingsSpan &span, const GhostSettings &ghost, double time) {
    const QByteArrayList lines = linesOf(span, ghost);
    if (span.beginsRun && m_runs++ > 0)
        m_text += "run " + QByteArray::number(m_runs) + ": rows from " + QByteArray::number(time) + " s\n";
    for (const QByteArray &line : lines)
        if (!m_lines.contains(line)) m_text += m_lines.isEmpty() ? line + '\n' : from(time) + line + '\n';
    for (const QByteArray &line : m_lines)
        if (!hasWord(lines, wordOf(line))) m_text += from(time) + "no " + wordOf(line) + '\n';
    if (m_met != 0 && ghost.met != 0 && ghost.met != m_met) m_text += from(time) + "compare starts anew at the ball\n";
    m_met = ghost.met;
    m_lines = lines;
}

/// Omits what set the tilt: the tilts are in the table.
QByteArrayList RunSettings::linesOf(const SettingsSpan &span, const GhostSettings &ghost) const {
    const QByteArray settings = tableSettings(optionsOf(span, ghost));
    QByteArrayList lines = (m_isTiltVaried ? withVariedTilt(settings) : settings).trimmed().split('\n');
    lines.removeIf([](const QByteArray &line) { return line.startsWith("autopilot "); });
    return lines;
}

Options RunSettings::optionsOf(const SettingsSpan &span, const GhostSettings &ghost) const {
    Options options;
    options.registry = m_registry;
    options.level = span.level;
    options.stepper = span.conditions.stepper.id;
    options.dt = span.conditions.dt;
    options.settings = settingsOf(span.conditions, m_registry);
    options.comparison = ghost.ghostChoice;
    options.comparisonSettings = ghost.own;
    return options;
}

QByteArray recordingSettings(const PlayableRecording &recording) {
    const std::vector<SettingsSpan> spans = spansOf(recording, 0, recording.length());
    RunSettings settings(recording.registry(), spans);
    const SettingsSpan *noted = nullptr;
    for (const SettingsSpan &span : spans) {
        if (noted && !span.beginsRun && isSameButForTilt(noted->conditions, span.conditions)) continue;
        settings.note(span, {}, span.begin + span.conditions.dt);
        noted = &span;
    }
    return settings.text();
}

} // namespace inspector
