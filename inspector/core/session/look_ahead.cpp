// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/look_ahead.h"

namespace inspector {

namespace {

constexpr int kOthers = 24;         ///< boards
constexpr uint64_t kOthersSeed = 1; ///< fixed, so that moving a slider doesn't resample them

} // namespace

LookAhead::LookAhead(const Registry &registry)
    : m_registry(registry)
    , m_wayFinder(registry)
    , m_unknowns(parseUnknowns(usualUnknowns(), nullptr).value_or(Unknowns())) {}

void LookAhead::show(bool isOn) {
    m_isShown = isOn;
    askAnew();
}

void LookAhead::showOthers(bool isOn) {
    m_showsOthers = isOn;
    askAnew();
}

void LookAhead::setUnknowns(const Unknowns &unknowns) {
    if (unknowns == m_unknowns) return;
    m_unknowns = unknowns;
    askAnew();
}

void LookAhead::askAnew() {
    m_askedFor = 0;
    m_way = {};
    ++m_updates;
}

std::vector<OtherBoard> LookAhead::otherBoards(const Snapshot &now) const {
    std::vector<OtherBoard> boards;
    if (!m_showsOthers || now.running || m_unknowns.empty()) return boards;
    for (const SampledBoard &board : sampleBoards(m_unknowns, now.inputs, kOthers, kOthersSeed)) {
        Inputs inputs{board.params, {}, board.gravity};
        tiltBoard(inputs, {now.inputs.tilt.x + board.tiltOffset.x, now.inputs.tilt.y + board.tiltOffset.y});
        boards.push_back({inputs.params, board.startOffset});
    }
    return boards;
}

void LookAhead::follow(const Snapshot &now, const Scene &scene) {
    if (!m_isShown) return;
    const uint64_t answers = m_wayFinder.answers();
    if (answers != m_updates) m_way = m_wayFinder.latest();
    m_updates = answers;
    if (now.current.flags & PHYS_OUT) m_way = {};
    const bool hasOthers = m_showsOthers && !now.running;
    const uint64_t moment = 2 * now.number + (hasOthers ? 1 : 0);
    if (moment == m_askedFor || (now.current.flags & PHYS_OUT)) return;
    m_askedFor = moment;
    m_wayFinder.ask(scene, now.current, now.inputs.params, otherBoards(now));
}

void LookAhead::computeAtOnce(const Snapshot &now, const Scene &scene) {
    if (!m_isShown) return;
    const Stepper exact = makeStepper(m_registry, "exact", scene, nullptr);
    const bool isAhead = exact && !(now.current.flags & PHYS_OUT);
    m_way = isAhead ? wayAhead(exact, now.current, now.inputs.params, otherBoards(now)) : WayAhead{};
}

} // namespace inspector
