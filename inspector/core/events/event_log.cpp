// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/events/event_log.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

double speedOf(const phys_state &state) {
    const phys_vec3 &v = state.velocity;
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

bool isSlowEnough(const phys_event &event) { return std::abs(event.speed_before) < kCountedImpact; }

phys_event leftMaze(const StepFacts &step) {
    phys_event event{};
    event.time = step.after.time;
    event.point = step.after.position;
    event.speed_before = speedOf(step.before);
    event.speed_after = speedOf(step.after);
    event.kind = kLeftMazeEvent;
    event.box = PHYS_NO_BOX;
    return event;
}

} // namespace

bool LoggedEvent::isSlow() const { return isBounce() && isSlowEnough(event); }

StepFacts factsOf(const Engine &engine, uint32_t stepper) {
    const phys_report &report = engine.report();
    StepFacts facts;
    facts.before = engine.previous();
    facts.after = engine.state();
    facts.params = engine.inputs().params;
    facts.dt = engine.dt();
    facts.penetration = report.penetration;
    if (!engine.events().empty()) facts.firstEvent = engine.events().front().time;
    facts.stepper = stepper;
    facts.eventCount = report.event_count + report.events_lost;
    return facts;
}

EventLog::EventLog(size_t capacity)
    : m_entries(std::max(capacity, size_t(2 * kReach)))
    , m_newest(kReach) {}

void EventLog::note(const Engine &engine, uint32_t stepper) {
    const bool hasLeft = (engine.state().flags & PHYS_OUT) && !(engine.previous().flags & PHYS_OUT);
    const uint32_t lost = engine.report().events_lost;
    if (engine.events().empty() && lost == 0 && !hasLeft) return;
    const StepFacts step = factsOf(engine, stepper);
    for (const phys_event &event : engine.events()) append(event, step);
    if (hasLeft) append(leftMaze(step), step);
    if (lost > 0) noteLost(lost);
}

void EventLog::append(const phys_event &event, const StepFacts &step) {
    if (LoggedEvent *entry = entryToGrow(event, step.dt)) {
        ++entry->count;
        entry->until = event.time;
        entry->fastest = std::max(entry->fastest, std::abs(event.speed_before));
        m_entries.rewrite(entry->number, *entry);
    } else {
        const uint64_t number = m_entries.written();
        LoggedEvent &newest = m_newest[number % kReach];
        newest = {number, event, 1, event.time, std::abs(event.speed_before), step};
        m_entries.append(newest);
    }
    announce();
}

bool EventLog::isOneMore(const LoggedEvent &entry, const phys_event &event, double dt) const {
    if (isBounce(event) && !(isSlowEnough(event) && entry.isSlow())) return false;
    return event.time - entry.until <= std::max(kFoldTime, 2.0 * dt);
}

/// Only the newest entry of the same kind and box is considered: slow impacts after a fast one begin a new entry.
LoggedEvent *EventLog::entryToGrow(const phys_event &event, double dt) {
    const uint64_t end = m_entries.written();
    const uint64_t begin = std::max(m_entries.cleared(), end > kReach ? end - kReach : 0);
    for (uint64_t number = end; number-- > begin;) {
        LoggedEvent &entry = m_newest[number % kReach];
        if (entry.event.kind != event.kind || entry.event.box != event.box) continue;
        return isOneMore(entry, event, dt) ? &entry : nullptr;
    }
    return nullptr;
}

void EventLog::announce() {
    ++m_changes;
    if (!m_entries.isHeld()) show();
}

void EventLog::show() {
    m_lost.store(m_lostCount, std::memory_order_release);
    m_revision.store(m_changes, std::memory_order_release);
}

void EventLog::release() {
    m_entries.release();
    show();
}

void EventLog::noteLost(uint64_t count) {
    m_lostCount += count;
    announce();
}

void EventLog::clear() {
    m_entries.clear();
    m_lostCount = 0;
    announce();
}

/// Entries that began earlier also lose what was folded into them after `time`.
void EventLog::forgetAfter(double time) {
    uint64_t number = m_entries.written();
    LoggedEvent entry;
    while (number > m_entries.cleared() && m_entries.readOwn(number - 1, entry) && entry.event.time > time) --number;
    m_entries.truncate(number);
    for (uint64_t kept = number; kept-- > m_entries.cleared() && number - kept <= kReach;)
        if (m_entries.readOwn(kept, entry)) m_newest[kept % kReach] = entry;
    announce();
}

} // namespace inspector
