// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/row_settings.h"

#include "core/program/csv_writer.h"
#include "core/program/run_settings.h"
#include "core/session/session.h"

namespace inspector {

namespace {

GhostSettings ghostSettings(Session &session, uint64_t ghost) {
    const Comparison::Made *made = session.comparison().made(ghost);
    return made ? GhostSettings{made->ghostChoice, made->own, made->met} : GhostSettings{};
}

} // namespace

QByteArray rowSettings(Session &session, double since) {
    const std::vector<SettingsSpan> spans = session.settingsSpans();
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
            earlier = "rows to " + QByteArray::number(sample.time) + " s: settings that are no longer kept\n";
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
