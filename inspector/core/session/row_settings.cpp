// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/row_settings.h"

#include "core/program/csv_writer.h"
#include "core/program/run_settings.h"
#include "core/session/session.h"

namespace inspector {

namespace {

/// The spans of the run whose samples are shown.
std::vector<SettingsSpan> spansOf(Session &session) {
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

GhostSettings ghostSettings(Session &session, uint64_t ghost) {
    const Comparison::Made *made = session.comparison().made(ghost);
    return made ? GhostSettings{made->ghostChoice, made->own} : GhostSettings{};
}

} // namespace

QByteArray rowSettings(Session &session, double since) {
    const std::vector<SettingsSpan> spans = spansOf(session);
    const SampleRing &samples = session.simulation().samples();
    RunSettings settings(session.registry(), spans);
    QByteArray earlier;
    const SettingsSpan *noted = nullptr;
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
        const SettingsSpan &span = spans[place];
        if (noted && sample.ghost == ghost && isSameButForTilt(noted->conditions, span.conditions)) continue;
        settings.note(span, ghostSettings(session, sample.ghost), sample.time);
        noted = &span;
        ghost = sample.ghost;
    }
    return settings.text() + earlier + spanOf(samples, since).toUtf8() + '\n';
}

} // namespace inspector
