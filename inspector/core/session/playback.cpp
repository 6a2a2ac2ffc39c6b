// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/playback.h"

#include <algorithm>
#include <utility>

namespace inspector {

Playback::Playback(Simulation &simulation, std::shared_ptr<const PlayableRecording> recording, uint64_t number,
                   uint64_t begin)
    : m_simulation(simulation)
    , m_recording(std::move(recording))
    , m_number(number)
    , m_sought(begin) {}

void Playback::seek(uint64_t position) {
    m_sought = position;
    m_seeks = m_simulation.seek(position);
}

bool Playback::showsSought(const Snapshot &now) const {
    return now.replay.number == m_number && now.replay.seeks >= m_seeks;
}

std::optional<ReplayPlace> Playback::place(const Snapshot &now) const {
    ReplayPlace place = now.replay;
    if (place.number != m_number) return std::nullopt;
    if (place.seeks < m_seeks) place.position = std::min(m_sought, place.end);
    return place;
}

bool Playback::follow(size_t segment) { return std::exchange(m_segment, segment) != segment; }

void Playback::noteDifference(const Difference &difference) {
    m_difference = inspector::verdict(*m_recording, {0, difference});
}

QString Playback::verdict(const Snapshot &now) const {
    const std::optional<ReplayPlace> place = this->place(now);
    if (!place) return {};
    if (!m_difference.isEmpty()) return m_difference;
    if (place->isChecked) return inspector::verdict(*m_recording, {place->checked, std::nullopt});
    return tr("same so far: %1 of %2 steps").arg(place->checked).arg(place->end);
}

} // namespace inspector
