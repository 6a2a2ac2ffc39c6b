// SPDX-License-Identifier: GPL-3.0-or-later
// What happened to the ball: the last events of a run, each with the step that made it.
#pragma once

#include "core/engine/engine.h"

#include <atomic>
#include <memory>
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

    bool isBounce() const { return event.kind == PHYS_EVENT_IMPACT || event.kind == PHYS_EVENT_LANDING; }
    bool isSlow() const; // a bounce, but no faster than that of a ball that leans on a wall
};

StepFacts factsOf(const Engine &engine, uint32_t stepper);

// One thread writes, any others read at the same time; nobody waits and nothing is allocated. The oldest entries are
// overwritten. The newest kReach may still grow by what is folded into them; all others stay as they are.
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
    // What is done between the two is seen by nobody before the second, and then all at once.
    void hold();
    void release();

    // Readers' side. Entries [first(), last()) can be read just now.
    size_t capacity() const { return m_capacity; }
    uint64_t first() const;
    uint64_t last() const { return m_last.load(std::memory_order_acquire); }
    uint64_t dropped() const; // entries of this run that were overwritten
    uint64_t lost() const {
        return m_lost.load(std::memory_order_acquire);
    } // events of this run that no step had room for
    // How often clear() was called: a reader that sees another number starts anew.
    uint64_t generation() const { return m_generation.load(std::memory_order_acquire); }
    // Another number after every change.
    uint64_t revision() const { return m_revision.load(std::memory_order_acquire); }

    // Entry `number`; false if it is gone, not there yet, or just being written: then it is there a moment later.
    bool read(uint64_t number, LoggedEvent &out) const;

private:
    static constexpr size_t kWords = sizeof(LoggedEvent) / sizeof(uint64_t);
    static_assert(sizeof(LoggedEvent) == kWords * sizeof(uint64_t) && std::is_trivially_copyable_v<LoggedEvent>);

    // The version is odd while the words are being written.
    struct Slot {
        std::atomic<uint64_t> version{0};
        std::atomic<uint64_t> words[kWords];
    };

    bool isOneMore(const LoggedEvent &entry, const phys_event &event, double dt) const;
    LoggedEvent *entryToGrow(const phys_event &event, double dt);
    void store(const LoggedEvent &entry);
    void announce();
    void show();

    // The writer's own: what there is to see once it isn't held back any more.
    struct Counts {
        uint64_t last = 0;    // entries begun
        uint64_t cleared = 0; // last at the last clear()
        uint64_t lost = 0;
        uint64_t generation = 0;
        uint64_t revision = 0;
    };

    size_t m_capacity;
    std::unique_ptr<Slot[]> m_slots;
    std::vector<LoggedEvent> m_newest; // the writer's own copies of the newest kReach
    Counts m_counts;
    bool m_isHeld = false;
    // What is seen.
    std::atomic<uint64_t> m_last{0};
    std::atomic<uint64_t> m_cleared{0};
    std::atomic<uint64_t> m_lost{0};
    std::atomic<uint64_t> m_generation{0};
    std::atomic<uint64_t> m_revision{0};
};

} // namespace inspector
