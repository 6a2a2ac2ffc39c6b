// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/row_settings.h"

#include "core/program/csv_writer.h"
#include "core/recording/same_bits.h"
#include "core/session/session.h"
#include "core/setup/tables.h"

#include <algorithm>

namespace inspector {

namespace {

/// Consecutive rows made under the same conditions; their times, s, in (begin, end].
struct Span {
    Conditions conditions;
    Level level;
    double begin;
    double end;
};

/// The spans of the steps [from, to) of a recording.
std::vector<Span> spansOf(const PlayableRecording &recording, uint64_t from, uint64_t to) {
    std::vector<Span> spans;
    double time = 0.0;
    for (size_t i = 0; i < recording.recording().segments.size(); ++i) {
        const Segment &segment = recording.segment(i);
        const double begin = segment.from ? segment.from->time : time;
        time = begin + double(segment.hashes.size()) * segment.conditions.dt;
        if (segment.hashes.empty() || recording.end(i) <= from || recording.begin(i) >= to) continue;
        spans.push_back({segment.conditions, recording.level(i), begin, time});
    }
    return spans;
}

/// The spans of the run whose samples are shown.
std::vector<Span> spansOf(Session &session) {
    if (session.isReplaying()) {
        const PlayableRecording &recording = session.recording();
        const uint64_t position = session.simulation().latest().replay.position;
        return spansOf(recording, recording.beginOfRun(position), position);
    }
    const RunPlace run = session.runPlace();
    const std::optional<Past> past = session.simulation().past(nullptr, run.begin, run.end);
    if (!past) return {};
    return spansOf(*past->recording, 0, past->recording->length());
}

bool isSameButForTilt(const Conditions &a, const Conditions &b) {
    const auto level = [](Inputs inputs) {
        inputs.tilt = {};
        inputs.params.gravity = {};
        return inputs;
    };
    return a.maze == b.maze && a.stepper == b.stepper && a.dt == b.dt && isSameBits(level(a.inputs), level(b.inputs));
}

QByteArray wordOf(const QByteArray &line) { return line.left(line.indexOf(' ')); }

class RowSettings {
public:
    RowSettings(Session &session, const std::vector<Span> &spans)
        : m_session(session) {
        const auto isTilted = [&](const Span &span) {
            return !(span.conditions.inputs.tilt == spans.front().conditions.inputs.tilt);
        };
        m_isTiltVaried = std::ranges::any_of(spans, isTilted);
    }

    /// Notes that the rows from `time` on were made under these conditions, beside this ghost.
    void note(const Span &span, uint64_t ghost, double time) {
        const QByteArrayList lines = linesOf(span, ghost);
        for (const QByteArray &line : lines)
            if (!m_lines.contains(line)) m_text += m_lines.isEmpty() ? line + '\n' : from(time) + line + '\n';
        for (const QByteArray &line : m_lines)
            if (!hasWord(lines, wordOf(line))) m_text += from(time) + "no " + wordOf(line) + '\n';
        m_lines = lines;
    }

    QByteArray text() const { return m_text; }

private:
    static QByteArray from(double time) { return "from " + QByteArray::number(time) + " s: "; }

    static bool hasWord(const QByteArrayList &lines, const QByteArray &word) {
        return std::ranges::any_of(lines, [&](const QByteArray &line) { return wordOf(line) == word; });
    }

    /// Omits what set the tilt: the tilts are in the table.
    QByteArrayList linesOf(const Span &span, uint64_t ghost) const {
        QByteArrayList lines = tableSettings(optionsOf(span, ghost)).trimmed().split('\n');
        lines.removeIf([this](const QByteArray &line) {
            return line.startsWith("autopilot ") || (m_isTiltVaried && line.startsWith("tilt_"));
        });
        if (m_isTiltVaried) lines += "tilt varies: columns tilt_x, tilt_y";
        return lines;
    }

    Options optionsOf(const Span &span, uint64_t ghost) const {
        Options options;
        options.registry = m_session.registry();
        options.level = span.level;
        options.stepper = span.conditions.stepper.id;
        options.dt = span.conditions.dt;
        options.settings = settingsOf(span.conditions, options.registry);
        if (const Comparison::Made *made = m_session.comparison().made(ghost)) {
            options.comparison = made->ghostChoice;
            options.comparisonSettings = made->own;
        }
        return options;
    }

    Session &m_session;
    bool m_isTiltVaried = false;
    QByteArrayList m_lines; ///< of the last rows
    QByteArray m_text;
};

} // namespace

QByteArray rowSettings(Session &session, double since) {
    const std::vector<Span> spans = spansOf(session);
    const SampleRing &samples = session.simulation().samples();
    RowSettings settings(session, spans);
    QByteArray earlier;
    const Span *noted = nullptr;
    size_t place = 0;
    uint64_t ghost = 0;
    Sample sample;
    for (uint64_t number = samples.find(since); !spans.empty() && number < samples.last(); ++number) {
        if (!samples.read(number, sample)) continue;
        const double half = 0.5 * spans[place].conditions.dt;
        if (sample.time < spans.front().begin + half) {
            earlier = "rows to " + QByteArray::number(sample.time) + " s: of the run that this one continues\n";
            continue;
        }
        while (place + 1 < spans.size() && sample.time > spans[place].end + 0.5 * spans[place + 1].conditions.dt)
            ++place;
        const Span &span = spans[place];
        if (noted && sample.ghost == ghost && isSameButForTilt(noted->conditions, span.conditions)) continue;
        settings.note(span, sample.ghost, sample.time);
        noted = &span;
        ghost = sample.ghost;
    }
    return settings.text() + earlier + spanOf(samples, since).toUtf8() + '\n';
}

} // namespace inspector
