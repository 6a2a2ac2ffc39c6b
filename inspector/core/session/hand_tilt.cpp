// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/hand_tilt.h"

#include <algorithm>
#include <iterator>

namespace inspector {

namespace {

/// Of the board, in x or y.
bool isOfTilt(const Setting &setting) { return setting.id.startsWith(QStringLiteral("tilt_")); }

} // namespace

HandTilt::HandTilt(Parameters &parameters)
    : m_parameters(parameters) {}

void HandTilt::releaseKeys() {
    m_control = {};
    m_isByKeys = false;
}

void HandTilt::advance(double seconds) {
    if (!m_isByKeys) {
        if (!m_control.keys().any()) return;
        m_isByKeys = true;
        m_control.setTilt(m_parameters.inputs().tilt); // start from the sliders' tilt
    }
    set(m_control.advance(seconds));
    m_isByKeys = !m_control.isAtRest();
}

void HandTilt::level() {
    releaseKeys();
    set({});
}

void HandTilt::takeOver(const std::vector<Setting> &taken, const std::vector<Setting> &before) {
    const auto isTilted = [](const Setting &setting) { return isOfTilt(setting) && setting.value != 0.0; };
    m_taken.clear();
    if (m_isByKeys || std::ranges::none_of(before, isTilted))
        std::ranges::copy_if(taken, std::back_inserter(m_taken), isOfTilt);
}

bool HandTilt::endTaken() {
    const bool isKept = !m_taken.empty() && differingFrom(m_parameters, m_taken).empty();
    m_taken.clear();
    return isKept;
}

void HandTilt::set(Tilt tilt) {
    m_parameters.set({{QStringLiteral("tilt_x"), degrees(tilt.x)}, {QStringLiteral("tilt_y"), degrees(tilt.y)}});
}

} // namespace inspector
