// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/events/event_log.h"

#include "core/events/counted_impact.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace inspector {

namespace {

double speedOf(const phys_state &state) {
    const phys_vec3 &v = state.velocity;
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

bool isSlowEnough(const phys_event &event) { return std::abs(event.speed_before) < kCountedImpact; }

bool isBounce(const phys_event &event) { return event.kind == PHYS_EVENT_IMPACT || event.kind == PHYS_EVENT_LANDING; }

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
    facts.stepper = stepper;
    facts.eventCount = report.event_count + report.events_lost;
    return facts;
}

EventLog::EventLog(size_t capacity)
    : m_capacity(std::bit_ceil(std::max(capacity, size_t(2 * kReach))))
    , m_slots(std::make_unique<Slot[]>(m_capacity))
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
        store(*entry);
        return announce();
    }
    const uint64_t number = m_counts.last;
    LoggedEvent &entry = m_newest[number % kReach];
    entry = {number, event, 1, event.time, std::abs(event.speed_before), step};
    store(entry);
    m_counts.last = number + 1;
    announce();
}

bool EventLog::isOneMore(const LoggedEvent &entry, const phys_event &event, double dt) const {
    if (isBounce(event) && !(isSlowEnough(event) && entry.isSlow())) return false;
    return event.time - entry.until <= std::max(kFoldTime, 2.0 * dt);
}

// The newest entry of the same kind and box decides: after a fast impact a new row of slow ones begins.
LoggedEvent *EventLog::entryToGrow(const phys_event &event, double dt) {
    const uint64_t end = m_counts.last;
    const uint64_t begin = std::max(m_counts.cleared, end > kReach ? end - kReach : 0);
    for (uint64_t number = end; number-- > begin;) {
        LoggedEvent &entry = m_newest[number % kReach];
        if (entry.event.kind != event.kind || entry.event.box != event.box) continue;
        return isOneMore(entry, event, dt) ? &entry : nullptr;
    }
    return nullptr;
}

// A reader that meets a new word then also sees that the version has moved on: release and acquire on each word, which
// cost nothing extra on x86 and ARM64.
void EventLog::store(const LoggedEvent &entry) {
    uint64_t words[kWords];
    std::memcpy(words, &entry, sizeof words);
    Slot &slot = m_slots[entry.number % m_capacity];
    const uint64_t version = slot.version.load(std::memory_order_relaxed);
    slot.version.store(version + 1, std::memory_order_relaxed);
    for (size_t i = 0; i < kWords; ++i) slot.words[i].store(words[i], std::memory_order_release);
    slot.version.store(version + 2, std::memory_order_release);
}

void EventLog::announce() {
    ++m_counts.revision;
    if (!m_isHeld) show();
}

// First what is gone, then what is new: entries from before and after a clear() are never seen together.
void EventLog::show() {
    m_cleared.store(m_counts.cleared, std::memory_order_release);
    m_last.store(m_counts.last, std::memory_order_release);
    m_lost.store(m_counts.lost, std::memory_order_release);
    m_generation.store(m_counts.generation, std::memory_order_release);
    m_revision.store(m_counts.revision, std::memory_order_release);
}

void EventLog::hold() { m_isHeld = true; }

void EventLog::release() {
    m_isHeld = false;
    show();
}

void EventLog::noteLost(uint64_t count) {
    m_counts.lost += count;
    announce();
}

void EventLog::clear() {
    m_counts.cleared = m_counts.last;
    m_counts.lost = 0;
    ++m_counts.generation;
    announce();
}

uint64_t EventLog::first() const {
    const uint64_t end = last();
    const uint64_t oldest = end > m_capacity ? end - m_capacity : 0;
    return std::max(oldest, m_cleared.load(std::memory_order_acquire));
}

uint64_t EventLog::dropped() const {
    const uint64_t cleared = m_cleared.load(std::memory_order_acquire);
    return std::max(first(), cleared) - cleared;
}

bool EventLog::read(uint64_t number, LoggedEvent &out) const {
    if (number < first() || number >= last()) return false;
    const Slot &slot = m_slots[number % m_capacity];
    const uint64_t version = slot.version.load(std::memory_order_acquire);
    uint64_t words[kWords];
    for (size_t i = 0; i < kWords; ++i) words[i] = slot.words[i].load(std::memory_order_acquire);
    if (version % 2 != 0 || slot.version.load(std::memory_order_relaxed) != version) return false;
    LoggedEvent entry;
    std::memcpy(&entry, words, sizeof entry);
    if (entry.number != number) return false; // overwritten meanwhile
    out = entry;
    return true;
}

} // namespace inspector
