// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/recording_schedule.h"

#include "core/setup/lines.h"

#include <algorithm>

namespace inspector {

namespace {

using SegmentPlace = std::vector<Segment>::const_iterator;

/// The first segment with steps of the last run; the end if there is none.
SegmentPlace lastRun(const std::vector<Segment> &segments) {
    SegmentPlace result = segments.end();
    SegmentPlace begin = segments.begin();
    for (SegmentPlace place = segments.begin(); place != segments.end(); ++place) {
        if (place->from) begin = place;
        if (!place->hashes.empty()) result = begin;
    }
    return result;
}

/// The steps of a run follow each other without a gap; times are multiples of dt as long as dt stays the same.
TiltSchedule tiltsOf(SegmentPlace place, SegmentPlace end, double duration) {
    TiltSchedule result;
    double since = 0.0; // s, when this dt began
    uint64_t steps = 0; // made with this dt
    double dt = place->conditions.dt;
    do {
        const Conditions &now = place->conditions;
        if (now.dt != dt) {
            since += double(steps) * dt;
            steps = 0;
            dt = now.dt;
        }
        const double time = since + double(steps) * dt;
        const bool isNew = result.switches.empty() || !(result.switches.back().tilt == now.inputs.tilt);
        if (isNew && !place->hashes.empty() && time < duration) result.switches.push_back({time, now.inputs.tilt});
        steps += place->hashes.size();
        ++place;
    } while (place != end && !place->from);
    result.duration = std::min(duration, since + double(steps) * dt);
    return result;
}

} // namespace

TiltSchedule recordedSchedule(const QString &path, const Registry &registry, double duration, QString *error) {
    const std::optional<Recording> recording = readRecording(path, registry, error);
    if (!recording) return {};
    const SegmentPlace run = lastRun(recording->segments);
    if (run == recording->segments.end()) {
        *error = QStringLiteral("%1: expected steps, found none").arg(oneLine(path));
        return {};
    }
    TiltSchedule result = tiltsOf(run, recording->segments.end(), duration);
    result.name = path;
    return result;
}

} // namespace inspector
