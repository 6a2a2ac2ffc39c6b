// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/live_uncertainty.h"

#include <cmath>
#include <limits>

namespace inspector {

namespace {

Tilt tiltOf(const Sample &sample) { return {radians(sample[Channel::TiltX]), radians(sample[Channel::TiltY])}; }

bool isSameTilt(const Inputs &inputs, const Sample &sample) { return inputs.tilt == tiltOf(sample); }

} // namespace

bool LiveUncertainty::isOfBand(const Snapshot &now, const Scene &scene, const Unknowns &unknowns) const {
    return scene == m_scene && now.ghost->meetings == m_meetings && unknowns == m_unknowns;
}

void LiveUncertainty::end() {
    if (!m_scene) return;
    m_scene.reset();
    m_open.reset();
    m_band.end();
}

/// Begins at the first step after ball and ghost started; false if the ring no longer has it.
bool LiveUncertainty::begin(const Snapshot &now, const SampleRing &samples, const Scene &scene,
                            const Unknowns &unknowns) {
    m_scene = scene;
    m_meetings = now.ghost->meetings;
    m_unknowns = unknowns;
    const phys_state &met = now.ghost->met;
    m_time = met.time;
    m_open.reset();
    m_next = samples.find(std::nextafter(m_time, std::numeric_limits<double>::infinity()));
    m_band.begin({scene, met, m_unknowns});
    Sample first;
    return !samples.read(m_next, first) || first.step == met.step + 1;
}

/// Longer segments are split anyway.
void LiveUncertainty::take(const Sample &sample, const Inputs &inputs, std::vector<LiveBand::Segment> &segments) {
    constexpr double kLongest = 0.05; // s
    const double length = sample.time - m_time;
    m_time = sample.time;
    const bool goesOn = m_open && m_open->length < kLongest && isSameTilt(m_open->inputs, sample);
    if (m_open && !goesOn) segments.push_back(*m_open);
    if (!goesOn) {
        m_open = LiveBand::Segment{inputs, 0.0};
        m_open->inputs.tilt = tiltOf(sample);
    }
    m_open->length += length;
}

void LiveUncertainty::follow(const Snapshot &now, const SampleRing &samples, const Scene &scene,
                             const Unknowns &unknowns) {
    if (unknowns.empty() || !now.ghost) return end();
    if (!isOfBand(now, scene, unknowns)) m_isWhole = begin(now, samples, scene, unknowns);
    std::vector<LiveBand::Segment> segments;
    Sample sample;
    for (const uint64_t last = samples.last(); m_isWhole && m_next < last; ++m_next) {
        m_isWhole = samples.read(m_next, sample);
        if (m_isWhole && sample.time > m_time) take(sample, now.inputs, segments);
    }
    if (!segments.empty()) m_band.goOn(segments);
}

void LiveUncertainty::finish() {
    if (m_open) m_band.goOn({*m_open});
    m_open.reset();
    m_band.finish();
}

} // namespace inspector
