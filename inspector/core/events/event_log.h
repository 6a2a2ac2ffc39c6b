// SPDX-License-Identifier: GPL-3.0-or-later
// What happened to the ball: the last events of a run, each with the step that made it.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/slot_ring.h"
#include "core/events/bounce.h"

#include <atomic>
#include <vector>

namespace inspector {

// A kind beside the library's PHYS_EVENT_*: the centre has left the bounds of all boxes.
inline constexpr uint32_t kLeftMazeEvent = 0x10000;

// What was in force when something happened.
struct StepFacts {
    phys_state before{}; // of the step
    phys_state after{};
    phys_params params{};
    double dt = 0.0;               // s
    double penetration = 0.0;      // deepest of the step, before it was resolved, m
    double firstEvent = 0.0;       // time of the step's first event, s
    uint32_t stepper = kNoStepper; // index in the registry
    uint32_t eventCount = 0;       // in this step, lost ones included
};

// An impact or a landing is slow below kCountedImpact. Slow ones on one box that follow each other are one entry: the
// first of them, and how many there were. So are repeated events without a normal speed.
struct LoggedEvent {
    uint64_t number = 0; // counts entries from 0 for ever
    phys_event event{};
    uint64_t count = 0;   // events that this entry stands for
    double until = 0.0;   // time of the last of them, s
    double fastest = 0.0; // largest speed before, of all of them, m/s
    StepFacts step;       // of the first

    bool isBounce() const { return inspector::isBounce(event); }
    bool isSlow() const; // a bounce, but no faster than that of a ball that leans on a wall
};

StepFacts factsOf(const Engine &engine, uint32_t stepper);

// One thread writes, any others read at the same time, as SlotRing says. The newest kReach entries may still grow by
// what is folded into them; all others stay as they are.
class EventLog {
public:
    static constexpr size_t kDefaultCapacity = 4096;
    static constexpr uint64_t kReach = 32;
    // s between two slow impacts that are folded; or two steps, if those are longer
    static constexpr double kFoldTime = 0.1;

    // capacity: rounded up to a power of two, at least 2 kReach.
    explicit EventLog(size_t capacity = kDefaultCapacity);

    // Writer's side. All events of the engine's last step; stepper: index in the registry, or kNoStepper.
    void note(const Engine &engine, uint32_t stepper);
    void append(const phys_event &event, const StepFacts &step);
    void noteLost(uint64_t count);
    void clear();
    // Takes back what came after `time`, s.
    void forgetAfter(double time);
    void hold() { m_entries.hold(); }
    void release();

    // Readers' side. Entries [first(), last()) can be read just now.
    size_t capacity() const { return m_entries.capacity(); }
    uint64_t first() const { return m_entries.first(); }
    uint64_t last() const { return m_entries.last(); }
    uint64_t dropped() const { return first() - m_entries.firstOfGeneration(); } // of this run, overwritten
    uint64_t lost() const { return m_lost.load(std::memory_order_acquire); } // of this run, that no step had room for
    // Another one: start anew.
    uint64_t generation() const { return m_entries.generation() + m_entries.truncations(); }
    // Another number after every change.
    uint64_t revision() const { return m_revision.load(std::memory_order_acquire); }
    // Entry `number`; false if it is gone, not there yet, or just being written: then it is there a moment later.
    bool read(uint64_t number, LoggedEvent &out) const { return m_entries.read(number, out); }

private:
    bool isOneMore(const LoggedEvent &entry, const phys_event &event, double dt) const;
    LoggedEvent *entryToGrow(const phys_event &event, double dt);
    void announce();
    void show();

    SlotRing<LoggedEvent> m_entries;
    std::vector<LoggedEvent> m_newest; // the writer's own copies of the newest kReach
    uint64_t m_lostCount = 0;          // the writer's own, too
    uint64_t m_changes = 0;
    std::atomic<uint64_t> m_lost{0}; // as seen
    std::atomic<uint64_t> m_revision{0};
};

} // namespace inspector
