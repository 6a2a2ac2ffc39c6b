// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/live_uncertainty.h"

#include <cmath>
#include <limits>
#include <utility>

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
    m_noted.clear();
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
    m_end = met.time + LiveBand::kReach;
    m_open.reset();
    m_noted.clear();
    m_next = samples.find(std::nextafter(m_time, std::numeric_limits<double>::infinity()));
    m_band.begin({scene, met, m_unknowns});
    Sample first;
    return !samples.read(m_next, first) || first.step == met.step + 1;
}

/// Longer segments are split anyway.
void LiveUncertainty::take(const Sample &sample, const Inputs &inputs) {
    constexpr double kLongest = 0.05; // s
    const double length = sample.time - m_time;
    m_time = sample.time;
    const bool goesOn = m_open && m_open->length < kLongest && isSameTilt(m_open->inputs, sample);
    if (m_open && !goesOn) m_noted.push_back(*m_open);
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
    Sample sample;
    for (const uint64_t last = samples.last(); m_isWhole && m_next < last; ++m_next) {
        m_isWhole = samples.read(m_next, sample);
        if (m_isWhole && sample.time > m_time && m_time < m_end) take(sample, now.inputs);
    }
}

void LiveUncertainty::computeNoted() {
    if (!m_noted.empty()) m_band.goOn(std::exchange(m_noted, {}));
}

std::shared_ptr<const Band> LiveUncertainty::band() {
    computeNoted();
    return m_band.latest();
}

void LiveUncertainty::finish() {
    computeNoted();
    if (m_open) m_band.goOn({*m_open});
    m_open.reset();
    m_band.finish();
}

} // namespace inspector
